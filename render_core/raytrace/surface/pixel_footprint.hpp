/// The number of posts that a pixel covers, and the rays that it needs (thesis 6.2.2.2: distant surfaces are undersampled).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "render_core/raytrace/surface/surface_point.hpp"

namespace tedavis::raytrace {

/// Returns the posts across a pixel at a distance, for the shorter spacing of posts and perpendicular to the ray. A surface
/// seen at a shallow angle has more posts along the ray, which the average mipmap would blur and supersampling resolves.
[[nodiscard]] inline double footprint_posts(double distance_m, double pixel_angle_rad, const GridScale& scale) {
    return std::max(distance_m, 0.0) * pixel_angle_rad / std::min(scale.column_m, scale.row_m);
}

/// From this footprint on one ray per pixel undersamples the surface: two rays per post are needed (sampling theorem, Shannon
/// 1949).
inline constexpr double kUndersampledFootprint = 0.5;

[[nodiscard]] constexpr bool is_undersampled(double footprint) { return footprint >= kUndersampledFootprint; }

/// Returns the number of rays along each side of a pixel: 1 where the surface is not undersampled, else enough for a spacing
/// below half a post, but at most `most_along`. A NaN footprint gives 1.
[[nodiscard]] inline std::uint32_t rays_along_pixel(double footprint, std::uint32_t most_along) {
    if (!is_undersampled(footprint) || most_along <= 1) return 1;
    const double wanted = std::floor(footprint / kUndersampledFootprint) + 1;
    return wanted < most_along ? static_cast<std::uint32_t>(wanted) : most_along;
}

}  // namespace tedavis::raytrace
