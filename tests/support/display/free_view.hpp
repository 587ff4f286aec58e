/// Views of a camera that no aircraft carries.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/mat3x3.hpp>

#include "render_core/base/units.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::test_support {

/// 60 degrees wide. `axes`: forward, right and down in ECEF (earth::body_axes).
[[nodiscard]] inline terrain::View free_view(const glm::dvec3& eye, const glm::dmat3& axes, std::uint32_t width,
                                             std::uint32_t height, double near_m) {
    terrain::View view;
    view.eye = eye;
    view.forward = axes[0];
    view.right = axes[1];
    view.down = axes[2];
    view.width = width;
    view.height = height;
    view.focal_px = 0.5 * width / std::tan(base::radians(30));
    view.near_m = near_m;
    return view;
}

/// The n-th of `count` pitches from straight down to straight up.
[[nodiscard]] inline double pitch_rad(int n, int count) { return base::radians(-90 + 180.0 * n / (count - 1)); }

}  // namespace tedavis::test_support
