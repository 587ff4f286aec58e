/// The 16 directions of the horizon over one row of posts, in metres.
#pragma once

#include <array>
#include <cstddef>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"
#include "host_sim/terrain_builder/attributes/height_planes.hpp"
#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::host_sim {

/// Of the sphere over which ground drops from the horizontal by d²/2R; light is not refracted.
inline constexpr double kHorizonEarthRadius_m = 6371000;

/// Where a direction's samples lie in HalfPlanes, relative to the post. Sample s is s steps away; a step of a knight's
/// direction, such as (2,1), that falls between two posts of a row or column reads the value half way.
struct SamplePlace {
    HalfPost plane = at_post;
    std::ptrdiff_t offset = 0;
};
using SamplePlaces = std::array<SamplePlace, kHorizonReach + 1>;  ///< by s, from 1 on
[[nodiscard]] std::array<SamplePlaces, terrain::kHorizonDirections> sample_places(std::size_t stride);

struct RowDirection {
    float east = 0, north = 0;  ///< unit vector
    float weight = 0;           ///< its part of the full turn: half the angles to its neighbours; the 16 add up to 1
    std::array<float, kHorizonReach + 1> per_m{};  ///< by s: 1 / distance
    std::array<float, kHorizonReach + 1> drop{};   ///< by s: tangent of the horizon of a sphere of the same height, positive
};
/// `east_m` counts for all samples of a row: within the reach, rows differ by less than the heights' accuracy can tell.
/// On square cells, directions a right angle apart have exactly equal weights and distances.
[[nodiscard]] std::array<RowDirection, terrain::kHorizonDirections> row_directions(double east_m, double north_m);

}  // namespace tedavis::host_sim
