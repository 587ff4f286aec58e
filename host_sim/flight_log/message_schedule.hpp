/// The signals of a generated log, with their CANaerospace messages and rates.
///
/// Rates of slow signals are those of the transmission schedule of CANaerospace 1.7 (section 6.2). Attitude is sent 50 times a
/// second instead of 80, a difference that is not visible at the display's frame rate.
#pragma once

#include <cstdint>

#include "bus/canaerospace/data_type.hpp"
#include "render_core/base/span.hpp"
#include "render_core/flight/signal.hpp"

namespace tedavis::host_sim {

struct ScheduledMessage {
    std::uint16_t identifier;  ///< of guidance: offset from the bus file's first identifier of guidance
    flight::Signal signal;
    bus::DataType type;
    std::uint16_t period_ms;
    std::uint16_t offset_ms;  ///< within the period, so that messages of the same rate are spread
    bool is_guidance = false;
};

[[nodiscard]] base::Span<const ScheduledMessage> message_schedule() noexcept;

}  // namespace tedavis::host_sim
