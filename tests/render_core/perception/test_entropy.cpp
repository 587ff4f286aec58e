#include "render_core/perception/entropy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tedavis::perception::test_entropy {
namespace {

double bits(const std::vector<std::uint32_t>& counts) { return shannon_entropy(counts); }

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
