/// The part of a fixed light's beam that falls on the surface: Lambert's cosine times the part of the light's disc above the
/// horizon.
#pragma once

#include "host_sim/terrain_builder/attributes/far_horizons.hpp"
#include "host_sim/terrain_builder/attributes/height_planes.hpp"
#include "host_sim/terrain_builder/attributes/surface_shape.hpp"

namespace tedavis::host_sim {

/// Returns values 0..1 in the layout of HeightPlanes, filled for inner posts, kHorizonReach posts around them, and half way
/// between. Posts without a height have the value of level open ground. The tangent of the horizon at the light's azimuth is
/// interpolated linearly between the two lattice directions beside it, and is 0 or more, as in the horizon maps; the disc's light
/// is taken as uniform over its height. The light's elevation must be above 0 and at most 90 degrees.
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
