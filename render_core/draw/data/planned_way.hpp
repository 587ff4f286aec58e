/// The own ship's planned way: of a scene's trajectories the one that it flies along.
///
/// Pure. Bounded: the trajectories' points. Any thread.
#pragma once

#include "render_core/earth/geodetic.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

struct PlannedWay {
    const scene::Layer* layer = nullptr;  ///< null: there is none
    scene::Run run;
    std::uint32_t leg = 0;  ///< from its leg-th point to the next one, and
    double part = 0;        ///< 0..1 of it, the own ship is
};

/// `time_ns`: of the flight where `has_date`; by it the place on the way is told, where the way's points have times and that
/// place is within `farthest_m` of the own ship; else it is the nearest one.
[[nodiscard]] PlannedWay planned_way(const scene::Scene& scene, const earth::Geodetic& own_ship, std::int64_t time_ns,
                                     bool has_date, double farthest_m);

/// A place on a leg, with its height and, where both ends have one, its time.
[[nodiscard]] scene::ScenePoint point_on(const PlannedWay& way, std::uint32_t leg, double part);

}  // namespace tedavis::draw
