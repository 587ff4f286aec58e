/// The message by which a bus states a signal: as the generated logs send it, else as the standard's table has it.
#pragma once

#include <optional>

#include "bus/canaerospace/bus_settings.hpp"
#include "host_sim/flight_log/message_schedule.hpp"

namespace tedavis::host_sim {

/// `identifier` is the bus's own, also of guidance. Nothing where the bus carries no such signal.
[[nodiscard]] std::optional<ScheduledMessage> sent_message(flight::Signal signal, const bus::BusSettings& bus);

}  // namespace tedavis::host_sim
