/// The places of the ground that a picture shows, found by rays to the true surface of a terrain.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host_sim/accuracy/knobs/flown_display.hpp"
#include "host_sim/tracing/traced_shot.hpp"

namespace tedavis::host_sim {

/// The error of nearer ground is known less well, in pixels.
inline constexpr double kNearestSeenPlace_m = 50;

struct SeenPlace {
    std::uint32_t x = 0, y = 0;  ///< the pixel through whose middle the ray goes, from the left and from the top
    double latitude_rad = 0, longitude_rad = 0;
    earth::Ecef position{0};  ///< of the true surface there
};

/// One for each pixel of the plan's picture in which a ray meets the two triangles of a cell, row by row. The ground must be in
/// memory. Throws UserError: the tracer cannot see from there.
[[nodiscard]] std::vector<SeenPlace> seen_ground(const TracedGround& ground, const TracedShotPlan& plan);

/// A pose, and a grid of places that it shows.
struct SeenPose {
    AircraftPose pose;
    std::vector<SeenPlace> places;
};
/// The poses that show ground, with their places in the grid. Nearer ground than 50 m is left out: in pixels it is known less
/// well. Throws UserError where no pose shows any.
[[nodiscard]] std::vector<SeenPose> seen_poses(const TracedGround& ground, const std::vector<AircraftPose>& poses,
                                               const SeenGrid& grid = SeenGrid());
[[nodiscard]] std::vector<AircraftPose> poses_of(const std::vector<SeenPose>& seen);

/// Where a view shows a place, in pixels right of its middle and below it. Nothing before the near plane.
[[nodiscard]] std::optional<glm::dvec2> pixel_at(const terrain::View& view, const earth::Ecef& place);

}  // namespace tedavis::host_sim
