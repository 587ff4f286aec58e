/// The identification service (CANaerospace 1.7 section 4, IDS): the one service that every node has to answer.
#pragma once

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/frame/can_frame.hpp"

namespace tedavis::bus {

struct IdentificationAnswer {
    CanFrame frame;
    bool due = false;  ///< false: not a request, not for this node, or this node is a passive listener
};

/// Pure function. A request (identifier 128 on channel 0, NODATA, service code 0, addressed to this node or to all) is answered
/// on 129 with UCHAR4 {hardware revision, software revision, 0 standard distribution, 0 standard header}. The standard requires
/// the answer within 100 ms. The answer carries the request's time.
[[nodiscard]] IdentificationAnswer answer_identification(const CanFrame& request, const NodeSettings& node) noexcept;

}  // namespace tedavis::bus
