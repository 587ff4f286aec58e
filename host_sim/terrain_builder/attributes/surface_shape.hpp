/// Slope and bend of the surface at posts, from their eight neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/terrain_builder/attributes/height_planes.hpp"

namespace tedavis::host_sim {

/// Rises per metre to the east and to the north, laid out as HeightPlanes; filled for inner posts and kHorizonReach posts
/// round them. Stencil: Horn, "Hill Shading and the Reflectance Map", Proc. IEEE 69(1), 1981. A row or column of it that
/// has a void takes its one-sided difference, or none, and the weights of the others count. 0 where nothing is known.
struct Gradients {
    explicit Gradients(const HeightPlanes& planes);

    std::vector<float> east, north;
};

/// Mean curvature of the surface times the geometric mean of the post spacings, positive where it bulges upwards, at four
/// inner posts from `at` on. A second difference with a void in it counts as 0.
[[nodiscard]] Lanes curvature(const HeightPlanes& planes, const Gradients& gradients, std::size_t at, double east_m);

}  // namespace tedavis::host_sim
