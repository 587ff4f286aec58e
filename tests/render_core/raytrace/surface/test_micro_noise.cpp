#include "render_core/raytrace/surface/micro_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_micro_noise {
namespace {

using test_support::Dice;

MicroNoise noise_of(NoiseKind kind, std::uint32_t octaves = 3) {
    MicroNoise noise;
    noise.kind = kind;
    noise.octaves = octaves;
    noise.amplitude = 4;
    noise.frequency = 3;
    return noise;
}

TEST(MicroNoise, KeepsWithinItsAmplitudeAndUsesMostOfIt) {
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::gradient})
        for (const std::uint32_t octaves : {1u, 3u, 8u}) {
            Dice dice(octaves);
            double highest = 0;
            for (int n = 0; n < 200000; ++n)
                highest = std::max(
                    highest, std::abs(noise_at(noise_of(kind, octaves), dice.between(0, 9000), dice.between(0, 9000)).height));
            EXPECT_LE(highest, 4);
            EXPECT_GT(highest, octaves == 1 ? 3.4 : 2) << octaves;
        }
}

TEST(MicroNoise, GradientNoiseIsZeroOnItsLattice) {
    MicroNoise noise = noise_of(NoiseKind::gradient, 1);
    noise.frequency = 1;
    for (int n = 0; n < 200; ++n) EXPECT_EQ(noise_at(noise, n, 13).height, 0);
    noise.kind = NoiseKind::value;
    EXPECT_EQ(noise_at(noise, 5, 13).height, 4 * lattice_value(5, 13, noise.seed));
}

TEST(MicroNoise, SlopesAreDifferencesAndKeepWithinTheirBound) {
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::gradient}) {
        const MicroNoise noise = noise_of(kind);
        Dice dice(3);
        double steepest = 0;
        for (int n = 0; n < 100000; ++n) {
            const double x = dice.between(-50, 50), y = dice.between(-50, 50);
            const SurfacePoint point = noise_at(noise, x, y);
            constexpr double kStep = 1e-6;
            ASSERT_NEAR(point.slope_x,
                        (noise_at(noise, x + kStep, y).height - noise_at(noise, x - kStep, y).height) / (2 * kStep), 1e-3);
            ASSERT_NEAR(point.slope_y,
                        (noise_at(noise, x, y + kStep).height - noise_at(noise, x, y - kStep).height) / (2 * kStep), 1e-3);
            steepest = std::max({steepest, std::abs(point.slope_x), std::abs(point.slope_y)});
        }
        EXPECT_LE(steepest, steepest_slope(noise));
        EXPECT_GT(steepest, steepest_slope(noise) / 8);
    }
}

TEST(MicroNoise, GridsSideBySideHaveNoSeam) {
    MicroNoise left = noise_of(NoiseKind::gradient), right = left;
    left.first_column = (std::int64_t{1} << 33) - 512;
    right.first_column = std::int64_t{1} << 33;
    for (double y = 0; y < 20; y += 0.37) {
        EXPECT_EQ(noise_at(left, 512, y).height, noise_at(right, 0, y).height);
        EXPECT_EQ(noise_at(left, 513.5, y).height, noise_at(right, 1.5, y).height);
    }
}

TEST(MicroNoise, HasNoPeriodAndNoDirection) {
    // Means over many lattice points of products with neighbours: none beyond chance (4 sigma of 1 / 3 / sqrt n).
    constexpr int kPoints = 200000;
    for (const auto& [dx, dy] :
         {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1), std::pair(256, 0), std::pair(65536, 0)}) {
        double sum = 0;
        for (int n = 0; n < kPoints; ++n)
            sum += lattice_value(n % 500, n / 500, 1) * (dx == 0 && dy == 0 ? 1 : lattice_value(n % 500 + dx, n / 500 + dy, 1));
        EXPECT_LT(std::abs(sum / kPoints), 4 * (dx == 0 && dy == 0 ? 0.577 : 0.3333) / std::sqrt(kPoints)) << dx << ' ' << dy;
    }
}

TEST(MicroNoise, EveryBitOfAPlaceChangesHalfOfTheBits) {
    Dice dice(8);
    const auto bits_at = [](std::int64_t x, std::int64_t y, std::uint32_t seed) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(lattice_value(x, y, seed) * 0x1p31));
    };
    for (int bit = 0; bit < 64; ++bit) {
        int changed_x = 0, changed_y = 0;
        for (int n = 0; n < 400; ++n) {
            const auto x = static_cast<std::int64_t>(dice.bits()), y = static_cast<std::int64_t>(dice.bits());
            const auto flip = static_cast<std::int64_t>(std::uint64_t{1} << bit);
            changed_x += __builtin_popcount(bits_at(x, y, 5) ^ bits_at(x ^ flip, y, 5));
            changed_y += __builtin_popcount(bits_at(x, y, 5) ^ bits_at(x, y ^ flip, 5));
        }
        EXPECT_NEAR(changed_x / 400.0, 16, 1) << bit;
        EXPECT_NEAR(changed_y / 400.0, 16, 1) << bit;
    }
}

TEST(MicroNoise, IsTheSameOnEveryMachine) {
    // Written down once; no function of the C library takes part.
    EXPECT_NE(lattice_value(0, 0, 1), lattice_value(0, 0, 2));
    EXPECT_NEAR(lattice_value(123456, -654321, 7), -0.059644291643053293, 1e-9);
    EXPECT_NEAR(noise_at(noise_of(NoiseKind::gradient), 1000.25, 77.75).height, 1.204205324102114, 1e-12);
}

}  // namespace
}  // namespace tedavis::raytrace::test_micro_noise
