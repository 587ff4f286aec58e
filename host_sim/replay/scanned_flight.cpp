#include "host_sim/replay/scanned_flight.hpp"

#include <algorithm>
#include <limits>

#include "host_sim/geoid_below.hpp"
#include "render_core/flight/flight_time.hpp"

namespace tedavis::host_sim {
namespace {

class NoTerrainBelow final : public flight::TerrainHeights {
public:
    base::Stamped<double> height_above_terrain(const flight::OwnShipEstimate&, base::Time) override { return {}; }
};

IndexPolicy without_kept_index() {
    IndexPolicy policy;
    policy.smallest_kept_log = std::numeric_limits<std::uint64_t>::max();  // it belongs to the runs over their terrain
    return policy;
}

base::Duration scan_step(const ScannedFlight& flight) {
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    const std::int64_t seconds = (flight.last - flight.first).ns / kSecond_ns;
    return {kSecond_ns * (seconds / static_cast<std::int64_t>(kMaxScannedPlaces) + 1)};
}

double ellipsoid_height_m(const flight::OwnShipEstimate& own_ship, GeoidBelow& geoid) {
    const earth::Geodetic& at = own_ship.position;
    return own_ship.height_is_geometric ? at.height.m : at.height.m + geoid.at(at.latitude_rad, at.longitude_rad).m;
}

}  // namespace

ScannedFlight scan_flight(const PlayerFiles& files, Console& console) {
    NoTerrainBelow no_terrain;
    FlightPlayer player(files, {no_terrain, nullptr}, &console, without_kept_index());
    GeoidBelow geoid(nullptr);
    ScannedFlight scanned;
    scanned.log = files.log;
    scanned.first = player.first();
    scanned.last = player.last();
    bool is_joined = false;
    const base::Duration step = scan_step(scanned);
    for (base::Time time = scanned.first; time <= scanned.last; time = time + step) {
        const flight::AircraftState state = player.at(time).state;
        if (const flight::FlightTime shown = flight::flight_time(state.utc, time); shown.is_date) {
            scanned.is_dated = true;
            scanned.ahead = shown.utc - time;
        }
        const bool is_valid = state.own_ship.state == base::SignalState::valid;
        if (!is_joined && !scanned.places.empty()) scanned.places.back().joins_next = false;
        is_joined = is_valid;
        if (!is_valid) continue;
        const earth::Geodetic& at = state.own_ship.position;
        scanned.places.push_back({time, at.latitude_rad, at.longitude_rad, ellipsoid_height_m(state.own_ship, geoid), true});
    }
    return scanned;
}

}  // namespace tedavis::host_sim
