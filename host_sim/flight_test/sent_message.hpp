/// The message by which a bus states a signal: as the generated logs send it, else as the standard's table has it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bus/canaerospace/bus_settings.hpp"
#include "host_sim/flight_log/message_schedule.hpp"

namespace tedavis::host_sim {

/// Of all frames that are made here: the node that sends them, and the time from one to the next, 125 bits at 1 Mbit/s.
inline constexpr std::uint8_t kMadeFrameNode = 9;
inline constexpr base::Duration kMadeFrameTime{125'000};

/// Of bus::PhaseOrigin, in the order of its values.
[[nodiscard]] const std::vector<std::string>& phase_origin_names();

/// `identifier` is the bus's own, also of guidance. Nothing where the bus carries no such signal.
[[nodiscard]] std::optional<ScheduledMessage> sent_message(flight::Signal signal, const bus::BusSettings& bus);

}  // namespace tedavis::host_sim
