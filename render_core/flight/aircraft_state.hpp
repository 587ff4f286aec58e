/// The known state of the own aircraft and of other aircraft at one instant. Plain data: assembled by bus/state or a test, read
/// by the display.
#pragma once

#include <array>
#include <type_traits>

#include "render_core/base/stamped.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/flight/attitude_excursion.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/flight/signal.hpp"
#include "render_core/flight/traffic.hpp"

namespace tedavis::flight {

/// The own ship's position estimated for exactly `at`, from stamped positions and velocities.
struct OwnShipEstimate {
    earth::Geodetic position;
    double velocity_north_mps = 0;
    double velocity_east_mps = 0;
    double velocity_up_mps = 0;
    base::Time at;
    base::SignalState state = base::SignalState::missing;  ///< stale while held beyond the extrapolation limit
    bool height_is_geometric = false;                      ///< true: above the ellipsoid; false: above MSL, from pressure
    bool height_is_on_qnh = false;  ///< true: a pressure height on the altimeter setting; false: on the standard setting
};

struct AircraftState {
    std::array<base::Stamped<double>, kSignalCount> signals{};
    std::array<base::FreshnessLimits, kSignalCount> limits{};
    OwnShipEstimate own_ship;
    AttitudeExcursion excursion;  ///< before the latest pitch and roll; 0 where no history is known
    UtcEstimate utc;
    Traffic traffic;
    bool is_posed = false;  ///< a pose was stated instead of a flight: missing signals have not failed

    [[nodiscard]] const base::Stamped<double>& operator[](Signal signal) const {
        return signals[static_cast<std::size_t>(signal)];
    }
    [[nodiscard]] base::Stamped<double>& operator[](Signal signal) { return signals[static_cast<std::size_t>(signal)]; }
    [[nodiscard]] base::SignalState state_of(Signal signal, base::Time now) const {
        const auto index = static_cast<std::size_t>(signal);
        return signals[index].state(now, limits[index]);
    }
    [[nodiscard]] bool is_valid(Signal signal, base::Time now) const { return state_of(signal, now) == base::SignalState::valid; }
};
static_assert(std::is_trivially_copyable_v<AircraftState>);

}  // namespace tedavis::flight
