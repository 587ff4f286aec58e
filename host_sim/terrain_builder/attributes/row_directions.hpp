/// The 16 directions of the horizon over one row of posts, in metres.
#pragma once

#include <array>
#include <cstddef>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"
#include "host_sim/terrain_builder/attributes/height_planes.hpp"
#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::host_sim {

/// Radius R of the sphere by which ground at distance d drops below the horizontal by d²/2R; refraction is neglected.
inline constexpr double kHorizonEarthRadius_m = 6371000;

/// Position of a direction's sample in HalfPlanes, relative to the post. Sample s is s steps away. In directions such as (2,1), a
/// step that falls between two posts of a row or column uses the value half way.
struct SamplePlace {
    HalfPost plane = at_post;
    std::ptrdiff_t offset = 0;
};
using SamplePlaces = std::array<SamplePlace, kHorizonReach + 1>;  ///< by s, from 1 on
[[nodiscard]] std::array<SamplePlaces, terrain::kHorizonDirections> sample_places(std::size_t stride);

struct RowDirection {
    float east = 0, north = 0;  ///< unit vector
    float weight = 0;           ///< its share of the full turn, half the angle between its neighbours; the sum of all 16 is 1
    std::array<float, kHorizonReach + 1> per_m{};  ///< by s: 1 / distance
    std::array<float, kHorizonReach + 1> drop{};   ///< by s: tangent of the horizon of a sphere of the same height, positive
};
/// `east_m` is used for all samples of a row: within the reach, the differences between rows are less than the heights' accuracy.
/// On square cells, directions at right angles have exactly equal weights and distances.
[[nodiscard]] std::array<RowDirection, terrain::kHorizonDirections> row_directions(double east_m, double north_m);

}  // namespace tedavis::host_sim
