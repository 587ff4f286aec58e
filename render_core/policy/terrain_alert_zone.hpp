/// Which ground the predicted track comes too close to, and when: what the terrain alert colours.
///
/// A place on the ground counts at the time at which the track passes it: on a straight line, or on a circle for a constant turn
/// rate, for no more than half of it. It lies in the zone where it is no farther from the track than the track's uncertainty at
/// that time, and higher than the height that the track then leaves for the ground. The terrain's shader computes the same, in
/// float (draw/shaders/alert_zone.frag).
///
/// Frame     metres north and east of the own ship, on the plane that touches the Earth there: ground 3000 m high and 12 km
///           away lies 6 m off; heights above MSL. Plain data; pure functions; any thread.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::policy {

enum class TerrainAhead : std::uint8_t {
    none,
    caution,  ///< within 60 s
    warning,  ///< within 30 s
};

/// Ground round a runway on which an aircraft may land.
struct RunwayGround {
    double north_m = 0, east_m = 0;  ///< its place nearest to the track
    double radius_m = 0;             ///< 0: there is none
    double highest_msl_m = 0;        ///< higher ground counts as everywhere
};

struct TerrainAlertZone {
    TerrainAhead alert = TerrainAhead::none;  ///< without an alert nothing is coloured
    earth::Geodetic from;                     ///< the own ship, above the ellipsoid
    double north_mps = 0, east_mps = 0;
    double turn_radps = 0;                                 ///< of the track, to the right
    double radius_m = 0, radius_mps = 0, radius_mps2 = 0;  ///< radius + radius_mps t + radius_mps2 t^2: on either side of it
    double floor_msl_m = 0, floor_mps = 0;                 ///< floor + floor_mps t: ground that is higher is too close
    double until_s = 0;  ///< where the zone ends: its width beyond 60 s, at a runway, after half a turn
    RunwayGround runway;

    [[nodiscard]] double speed_mps() const;
    [[nodiscard]] double radius_at(double seconds) const { return radius_m + (radius_mps + radius_mps2 * seconds) * seconds; }
    [[nodiscard]] double floor_at(double seconds) const { return floor_msl_m + floor_mps * seconds; }
};
static_assert(std::is_trivially_copyable_v<TerrainAlertZone>);

inline constexpr double kTerrainCaution_s = 60, kTerrainWarning_s = 30;
/// Slower turns are treated as straight lines: within a minute at 100 m/s the difference is less than 4 m.
inline constexpr double kMinTurn_radps = 2e-5;

/// Where the track passes a place.
struct TrackPassage {
    double seconds = 0;  ///< 0 for what lies behind the own ship
    double aside_m = 0;  ///< distance from the track there; from the own ship for what lies behind it
};
[[nodiscard]] TrackPassage passage_of(const TerrainAlertZone& zone, double north_m, double east_m) noexcept;

/// Whether ground of this height lies in the zone; `caution` or `warning` by the time, whatever the zone's alert.
[[nodiscard]] TerrainAhead violation_at(const TerrainAlertZone& zone, double north_m, double east_m,
                                        double height_msl_m) noexcept;

}  // namespace tedavis::policy
