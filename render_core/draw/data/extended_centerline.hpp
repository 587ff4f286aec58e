/// The extended centre line of a runway, on the side from which the own ship approaches: which runway has it, and where its line
/// and its ticks lie.
///
/// One runway of a layer has it: the one nearest the last point of the planned flight, where there is one, else the nearest ahead
/// of the eye, within kFarthestApproach_m. It reaches kExtendedNm nautical miles out from the threshold, with a tick at each, and
/// a longer one at the last. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/draw/data/element_input.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::draw {

inline constexpr int kExtendedNm = 5, kExtendedSteps = 8;  ///< nautical miles, and parts of each that follow the ground
inline constexpr double kFarthestApproach_m = 60'000;
inline constexpr double kTick_m = 150;  ///< half of a tick's length; of the last twice as much

/// What a frame knows of the own ship's approach.
struct ApproachFrame {
    bool has_own_ship = false;  ///< its position is valid
    earth::Geodetic own_ship;
    bool has_destination = false;  ///< the last point of the planned flight
    double destination_latitude_rad = 0, destination_longitude_rad = 0;
    glm::dvec3 forward{0};       ///< of the eye, ECEF
    double metres_per_px_m = 0;  ///< width of a pixel at a distance of 1 m
};

struct Approach {
    bool is_any = false;
    std::uint32_t feature = 0;
};
/// The runway that has the line.
[[nodiscard]] Approach approach_of(const ElementInput& input, const ApproachFrame& frame);

/// Returns a place relative to a runway: metres along it from its first point, and metres to the right of its centre line.
[[nodiscard]] glm::dvec2 along_and_aside(const scene::ScenePoint& first, const scene::ScenePoint& last,
                                         const earth::Geodetic& place);

}  // namespace tedavis::draw
