/// The obstacle alert: which obstacles of the scene the own ship flies into, and when. The notice OBSTACLE AHEAD follows it in
/// every phase and design, and so does the colour of the obstacles that are in the way.
///
/// An obstacle is ahead where its top, higher by its stated accuracy, reaches above the floor that the predicted track leaves for
/// what is below it, within a minute: the same track, widening and clearance as of the terrain alert (terrain_ahead.hpp). An
/// obstacle beside the track counts where its distance from it is no more than the track's uncertainty and the stated accuracy of
/// its position together. A cable hangs between the tops of its poles, and counts as the straight line between them. Where the
/// ground of one pole is not known, it counts as high as the other one; an obstacle on unknown ground that states no height above
/// the sea is not judged.
///
/// Near a runway the terrain alert is inhibited. This one is not: a mast before the threshold is no ground on which an aircraft
/// may land. The clearance there is that of the final approach, and clearance and uncertainty take no more than three quarters of
/// the track's height above the runway, so that lamps and signs are no obstacles. Beyond the point where the track reaches the
/// runway there is no alert, unless the aircraft climbs.
///
/// Bounded   each point of a layer within reach, times the track's steps. Pure, but for what the ground reads. Thread  the
///           display's.
#pragma once

#include "render_core/flight/flight_phase.hpp"
#include "render_core/policy/obstacle_alerts.hpp"
#include "render_core/policy/terrain_ahead.hpp"
#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::policy {

class ObstacleWatch {
public:
    /// All arguments must outlive the object.
    ObstacleWatch(TerrainWatch& watch, scene::Ground& ground);

    /// Returns the time until the track is too close to a feature of a layer of obstacles, s; infinite where it is not.
    [[nodiscard]] double seconds_to(const scene::Layer& layer, std::uint32_t feature);

private:
    struct Place {
        double north_m, east_m;
    };
    struct Box {
        double south_m, north_m, west_m, east_m;
    };
    /// A line from one pole to the next; for a single point both ends are the same.
    struct Span {
        Place from, to;
        const scene::ScenePoint *first, *last;
    };
    [[nodiscard]] Place place_of(const scene::ScenePoint& point) const;
    [[nodiscard]] bool is_aside(const Span& span, double margin_m) const;
    [[nodiscard]] double seconds_to(const scene::Layer& layer, std::uint32_t feature, const Span& span);

    const PredictedTrack& track_;
    const TrackSteps steps_;
    scene::Ground& ground_;
    Box box_;  ///< round all steps
};

}  // namespace tedavis::policy
