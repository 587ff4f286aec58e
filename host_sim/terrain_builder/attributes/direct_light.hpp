/// The part of a fixed light's beam that falls on the surface: Lambert's cosine times the part of the light's disc above the
/// horizon.
#pragma once

#include "host_sim/terrain_builder/attributes/far_horizons.hpp"
#include "host_sim/terrain_builder/attributes/height_planes.hpp"
#include "host_sim/terrain_builder/attributes/surface_shape.hpp"

namespace tedavis::host_sim {

/// 0..1, laid out as HeightPlanes; filled for inner posts and kHorizonReach posts round them, and half way between. Posts
/// without a height have the value of level open ground. The tangent of the horizon at the light's azimuth lies linearly
/// between those of the two lattice directions beside it, not below 0 as in the horizon maps; the disc's light counts as
/// even over its height. The light stands above the horizontal and not beyond the zenith.
[[nodiscard]] HalfPlanes direct_light(const HeightPlanes& planes, const Gradients& gradients, const FixedLight& light,
                                      const FarView& above);

/// Unit normal of the surface with these rises per metre.
struct NormalLanes {
    Lanes east, north, up;
};
[[nodiscard]] inline NormalLanes normal_of(Lanes rise_east, Lanes rise_north) {
    const Lanes up = 1.0f / root(1.0f + (rise_east * rise_east + rise_north * rise_north));
    return {-rise_east * up, -rise_north * up, up};
}

}  // namespace tedavis::host_sim
