#include "host_sim/scenario/seeded_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_seeded_waves {
namespace {

SeededWaves waves_of(std::uint64_t seed) {
    SeededRandom random(seed);
    return {random, 1'000, 4'000, 3'000};
}

TEST(SeededWaves, AreTheSameForEqualSeedsOnly) {
    EXPECT_EQ(waves_of(3).at(120, -40, 800), waves_of(3).at(120, -40, 800));
    EXPECT_NE(waves_of(3).at(120, -40, 800), waves_of(4).at(120, -40, 800));
}

TEST(SeededWaves, HaveMeanZeroAndVarianceOneOverManyLengths) {
    const SeededWaves waves = waves_of(1);
    double sum = 0, squares = 0, most = 0;
    constexpr int kSide = 300;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j) {
            const double value = waves.at(i * 330.0, j * 330.0, 0);
            sum += value;
            squares += value * value;
            most = std::max(most, std::abs(value));
        }
    EXPECT_NEAR(sum / kSide / kSide, 0, 0.02);
    EXPECT_NEAR(squares / kSide / kSide, 1, 0.05);
    EXPECT_LE(most, SeededWaves::kMax);
}

TEST(SeededWaves, AreSmooth) {
    const SeededWaves waves = waves_of(2);
    const double steepest_per_m = SeededWaves::kMax * 2 * 3.1416 / 1'000;
    for (double x = 0; x < 10'000; x += 50) EXPECT_LE(std::abs(waves.at(x + 50, 0, 0) - waves.at(x, 0, 0)), 50 * steepest_per_m);
}

}  // namespace
}  // namespace tedavis::host_sim::test_seeded_waves
