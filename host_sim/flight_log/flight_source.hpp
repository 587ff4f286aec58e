/// Interface to a flight with signals at any time: a resampled recording or a scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/flight_log/signal_sample.hpp"
#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/traffic.hpp"

namespace tedavis::host_sim {

/// Another aircraft, as a receiver on board reports it.
struct ReceivedAircraft {
    std::uint8_t number = 0;  ///< number that the receiver has given it
    flight::TrafficReport report;
};

class FlightSource {
public:
    virtual ~FlightSource() = default;
    [[nodiscard]] virtual base::Time begin() const = 0;
    [[nodiscard]] virtual base::Time end() const = 0;
    /// The signals at `time`; nothing where the flight has a gap or has not begun or is over.
    [[nodiscard]] virtual std::optional<SignalSample> at(base::Time time) const = 0;
    /// The phase that the aircraft's own system states on the bus; nothing while it is silent.
    [[nodiscard]] virtual std::optional<flight::FlightPhase> stated_phase(base::Time) const { return std::nullopt; }
    /// Whether the aircraft states the pilot's selections; an absent value then means that nothing is selected.
    [[nodiscard]] virtual bool states_guidance() const { return false; }
    /// Other aircraft that are received at `time`.
    [[nodiscard]] virtual std::vector<ReceivedAircraft> traffic(base::Time) const { return {}; }
};

}  // namespace tedavis::host_sim
