/// What a region of the last picture showed; the settings of the next picture are chosen by it (choose_settings.hpp).
#pragma once

#include "render_core/raytrace/picture/trace_stages.hpp"

namespace tedavis::raytrace {

enum class RegionKind : std::uint8_t { sky, far, middle, near };
inline constexpr std::uint32_t kRegionKinds = 4;

struct RegionView {
    RegionKind kind = RegionKind::near;
    float weight = 1;  ///< the region's importance for the picture's quality, 0..1 (view_regions())
};

/// Classifies the regions (64 x 32 pixels, row by row) of a drawn picture by the footprint of the pixel with the nearest hit, in
/// post spacings (the smaller of the two): near below 1/8, middle below 1/2, else far; sky without a hit. `pixel_width_posts`:
/// the footprint at t = 1, to which t is proportional. `light`: linear sRGB, one value per pixel.
///
/// A region's weight is the product of the share of pixels with hits, a factor of the kind (near 1, middle 0.6, far 0.25, sky 0),
/// and twice the mean luminance of the pixels with hits, clamped to 0.1..1.
void view_regions(const HitPicture& hits, base::Span<const glm::vec3> light, std::uint32_t width, std::uint32_t height,
                  double pixel_width_posts, base::Span<RegionView> regions);

}  // namespace tedavis::raytrace
