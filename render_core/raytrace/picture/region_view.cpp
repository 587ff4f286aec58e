#include "render_core/raytrace/picture/region_view.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

constexpr double kNearPosts = 0.125, kMiddlePosts = 0.5;
constexpr float kNearness[kRegionKinds] = {0, 0.25f, 0.6f, 1};
constexpr float kDarkest = 0.1f;  // what is dark still counts for so much

struct RegionSums {
    std::uint32_t pixels = 0, hit_count = 0;
    float nearest = std::numeric_limits<float>::infinity();
    float light = 0;
};

/// Luminance of linear sRGB (IEC 61966-2-1).
float luminance(const glm::vec3& light) { return 0.2126f * light.x + 0.7152f * light.y + 0.0722f * light.z; }

RegionView view_of(const RegionSums& sums, double pixel_width_posts) {
    RegionView view;
    if (sums.hit_count == 0) return {RegionKind::sky, 0};
    const double covered = double{sums.nearest} * pixel_width_posts;
    view.kind = covered < kNearPosts ? RegionKind::near : (covered < kMiddlePosts ? RegionKind::middle : RegionKind::far);
    const float lit = std::clamp(2 * sums.light / static_cast<float>(sums.hit_count), kDarkest, 1.0f);
    const float area = static_cast<float>(sums.hit_count) / static_cast<float>(sums.pixels);
    view.weight = area * kNearness[static_cast<std::size_t>(view.kind)] * lit;
    return view;
}

}  // namespace

void view_regions(const HitPicture& hits, base::Span<const glm::vec3> light, std::uint32_t width, std::uint32_t height,
                  double pixel_width_posts, base::Span<RegionView> regions) {
    constexpr std::uint32_t kWidth = PictureVariants::kRegionWidth, kHeight = PictureVariants::kRegionHeight;
    const std::uint32_t across = PictureVariants::regions_across(width), down = PictureVariants::regions_down(height);
    TEDAVIS_CHECK(regions.size() == std::size_t{across} * down && hits.t.size() == std::size_t{width} * height);
    TEDAVIS_CHECK(light.size() == hits.t.size());
    for (std::uint32_t n = 0; n < regions.size(); ++n) {
        RegionSums sums;
        const std::uint32_t left = n % across * kWidth, top = n / across * kHeight;
        for (std::uint32_t y = top; y < std::min(top + kHeight, height); ++y)
            for (std::uint32_t x = left; x < std::min(left + kWidth, width); ++x) {
                const std::size_t at = std::size_t{y} * width + x;
                ++sums.pixels;
                if (hits.cell.data()[at] < 0) continue;
                ++sums.hit_count;
                sums.nearest = std::min(sums.nearest, hits.t.data()[at]);
                sums.light += luminance(light.data()[at]);
            }
        regions[n] = view_of(sums, pixel_width_posts);
    }
}

}  // namespace tedavis::raytrace
