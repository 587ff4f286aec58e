/// What a region of the last picture showed; the settings of the next picture are chosen by it (choose_settings.hpp).
#pragma once

#include "render_core/raytrace/picture/trace_stages.hpp"

namespace tedavis::raytrace {

enum class RegionKind : std::uint8_t { sky, far, middle, near };
inline constexpr std::uint32_t kRegionKinds = 4;

struct RegionView {
    RegionKind kind = RegionKind::near;
    float weight = 1;  ///< the region's importance for the picture's quality, 0..1, from the share of ground, distance and light
};

/// Classifies the regions of a drawn picture, row by row. A region is near where one of its pixels covers less than 1/8 post,
/// in the middle distance below 1/2, else far; it is sky where there is no hit. `pixel_width_posts` is the width covered by a
/// pixel at t = 1.
void view_regions(const HitPicture& hits, base::Span<const glm::vec3> light, std::uint32_t width, std::uint32_t height,
                  double pixel_width_posts, base::Span<RegionView> regions);

}  // namespace tedavis::raytrace
