#include "host_sim/evaluation/feature_congestion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host_sim/evaluation/rgba_of.hpp"
#include "tests/support/perception/congestion_reference.hpp"

namespace tedavis::host_sim::test_feature_congestion {
namespace {

using test_support::flat_picture;
using test_support::landscape;
using test_support::noise_picture;
using test_support::Rgb;
using test_support::rgba_of;
using test_support::SyntheticPicture;

FeatureCongestion congestion_of(const SyntheticPicture& picture) { return feature_congestion(LabLevels(rgba_of(picture))); }

double most_difference(const FloatMap& map, const test_support::Field& reference) {
    double most = 0;
    for (std::size_t n = 0; n < map.values.size(); ++n)
        most = std::max(most, std::fabs(static_cast<double>(map.values[n]) - reference.values[n]));
    return most;
}

TEST(FeatureCongestion, AgreesWithDirectSums) {
    for (const SyntheticPicture& picture : {landscape(60, 44, 1), noise_picture(37, 29, 4, 60, 40), noise_picture(9, 5, 2)}) {
        const FeatureCongestion ours = congestion_of(picture);
        const test_support::Field reference = test_support::congestion_reference(picture.view());
        double mean = 0;
        for (const double value : reference.values) mean += value / static_cast<double>(reference.values.size());
        EXPECT_LT(most_difference(ours.map, reference), 0.002 * reference.most());
        EXPECT_NEAR(ours.mean, mean, 0.001 * mean);
    }
}

// Negative controls: the comparison sees each part that is missing.
TEST(FeatureCongestion, TheComparisonFindsWhatIsMissing) {
    const SyntheticPicture picture = landscape(48, 36, 1);
    const FeatureCongestion ours = congestion_of(picture);
    for (const test_support::CongestionControls controls :
         {test_support::CongestionControls{true, false, false}, {false, true, false}, {false, false, true}}) {
        const test_support::Field wrong = test_support::congestion_reference(picture.view(), controls);
        EXPECT_GT(most_difference(ours.map, wrong), 0.01 * wrong.most());
    }
}

TEST(FeatureCongestion, NothingInAFlatPicture) {
    for (const Rgb& color : {Rgb{0, 0, 0}, Rgb{200, 40, 90}, Rgb{255, 255, 255}}) {
        const FeatureCongestion congestion = congestion_of(flat_picture(33, 20, color));
        EXPECT_EQ(congestion.mean, 0);
        for (const float value : congestion.map.values) EXPECT_EQ(value, 0);
    }
    EXPECT_EQ(congestion_of(flat_picture(1, 1, {9, 99, 200})).mean, 0);
}

/// Dots on a grid: all grey, or in colours that are as light.
SyntheticPicture dots(int count, bool are_colored) {
    return {96, 72, [=](int x, int y) {
                static constexpr Rgb kColors[] = {{245, 165, 140}, {135, 200, 130}, {155, 182, 240}};
                const int n = y / 24 * 4 + x / 24;
                if (n >= count || std::abs(x % 24 - 12) > 4 || std::abs(y % 24 - 12) > 4) return Rgb{90, 90, 90};
                return are_colored ? kColors[n % 3] : Rgb{180, 180, 180};
            }};
}

TEST(FeatureCongestion, MoreThingsAndMoreColorsAreMoreClutter) {
    double before = 0;
    for (const int count : {1, 2, 4, 8, 12}) {
        const double grey = congestion_of(dots(count, false)).mean;
        EXPECT_GT(grey, before);
        EXPECT_GT(congestion_of(dots(count, true)).mean, grey) << count;
        before = grey;
    }
}

TEST(FeatureCongestion, NoiseIsMoreThanTextureThanFaintTexture) {
    const auto stripes = [](std::uint8_t level) {
        return SyntheticPicture(96, 72, [=](int x, int) { return x / 4 % 2 == 0 ? Rgb{90, 90, 90} : Rgb{level, level, level}; });
    };
    const double faint = congestion_of(stripes(96)).mean, texture = congestion_of(stripes(150)).mean,
                 noise = congestion_of(noise_picture(96, 72, 3)).mean;
    EXPECT_GT(faint, 0);
    EXPECT_GT(texture, faint);
    EXPECT_GT(noise, texture);
}

// The map says where: to the right, where the picture is full.
TEST(FeatureCongestion, TheMapIsHighWhereThingsAre) {
    const SyntheticPicture noise = noise_picture(160, 60, 5);
    const SyntheticPicture half(160, 60, [&](int x, int y) { return x < 80 ? Rgb{90, 90, 90} : noise.at(x, y); });
    const FloatMap map = congestion_of(half).map;
    EXPECT_EQ(map.width, 160u);
    EXPECT_LT(map.at(4, 30), 0.05f * map.at(140, 30));
}

TEST(FeatureCongestion, TurnsAndMirrorsWithThePicture) {
    const SyntheticPicture picture = landscape(64, 48, 2);
    const FeatureCongestion upright = congestion_of(picture), mirrored = congestion_of(picture.mirrored()),
                            turned = congestion_of(picture.turned());
    EXPECT_NEAR(mirrored.mean, upright.mean, 1e-4 * upright.mean);
    EXPECT_NEAR(turned.mean, upright.mean, 1e-4 * upright.mean);
    for (std::uint32_t y = 0; y < 48; ++y)
        for (std::uint32_t x = 0; x < 64; ++x) {
            ASSERT_NEAR(mirrored.map.at(63 - x, y), upright.map.at(x, y), 0.01);
            ASSERT_NEAR(turned.map.at(47 - y, x), upright.map.at(x, y), 0.01);
        }
}

}  // namespace
}  // namespace tedavis::host_sim::test_feature_congestion
