/// libFuzzer entry: any bytes as a candump log. What is read as a frame must be writable, and be read again as itself.
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"

namespace {

using namespace tedavis::bus;

void check_round_trip(const CanFrame& frame) {
    char text[kMaxCandumpLine];
    CanFrame again;
    const std::size_t size = format_candump_line(frame, "can0", StampDigits::nano, true, text);
    if (size == 0 || parse_candump_line({text, size - 1}, again).kind != LineKind::frame) std::abort();
    if (again.id != frame.id || again.data != frame.data || again.time != frame.time || again.kind != frame.kind) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const void* plain = bytes;
    CandumpLogSource source(tedavis::base::Span<const char>(static_cast<const char*>(plain), size));
    static StateAssembler assembler;
    BusSettings settings;
    settings.traffic.first_identifier = 1840;
    settings.guidance.first_identifier = 1832;
    assembler = StateAssembler(settings);
    CanFrame frame;
    while (source.read({std::numeric_limits<std::int64_t>::max()}, {&frame, 1}) == 1) {
        check_round_trip(frame);
        assembler.feed({&frame, 1});
    }
    (void)assembler.snapshot(source.position().newest);
    return 0;
}
