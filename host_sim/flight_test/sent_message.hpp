/// The message in which a bus sends a signal: as generated logs send it, else as in the table of the CANaerospace standard.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bus/canaerospace/bus_settings.hpp"
#include "host_sim/flight_log/message_schedule.hpp"

namespace tedavis::host_sim {

/// Node number of all generated frames, and the time between two of them, which is that of 125 bits at 1 Mbit/s.
inline constexpr std::uint8_t kMadeFrameNode = 9;
inline constexpr base::Duration kMadeFrameTime{125'000};

/// Names of the values of bus::PhaseOrigin, in their order.
[[nodiscard]] const std::vector<std::string>& phase_origin_names();

/// Returns the message with the bus's own identifier, also for guidance; nothing where the bus has no message for the signal.
[[nodiscard]] std::optional<ScheduledMessage> sent_message(flight::Signal signal, const bus::BusSettings& bus);

}  // namespace tedavis::host_sim
