#include "host_sim/evaluation/subband_entropy.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/evaluation/steerable_bands.hpp"
#include "tests/host_sim/evaluation/rgba_of.hpp"
#include "tests/support/perception/itti_reference.hpp"

namespace tedavis::host_sim::test_subband_entropy {
namespace {

using test_support::flat_picture;
using test_support::landscape;
using test_support::noise_picture;
using test_support::Rgb;
using test_support::rgba_of;
using test_support::SyntheticPicture;

double entropy_in(const SyntheticPicture& picture) { return subband_entropy(LabLevels(rgba_of(picture))); }

/// Bits by sorting the values into their steps one after the other.
double bits_directly(const ValueMap& band) {
    std::vector<double> sorted = band.values;
    std::sort(sorted.begin(), sorted.end());
    const double count = static_cast<double>(sorted.size()), steps = std::ceil(std::sqrt(count));
    double bits = 0;
    std::size_t next = 0;
    for (double step = 1; step <= steps; ++step) {
        const double end = sorted.front() + (sorted.back() - sorted.front()) * step / steps;
        const std::size_t first = next;
        while (next < sorted.size() && (sorted[next] < end || step == steps)) ++next;
        const double share = static_cast<double>(next - first) / count;
        if (share > 0) bits -= share * std::log(share) / std::log(2.0);
    }
    return bits;
}

TEST(SubbandEntropy, AgreesWithTheWeightedMeanOverTheBands) {
    const SyntheticPicture picture = landscape(80, 48, 3);
    const auto lab = test_support::reference_lab(picture.view());
    double expected = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        ValueMap map(80, 48);
        map.values = lab[c].values;
        for (const ValueMap& band : steerable_bands(map)) expected += (c == 0 ? 0.84 : 0.08) * bits_directly(band) / 13;
    }
    EXPECT_NEAR(entropy_in(picture), expected, 0.003 * expected) << "values near the border of a step differ";
}

TEST(SubbandEntropy, NothingInAFlatPicture) {
    EXPECT_EQ(entropy_in(flat_picture(33, 20, {200, 40, 90})), 0);
    EXPECT_EQ(entropy_in(flat_picture(1, 1, {9, 99, 200})), 0);
}

TEST(SubbandEntropy, NoiseIsMoreThanTextureThanNothing) {
    const SyntheticPicture stripes(96, 72, [](int x, int) { return x / 6 % 2 == 0 ? Rgb{90, 90, 90} : Rgb{150, 150, 150}; });
    const double texture = entropy_in(stripes), noise = entropy_in(noise_picture(96, 72, 3));
    EXPECT_GT(texture, 0);
    EXPECT_GT(noise, 1.5 * texture);
}

/// Disks by chance, more and more of them.
SyntheticPicture disks(std::uint32_t count) {
    return {160, 120, [=](int x, int y) {
                for (std::uint32_t n = 0; n < count; ++n) {
                    const int across = x - static_cast<int>(test_support::scrambled(n, 1, 1) % 160),
                              down = y - static_cast<int>(test_support::scrambled(n, 2, 1) % 120);
                    const auto level = static_cast<std::uint8_t>(120 + test_support::scrambled(n, 3, 1) % 120);
                    if (across * across + down * down < 30) return Rgb{level, level, level};
                }
                return Rgb{90, 90, 90};
            }};
}

TEST(SubbandEntropy, MoreThingsAreMoreClutter) {
    double before = 0;
    for (const std::uint32_t count : {1u, 4u, 16u, 64u}) {
        const double now = entropy_in(disks(count));
        EXPECT_GT(now, before) << count;
        before = now;
    }
}

// Colours count, if little; a negative control for the weights.
TEST(SubbandEntropy, ColorsCount) {
    const SyntheticPicture noise = noise_picture(96, 72, 6, 100, 60);
    const SyntheticPicture grey(96, 72, [&](int x, int y) {
        const Rgb color = noise.at(x, y);
        return Rgb{color[1], color[1], color[1]};
    });
    const double with = entropy_in(noise), without = entropy_in(grey);
    EXPECT_GT(with, 1.1 * without);
    EXPECT_LT(with, 1.25 * without);
}

TEST(SubbandEntropy, TurnsAndMirrorsWithThePicture) {
    const SyntheticPicture picture = landscape(96, 64, 2);
    const double upright = entropy_in(picture);
    EXPECT_NEAR(entropy_in(picture.mirrored()), upright, 0.002 * upright);
    EXPECT_NEAR(entropy_in(picture.turned()), upright, 0.002 * upright);
}

TEST(SubbandEntropy, SidesOfAnyLength) {
    for (const auto& [width, height] : {std::pair{97, 61}, std::pair{3, 200}, std::pair{7, 7}})
        EXPECT_GT(entropy_in(noise_picture(width, height, 1)), 0.5) << width;
}

}  // namespace
}  // namespace tedavis::host_sim::test_subband_entropy
