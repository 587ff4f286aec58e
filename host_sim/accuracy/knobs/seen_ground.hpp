/// The places of the ground that a picture shows, found by rays to the true surface of a terrain.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host_sim/accuracy/knobs/flown_display.hpp"
#include "host_sim/tracing/traced_shot.hpp"

namespace tedavis::host_sim {

/// The nearest ground whose error is measured; that of nearer ground is less certain in pixels.
inline constexpr double kNearestSeenPlace_m = 50;

struct SeenPlace {
    std::uint32_t x = 0, y = 0;  ///< pixel through whose centre the ray goes, from the upper left
    double latitude_rad = 0, longitude_rad = 0;
    earth::Ecef position{0};  ///< on the true surface
};

/// Returns a place for each pixel of the plan's picture whose ray hits a triangle of a cell, row by row. The ground must be in
/// memory. Throws UserError where the tracer cannot trace from the pose.
[[nodiscard]] std::vector<SeenPlace> seen_ground(const TracedGround& ground, const TracedShotPlan& plan);

/// A pose, and a grid of places that it shows.
struct SeenPose {
    AircraftPose pose;
    std::vector<SeenPlace> places;
};
/// Returns the poses that show ground, with their places in the grid. Ground nearer than kNearestSeenPlace_m is left out. Throws
/// UserError where no pose shows any.
[[nodiscard]] std::vector<SeenPose> seen_poses(const TracedGround& ground, const std::vector<AircraftPose>& poses,
                                               const SeenGrid& grid = SeenGrid());
[[nodiscard]] std::vector<AircraftPose> poses_of(const std::vector<SeenPose>& seen);

/// Projects a place: pixels to the right of the view's centre and below it; nothing in front of the near plane.
[[nodiscard]] std::optional<glm::dvec2> pixel_at(const terrain::View& view, const earth::Ecef& place);

}  // namespace tedavis::host_sim
