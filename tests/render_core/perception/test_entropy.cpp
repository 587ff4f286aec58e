#include "render_core/perception/entropy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/files/hard_case.hpp"

namespace tedavis::perception::test_entropy {
namespace {

double bits(const std::vector<std::uint32_t>& counts) { return shannon_entropy(counts); }

/// The formula as it is written: 0 log2 0 is no number, and neither is a share of no counts at all.
double bits_as_written(const std::vector<std::uint32_t>& counts) {
    double total = 0, sum = 0;
    for (const std::uint32_t count : counts) total += count;
    for (const std::uint32_t count : counts) sum -= count / total * std::log2(count / total);
    return sum;
}

TEST(Entropy, ZeroTimesItsLogarithmCountsAsZero) {
    struct Known {
        std::vector<std::uint32_t> counts;
        double bits;
    };
    double worst = 0, without = 0;
    int no_numbers = 0;
    for (const Known& known : {Known{{0, 0, 0}, 0}, {{0, 17, 0}, 0}, {{0, 5, 5}, 1}, {{1, 0, 2, 0, 1}, 1.5}}) {
        const double off = std::fabs(bits(known.counts) - known.bits);
        if (!(off <= worst)) worst = off;  // a NaN, too
        without = std::fabs(bits_as_written(known.counts) - known.bits);
        no_numbers += std::isnan(without) ? 1 : 0;
    }
    EXPECT_LE(worst, 1e-12);
    EXPECT_EQ(no_numbers, 4) << "control";
    EXPECT_NEAR(bits_as_written({1, 2, 1}), 1.5, 1e-12) << "where all are counted the naive form is right";
    test_support::record_worst("A41", worst);
    test_support::record_control("A41", without);
}

TEST(Entropy, ClosedCases) {
    EXPECT_EQ(bits({}), 0);
    EXPECT_EQ(bits({0, 0, 0}), 0) << "empty";
    EXPECT_EQ(bits({0, 17, 0}), 0) << "constant";
    EXPECT_EQ(bits({1}), 0) << "a single pixel";
    EXPECT_NEAR(bits({5, 5}), 1, 1e-12);
    EXPECT_NEAR(bits(std::vector<std::uint32_t>(256, 3)), 8, 1e-12);
    EXPECT_NEAR(bits({1, 2, 1}), 1.5, 1e-12);
    EXPECT_NEAR(bits({4'000'000'000u, 4'000'000'000u}), 1, 1e-12) << "sums are wider than counts";
}

TEST(Information, IsFiniteForEveryCount) {
    EXPECT_NEAR(information(0, 0), 1, 1e-12) << "nothing is known: as likely as not";
    EXPECT_NEAR(information(1, 1), -std::log2(2.0 / 3), 1e-12);
    EXPECT_NEAR(information(0, 1), -std::log2(1.0 / 3), 1e-12);
    EXPECT_NEAR(information(499, 998), 1, 1e-12) << "half of all";
    EXPECT_GT(information(1000, 1000), 0);
    EXPECT_LT(information(1000, 1000), 0.01);
    EXPECT_NEAR(information(0, 1022), 10, 1e-12);
    EXPECT_EQ(most_information(1022), information(0, 1022));
}

TEST(Information, FallsWithTheCount) {
    for (std::uint64_t count = 1; count <= 100; ++count) EXPECT_LT(information(count, 100), information(count - 1, 100));
}

}  // namespace
}  // namespace tedavis::perception::test_entropy
