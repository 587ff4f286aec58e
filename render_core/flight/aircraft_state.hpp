/// What is known on board of the own aircraft and of others at one instant. Plain data: assembled by bus/state (or a test), read
/// by the display.
#pragma once

#include <array>
#include <type_traits>

#include "render_core/base/stamped.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/flight/flight_time.hpp"
#include "render_core/flight/signal.hpp"
#include "render_core/flight/traffic.hpp"

namespace tedavis::flight {

/// The own ship's position estimated for exactly `at`, from stamped positions and velocities on the source's time.
struct OwnShipEstimate {
    earth::Geodetic position;
    double velocity_north_mps = 0;
    double velocity_east_mps = 0;
    double velocity_up_mps = 0;
    base::Time at;
    base::SignalState state = base::SignalState::missing;  ///< stale while held beyond the extrapolation limit
    bool height_is_geometric = false;                      ///< above the ellipsoid; else above MSL, from pressure
    bool height_is_on_qnh = false;  ///< from the altitude on the altimeter's setting; else from the standard one
};

struct AircraftState {
    std::array<base::Stamped<double>, kSignalCount> signals{};
    std::array<base::FreshnessLimits, kSignalCount> limits{};
    OwnShipEstimate own_ship;
    UtcEstimate utc;
    Traffic traffic;
    bool is_posed = false;  ///< somebody states a place, nobody flies: signals that are missing have not failed

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
