#include "host_sim/evaluation/picture_meter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_picture_meter {
namespace {

TEST(PictureMeter, WhatWasMeasuredBeforeDoesNotMatter) {
    const RgbaPicture small = test_support::striped_picture(90, 61, 6), large = test_support::striped_picture(200, 150, 9);
    PictureMeter used({}), fresh({});
    (void)used.measure(large, "large", nullptr, {});
    (void)used.measure(test_support::striped_picture(3, 300, 1), "narrow", nullptr, {});
    const PictureMeasures a = used.measure(small, "small", nullptr, {}), b = fresh.measure(small, "small", nullptr, {});
    EXPECT_EQ(a.clutter, b.clutter);
    EXPECT_EQ(a.clutter_grid, b.clutter_grid);
    EXPECT_EQ(a.saliency_level, b.saliency_level);
    EXPECT_EQ(used.edges(), fresh.edges());
    EXPECT_EQ(used.saliency().values, fresh.saliency().values);
    EXPECT_EQ(used.saliency().width, 90u);
    EXPECT_EQ(used.saliency().height, 61u);
}

// Stripes of n columns: two of three channels change at each border, at the same place: one edge a border and row.
TEST(PictureMeter, StripesHaveOneEdgeABorder) {
    PictureMeter meter({});
    const PictureMeasures measures = meter.measure(test_support::striped_picture(240, 60, 24), "p", nullptr, {});
    EXPECT_NEAR(measures.clutter, 9.0 / 238, 1e-12) << "nine borders, the outermost columns do not count";
}

TEST(PictureMeter, PlainPicturesHaveNothing) {
    PictureMeter meter({});
    for (const auto& [width, height] : {std::pair{1u, 1u}, std::pair{2u, 3u}, std::pair{64u, 48u}}) {
        const PictureMeasures measures = meter.measure(test_support::striped_picture(width, height, 0), "p", nullptr, {});
        EXPECT_EQ(measures.clutter, 0);
        EXPECT_EQ(measures.saliency_level, 0);
        const FloatMap map = meter.saliency();
        EXPECT_TRUE(std::all_of(map.values.begin(), map.values.end(), [](float value) { return value == 0; }));
    }
}

TEST(PictureMeter, SharesOfLayersAddUp) {
    PictureMeter meter({});
    const RgbaPicture picture = test_support::striped_picture(96, 72, 8, 0.5);  // all stripes on the left
    LayerMask mask{96, 72, std::vector<std::uint8_t>(96 * 72, 0), {"left", "right", "unused"}};
    for (std::size_t n = 0; n < mask.layers.size(); ++n) mask.layers[n] = n % 96 < 60 ? 0 : 1;
    const PictureMeasures measures = meter.measure(picture, "p", &mask, {});
    ASSERT_EQ(measures.layers.size(), 3u);
    EXPECT_GT(measures.layers[0].share, 0.9);
    EXPECT_NEAR(measures.layers[0].share + measures.layers[1].share, 1, 1e-6);
    EXPECT_NEAR(measures.layers[0].area, 60.0 / 96, 1e-6);
    EXPECT_EQ(measures.layers[2].share, 0);
    EXPECT_TRUE(meter.measure(picture, "p", nullptr, {}).layers.empty());
}

TEST(PictureMeter, RefusesWhatIsTooLarge) {
    PictureMeter meter({});
    const RgbaPicture long_one{8193, 1, std::vector<std::uint8_t>(8193 * 4, 1)};
    test_support::expect_user_error([&] { (void)meter.measure(long_one, "long.png", nullptr, {}); },
                                    "long.png: larger than 8192");
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_meter
