#include "render_core/perception/conspicuity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/render_core/perception/held_plane.hpp"

namespace tedavis::perception::test_conspicuity {
namespace {

using test_support::HeldPlane;

struct Maps {
    Maps(int width, int height) {
        for (int n = 0; n < kFeatureMaps + 2; ++n) held.emplace_back(width, height);
        for (std::size_t n = 0; n < kFeatureMaps; ++n) maps.features[n] = held[n].plane;
        maps.conspicuity = held[kFeatureMaps].plane;
        maps.saliency = held[kFeatureMaps + 1].plane;
    }
    [[nodiscard]] std::vector<float>& feature(int n) { return held[static_cast<std::size_t>(n)].values; }
    [[nodiscard]] const std::vector<float>& result() const { return held.back().values; }
    std::vector<HeldPlane> held;
    SaliencyMaps maps;
};

void fill_by_chance(Maps& maps, float gain) {
    for (int n = 0; n < kFeatureMaps; ++n)
        for (std::size_t k = 0; k < maps.feature(n).size(); ++k)
            maps.feature(n)[k] =
                gain *
                static_cast<float>(test_support::scrambled(static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(k), 5) %
                                   1000) /
                1000.0f;
}

TEST(Conspicuity, AWeightIsInformationTimesAmplitude) {
    HeldPlane map(10, 10);
    std::fill_n(map.values.begin(), 4, 0.3f);
    map.values[50] = 0.8f;
    map.values[51] = 0.41f;
    EXPECT_NEAR(feature_weight(map.plane, SaliencyScale::per_picture), -std::log2(3.0 / 102) * 0.8, 1e-6);
    EXPECT_NEAR(conspicuity_weight(map.plane, SaliencyScale::per_picture), -std::log2(3.0 / 102), 1e-9);
    EXPECT_EQ(conspicuity_weight(map.plane, SaliencyScale::fixed), 1);
    EXPECT_NEAR(feature_weight(map.plane, SaliencyScale::fixed), -std::log2(7.0 / 102) / std::log2(102.0), 1e-9);
}

TEST(Conspicuity, EmptyMapsHaveNoWeight) {
    for (const SaliencyScale scale : {SaliencyScale::per_picture, SaliencyScale::fixed}) {
        EXPECT_EQ(feature_weight(HeldPlane(7, 5).plane, scale), 0);
        EXPECT_EQ(feature_weight(HeldPlane(7, 5, 5e-5f).plane, scale), 0) << "rounding is no feature";
        EXPECT_GT(feature_weight(HeldPlane(7, 5, 0.03f).plane, scale), 0);
        Maps maps(7, 5);
        std::fill(maps.held.back().values.begin(), maps.held.back().values.end(), 3.0f);
        EXPECT_FALSE(combine(maps.maps, scale));
        EXPECT_EQ(maps.result(), std::vector<float>(35, 0)) << "whatever was there before";
    }
}

TEST(Conspicuity, GainDoesNotChangeAPicturesOwnScale) {
    Maps one(31, 17), half(31, 17);
    fill_by_chance(one, 1);
    fill_by_chance(half, 0.37f);
    ASSERT_TRUE(combine(one.maps, SaliencyScale::per_picture));
    ASSERT_TRUE(combine(half.maps, SaliencyScale::per_picture));
    for (std::size_t n = 0; n < one.result().size(); ++n) EXPECT_NEAR(one.result()[n], half.result()[n], 1e-5);
    EXPECT_EQ(*std::max_element(one.result().begin(), one.result().end()), 1);
}

TEST(Conspicuity, TheFixedScaleGrowsWithContrast) {
    const auto spot = [](float contrast) {
        Maps maps(40, 40);
        maps.feature(0)[820] = contrast;
        EXPECT_TRUE(combine(maps.maps, SaliencyScale::fixed));
        return maps.result()[820];
    };
    EXPECT_NEAR(spot(0.24f) / spot(0.06f), 4, 1e-4);
    EXPECT_LT(spot(0.24f), 1);
    EXPECT_EQ(spot(9), 1) << "more is cut";
}

TEST(Conspicuity, RareFeaturesCountMore) {
    Maps maps(40, 40);
    for (std::size_t n = 0; n < 800; ++n) maps.feature(0)[n] = 0.5f;
    maps.feature(2)[1000] = 0.5f;
    for (const SaliencyScale scale : {SaliencyScale::per_picture, SaliencyScale::fixed}) {
        ASSERT_TRUE(combine(maps.maps, scale));
        EXPECT_GT(maps.result()[1000], 5 * maps.result()[100]);
    }
}

TEST(Conspicuity, MakesTheSameMapTwice) {
    Maps maps(23, 9);
    fill_by_chance(maps, 1);
    ASSERT_TRUE(combine(maps.maps, SaliencyScale::per_picture));
    const std::vector<float> first = maps.result();
    ASSERT_TRUE(combine(maps.maps, SaliencyScale::fixed));
    EXPECT_NE(maps.result(), first);
    ASSERT_TRUE(combine(maps.maps, SaliencyScale::per_picture));
    EXPECT_EQ(maps.result(), first) << "features are left as they are";
}

}  // namespace
}  // namespace tedavis::perception::test_conspicuity
