/// Slope and curvature of the surface at posts, from their eight neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/terrain_builder/attributes/height_planes.hpp"

namespace tedavis::host_sim {

/// Rises per metre to the east and to the north, laid out as HeightPlanes; filled for inner posts and kHorizonReach posts round
/// them. Stencil: Horn, "Hill Shading and the Reflectance Map", Proc. IEEE 69(1), 1981. A row or column of the stencil with a
/// void uses its one-sided difference or is left out, and the weights of the others are normalized. 0 where no difference is
/// known.
struct Gradients {
    explicit Gradients(const HeightPlanes& planes);

    std::vector<float> east, north;
};

/// Returns the mean curvature of the surface times the geometric mean of the post spacings, positive where it is convex upwards,
/// at four inner posts from `at` on. A second difference with a void is 0.
[[nodiscard]] Lanes curvature(const HeightPlanes& planes, const Gradients& gradients, std::size_t at, double east_m);

}  // namespace tedavis::host_sim
