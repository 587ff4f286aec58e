#include "host_sim/evaluation/evaluation_views.hpp"

#include <gtest/gtest.h>

#include "host_sim/measure/lab_picture.hpp"
#include "tests/support/flights/evaluated_flights.hpp"

namespace tedavis::host_sim::test_evaluation_views {
namespace {

TEST(EvaluationViews, AMapIsEnlargedBetweenTheMiddlesOfItsCells) {
    const FloatMap map{2, 1, 4, 4, {0, 1}};
    const FloatMap large = enlarged(map, 7, 4);  // the last cell reaches beyond
    ASSERT_EQ(large.values.size(), 28u);
    EXPECT_EQ(large.at(0, 0), 0);
    EXPECT_EQ(large.at(1, 3), 0);
    EXPECT_FLOAT_EQ(large.at(2, 0), 0.125f) << "half a pixel behind the first cell's middle at 2, cells 4 apart";
    EXPECT_FLOAT_EQ(large.at(5, 2), 0.875f);
    EXPECT_EQ(large.at(6, 0), 1);
    const FloatMap same{3, 2, 1, 1, {0, 1, 2, 3, 4, 5}};
    EXPECT_EQ(enlarged(same, 3, 2).values, same.values);
}

TEST(EvaluationViews, HeatGrowsLighterWithItsValue) {
    RgbaPicture scale{21, 1, {}};
    for (int n = 0; n <= 20; ++n) {
        const auto color = heat_color(static_cast<float>(n) / 20);
        scale.pixels.insert(scale.pixels.end(), {color[0], color[1], color[2], 255});
    }
    const LabPicture lab(view_of(scale));
    for (std::uint32_t n = 1; n <= 20; ++n) EXPECT_GT(lab.at(n, 0).lightness, lab.at(n - 1, 0).lightness) << n;
    EXPECT_EQ(heat_color(-1), heat_color(0));
    EXPECT_EQ(heat_color(2), heat_color(1));
}

TEST(EvaluationViews, SaliencyAndEdgesAreGrey) {
    const RgbaPicture grey = saliency_picture({2, 1, 1, 1, {0.5f, 2}});
    EXPECT_EQ(grey.pixels, (std::vector<std::uint8_t>{128, 128, 128, 255, 255, 255, 255, 255}));
    const RgbaPicture edges = edge_picture({0, 9}, 2, 1);
    EXPECT_EQ(edges.pixels, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255}));
}

TEST(EvaluationViews, HeatStandsOnlyWhereTheMapIsNotZero) {
    const RgbaPicture picture = test_support::striped_picture(4, 1, 2);
    const RgbaPicture heat = heat_picture(picture, {4, 1, 1, 1, {0, 0, 1, 1}});
    EXPECT_EQ(heat.pixels[0], heat.pixels[2]) << "dim grey without heat";
    EXPECT_LT(heat.pixels[0], picture.pixels[0]);
    EXPECT_GT(heat.pixels[8], 200);
    EXPECT_LT(heat.pixels[10], heat.pixels[8]) << "yellow";
}

TEST(EvaluationViews, RegionsAreTintedByTheirDensity) {
    const RgbaPicture picture = test_support::striped_picture(64, 48, 0);
    const perception::RegionGrid grid{2, 2};
    const RgbaPicture plain = region_picture(picture, grid, {0, 0, 0, 0}), one = region_picture(picture, grid, {0, 0, 0, 0.25});
    std::size_t inside = 0, outside = 0;
    for (std::uint32_t y = 0; y < 48; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            const std::size_t at = (std::size_t{y} * 64 + x) * 4;
            if (plain.pixels[at] == one.pixels[at]) continue;
            (x >= 32 && y >= 24 ? inside : outside) += 1;
        }
    }
    EXPECT_EQ(outside, 0u);
    EXPECT_GT(inside, 600u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluation_views
