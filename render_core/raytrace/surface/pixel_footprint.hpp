/// How many posts a pixel covers, and what that asks for (thesis 6.2.2.2: surfaces in the distance are under-sampled).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

/// Posts across a pixel at a distance, along the shorter spacing of posts and across the ray; a surface seen at a shallow angle
/// has more of them along it, which the average mipmap would blur and which supersampling resolves.
[[nodiscard]] inline double footprint_posts(double distance_m, double pixel_angle_rad, const GridScale& scale) {
    return std::max(distance_m, 0.0) * pixel_angle_rad / std::min(scale.column_m, scale.row_m);
}

/// From here on a surface is under-sampled by one ray a pixel: two rays a post are needed to see what posts can hold (Shannon
/// 1949).
inline constexpr double kUndersampledFootprint = 0.5;

[[nodiscard]] constexpr bool is_undersampled(double footprint) { return footprint >= kUndersampledFootprint; }

/// Rays along each side of a pixel: 1 where the surface is not under-sampled, else so many that their distance is below half a
/// post, or `most_along` where that is fewer. A footprint that is no number asks for one.
[[nodiscard]] inline std::uint32_t rays_along_pixel(double footprint, std::uint32_t most_along) {
    if (!is_undersampled(footprint) || most_along <= 1) return 1;
    const double wanted = std::floor(footprint / kUndersampledFootprint) + 1;
    return wanted < most_along ? static_cast<std::uint32_t>(wanted) : most_along;
}

}  // namespace tedavis::raytrace
