/// The own ship's planned path: the trajectory of a scene along which it flies.
///
/// Pure. Bounded: the trajectories' points. Any thread.
#pragma once

#include "render_core/earth/geodetic.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

struct PlannedTrack {
    const scene::Layer* layer = nullptr;  ///< null: there is none
    scene::Run run;
    std::uint32_t leg = 0;  ///< leg on which the own ship is
    double part = 0;        ///< its position on the leg, 0..1
};

/// Finds the planned path. `time_ns` is the flight's time, valid with `has_date`. It gives the position on the path where the
/// path's points have times and that position is within `farthest_m` of the own ship; else the nearest position is used.
[[nodiscard]] PlannedTrack planned_track(const scene::Scene& scene, const earth::Geodetic& own_ship, std::int64_t time_ns,
                                         bool has_date, double farthest_m);

/// Finds the path of one layer of lines, of any role, on which the own ship flies, and its nearest position on it. Where a path
/// has times and its position at `time_ns` is within `farthest_m` of the own ship, the nearest position is searched only within
/// `farthest_m` along the path of that position, so that it is right for paths that cross or retrace themselves.
[[nodiscard]] PlannedTrack track_beside(const scene::Layer& layer, const earth::Geodetic& own_ship, std::int64_t time_ns,
                                        bool has_date, double farthest_m);

/// Returns a point on a leg, with its height and, where both ends have one, its time.
[[nodiscard]] scene::ScenePoint point_on(const PlannedTrack& way, std::uint32_t leg, double part);

}  // namespace tedavis::draw
