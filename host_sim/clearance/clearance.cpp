#include "host_sim/clearance/clearance.hpp"

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double k95Of90 = 1.959964 / 1.644854;  // normal quantiles, two-sided
constexpr double kSlowestTrack_mps = 2;
constexpr double kHalfSector_rad = base::kPi / 4;
/// What lies in this distance is nearer than the ground below, which is known to the rounding of its vertices.
constexpr double kSearchSlack_m = 1;

std::optional<double> stated_accuracy_m(const flight::AircraftState& state, Signal signal, base::Time now) {
    const double value_m = state[signal].value_or(0);
    return state.is_valid(signal, now) && value_m > 0 ? std::optional(value_m) : std::nullopt;
}

/// Directions north and east within a quarter of a circle, no lower than the own ship.
Region level_sector(double middle_rad) {
    const double from = middle_rad - kHalfSector_rad, to = middle_rad + kHalfSector_rad;
    return {{{0, 0, -1}, 0}, {{std::cos(from), std::sin(from), 0}, 0}, {{std::cos(to), std::sin(to), 0}, 0}};
}

}  // namespace

std::optional<double> ClearanceUncertainty::height_above_terrain_m() const {
    if (!height_m || !terrain_m) return std::nullopt;
    return std::hypot(*height_m, *terrain_m);
}

ClearanceMeter::ClearanceMeter(const terrain::TerrainDatabase& database)
    : database_(database),
      memory_(terrain::HeightQuery::bytes_needed()),
      arena_(memory_.data(), memory_.size()),
      ground_(database) {
    TEDAVIS_CHECK(heights_.start(database, arena_));
}

std::optional<OwnShipPlace> ClearanceMeter::place_of(const flight::OwnShipEstimate& own_ship) const {
    if (own_ship.state != base::SignalState::valid) return std::nullopt;
    OwnShipPlace own{own_ship.position, own_ship.position.height.m, own_ship.height_is_geometric};
    const double undulation_m = database_.undulation(own.place.latitude_rad, own.place.longitude_rad).m;
    if (own.is_geometric) own.height_msl_m -= undulation_m;
    if (!own.is_geometric) own.place.height.m += undulation_m;
    return own;
}

double ClearanceMeter::height_above_terrain_m(const OwnShipPlace& own) {
    const terrain::HeightAnswer ground = heights_.at(own.place.latitude_rad, own.place.longitude_rad);
    const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
    return is_known ? own.height_msl_m - ground.height.m : std::nan("");
}

std::optional<GroundPlace> ClearanceMeter::nearest(const OwnShipPlace& own) {
    const double above_m = height_above_terrain_m(own);
    if (std::isnan(above_m)) return std::nullopt;
    return ground_.find(own.place, std::fabs(above_m) + kSearchSlack_m);
}

ClearanceUncertainty ClearanceMeter::uncertainty_of(const flight::AircraftState& state, base::Time now) const {
    ClearanceUncertainty uncertainty;
    uncertainty.position_m = stated_accuracy_m(state, Signal::horizontal_accuracy, now);
    if (state.own_ship.height_is_geometric) uncertainty.height_m = stated_accuracy_m(state, Signal::vertical_accuracy, now);
    if (const auto le90_m = static_cast<double>(database_.header().le90_m); le90_m > 0) uncertainty.terrain_m = le90_m * k95Of90;
    return uncertainty;
}

LevelClearance ClearanceMeter::level(const OwnShipPlace& own, double track_rad) {
    LevelClearance level;
    level.ahead = ground_.find(own.place, kLevelReach_m, level_sector(track_rad));
    level.left = ground_.find(own.place, kLevelReach_m, level_sector(track_rad - base::kPi / 2));
    level.right = ground_.find(own.place, kLevelReach_m, level_sector(track_rad + base::kPi / 2));
    level.is_whole = !ground_.may_be_unknown(own.place, kLevelReach_m);
    return level;
}

std::optional<Clearance> ClearanceMeter::measure(const flight::AircraftState& state, base::Time now, double heading_rad) {
    const std::optional<OwnShipPlace> own = place_of(state.own_ship);
    const std::optional<GroundPlace> ground = own ? nearest(*own) : std::nullopt;
    if (!ground) return std::nullopt;
    const flight::OwnShipEstimate& ship = state.own_ship;
    const bool moves = std::hypot(ship.velocity_north_mps, ship.velocity_east_mps) >= kSlowestTrack_mps;
    const double track_rad = moves ? std::atan2(ship.velocity_east_mps, ship.velocity_north_mps) : heading_rad;
    Clearance clearance;
    clearance.height_above_terrain_m = height_above_terrain_m(*own);
    clearance.uncertainty = uncertainty_of(state, now);
    clearance.nearest = *ground;
    clearance.nearest_off_track_rad = earth::angle_difference(ground->bearing_rad, track_rad);
    clearance.nearest_is_whole = !ground_.may_be_unknown(own->place, ground->distance_m);
    clearance.level = level(*own, track_rad);
    return clearance;
}

}  // namespace tedavis::host_sim
