#include "bus/canaerospace/identification_service.hpp"

#include "bus/canaerospace/data_type.hpp"
#include "bus/canaerospace/message_header.hpp"

namespace tedavis::bus {
namespace {

constexpr std::uint16_t kRequest = 128;
constexpr std::uint16_t kResponse = 129;

}  // namespace

IdentificationAnswer answer_identification(const CanFrame& request, const NodeSettings& node) noexcept {
    const MessageId id = message_id(request.id, request.extended);
    const bool readable = request.kind == FrameKind::data && request.length >= kMessageHeaderBytes && id.valid;
    if (!node.answer_identification || !readable || id.identifier != kRequest || id.channel != 0) return {};
    const MessageHeader asked = read_header(request);
    const bool for_us = asked.node == 0 || asked.node == node.node;
    if (!for_us || asked.data_type != static_cast<std::uint8_t>(DataType::nodata) || asked.service_code != 0) return {};
    IdentificationAnswer answer;
    answer.due = true;
    answer.frame.time = request.time;
    answer.frame.channel = request.channel;
    set_message_id(answer.frame, kResponse, 0);
    write_header(answer.frame, {node.node, static_cast<std::uint8_t>(DataType::uchar8x4), 0, asked.message_code});
    const TypedValue identity{DataType::uchar8x4, 4, 0, {node.hardware_revision, node.software_revision, 0, 0}};
    answer.frame.length =
        static_cast<std::uint8_t>(kMessageHeaderBytes + encode_value(identity, answer.frame.data.data() + kMessageHeaderBytes));
    return answer;
}

}  // namespace tedavis::bus
