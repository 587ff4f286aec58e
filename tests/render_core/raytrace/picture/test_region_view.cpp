#include "render_core/raytrace/picture/region_view.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::raytrace {
namespace {

TEST(RegionView, TellsSkyFarMiddleAndNearAndWhatIsLit) {
    constexpr std::uint32_t kViewWidth = 300, kViewHeight = 40;  // five regions across, two down; the last ones narrow
    const std::size_t pixels = kViewWidth * kViewHeight;
    std::vector<float> t(pixels, 1000);
    std::vector<std::int32_t> cell(pixels, 5);
    std::vector<HitSide> side(pixels);
    std::vector<glm::vec3> light(pixels, glm::vec3(0.5f));
    for (std::uint32_t y = 0; y < kViewHeight; ++y)
        for (std::uint32_t x = 0; x < kViewWidth; ++x) {
            const std::size_t at = y * kViewWidth + x;
            if (x < 64) cell[at] = HitPicture::kNoCell;
            if (x >= 128) t[at] = 300;
            if (x >= 192) t[at] = 100;
            if (x >= 256) light[at] = glm::vec3(0.1f);
            if (y >= 32 && x >= 192 && x < 224) cell[at] = HitPicture::kNoCell;
        }
    RegionView found[10];
    view_regions({t, cell, side}, light, kViewWidth, kViewHeight, 0.001, found);
    const RegionKind kinds[] = {RegionKind::sky, RegionKind::far, RegionKind::middle, RegionKind::near, RegionKind::near};
    for (std::uint32_t n = 0; n < 10; ++n) EXPECT_EQ(found[n].kind, kinds[n % 5]) << n;
    EXPECT_EQ(found[0].weight, 0);
    EXPECT_LT(found[1].weight, found[2].weight);
    EXPECT_LT(found[2].weight, found[3].weight);
    EXPECT_NEAR(found[3].weight, 1, 1e-4);
    EXPECT_NEAR(found[4].weight, 0.2, 1e-4);  // dark
    EXPECT_NEAR(found[8].weight, 0.5, 1e-4);  // half of it is sky
}

}  // namespace
}  // namespace tedavis::raytrace
