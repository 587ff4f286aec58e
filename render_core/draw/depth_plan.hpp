/// Divides the depth range for a 24-bit depth buffer: one range where it resolves all distances, else a far and a near one,
/// drawn in this order with the depth cleared between them.
///
/// A depth difference of 0.0003 of the distance must be resolved everywhere. A buffer of b bits resolves z^2 / (near * 2^b) at
/// depth z; a factor of 4 covers interpolation. Pure function; any thread.
#pragma once

#include <cmath>
#include <cstddef>

#include "render_core/terrain/projected_error.hpp"

namespace tedavis::draw {

using DepthRange = terrain::DepthSpan;

struct DepthPlan {
    DepthRange ranges[2];  ///< in drawing order
    std::size_t count = 1;

    /// Where the ranges overlap, blended pieces belong to the far range from this distance on. 0 where there is one range.
    [[nodiscard]] double parting_m() const { return count > 1 ? ranges[1].far_m : 0; }
};

[[nodiscard]] inline DepthPlan plan_depth(double near_m, double far_m) {
    constexpr double kResolvedShare = 0.3e-3, kInterpolation = 4, kSteps = 16777216;
    constexpr double kOverlap = 0.98;  // a triangle cut by one range's end begins before it in the other
    DepthPlan plan;
    plan.ranges[0] = {near_m, far_m};
    if (kInterpolation * far_m / (near_m * kSteps) <= kResolvedShare) return plan;
    const double split_m = std::sqrt(near_m * far_m);
    plan.ranges[0] = {split_m * kOverlap, far_m};
    plan.ranges[1] = {near_m, split_m};
    plan.count = 2;
    return plan;
}

}  // namespace tedavis::draw
