#include "render_core/policy/terrain_alert_zone.hpp"

#include <cmath>

namespace tedavis::policy {
namespace {

/// Of a place ahead and to the right of the own ship, m.
TrackPassage passage_on_circle(double ahead_m, double right_m, double speed_mps, double turn_radps) {
    const double radius_m = speed_mps / std::fabs(turn_radps), inwards_m = turn_radps > 0 ? right_m : -right_m;
    const double angle = std::atan2(ahead_m, radius_m - inwards_m);  // about the middle of the turn
    if (angle < 0) return {0, std::hypot(ahead_m, right_m)};
    return {angle / std::fabs(turn_radps), std::fabs(std::hypot(ahead_m, radius_m - inwards_m) - radius_m)};
}

}  // namespace

double TerrainAlertZone::speed_mps() const { return std::hypot(north_mps, east_mps); }

TrackPassage passage_of(const TerrainAlertZone& zone, double north_m, double east_m) noexcept {
    const double speed_mps = zone.speed_mps();
    if (!(speed_mps > 0)) return {0, std::hypot(north_m, east_m)};
    const double north = zone.north_mps / speed_mps, east = zone.east_mps / speed_mps;
    const double ahead_m = north_m * north + east_m * east, right_m = east_m * north - north_m * east;
    if (std::fabs(zone.turn_radps) >= kMinTurn_radps) return passage_on_circle(ahead_m, right_m, speed_mps, zone.turn_radps);
    return ahead_m > 0 ? TrackPassage{ahead_m / speed_mps, std::fabs(right_m)} : TrackPassage{0, std::hypot(ahead_m, right_m)};
}

TerrainAhead violation_at(const TerrainAlertZone& zone, double north_m, double east_m, double height_msl_m) noexcept {
    const TrackPassage passage = passage_of(zone, north_m, east_m);
    if (passage.seconds > zone.until_s || passage.aside_m > zone.radius_at(passage.seconds)) return TerrainAhead::none;
    if (!(height_msl_m > zone.floor_at(passage.seconds))) return TerrainAhead::none;
    const bool is_at_runway = std::hypot(north_m - zone.runway.north_m, east_m - zone.runway.east_m) < zone.runway.radius_m &&
                              height_msl_m <= zone.runway.highest_msl_m;
    if (is_at_runway) return TerrainAhead::none;
    return passage.seconds <= kTerrainWarning_s ? TerrainAhead::warning : TerrainAhead::caution;
}

}  // namespace tedavis::policy
