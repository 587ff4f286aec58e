/// What a region of the last picture showed, by which the next one's settings are chosen there (choose_settings.hpp).
#pragma once

#include "render_core/raytrace/picture/trace_stages.hpp"

namespace tedavis::raytrace {

enum class RegionKind : std::uint8_t { sky, far, middle, near };
inline constexpr std::uint32_t kRegionKinds = 4;

struct RegionView {
    RegionKind kind = RegionKind::near;
    float weight = 1;  ///< how much of the picture's quality is decided here, 0..1: by area that is ground, nearness and light
};

/// Regions of a picture that has been drawn, row by row. A region is near where one of its pixels covers less than 1/8 post, in
/// the middle below 1/2, else far; it is sky where nothing was met. `pixel_width_posts` is what a pixel covers where t is 1.
void view_regions(const HitPicture& hits, base::Span<const glm::vec3> light, std::uint32_t width, std::uint32_t height,
                  double pixel_width_posts, base::Span<RegionView> regions);

}  // namespace tedavis::raytrace
