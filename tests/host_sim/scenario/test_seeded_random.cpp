#include "host_sim/scenario/seeded_random.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_seeded_random {
namespace {

// The C++ standard states the 10000th number of a default-seeded mt19937_64 (5489): 9981545732273789042.
TEST(SeededRandom, IsTheStandardsGenerator) {
    SeededRandom random(5489);
    for (int i = 0; i < 9999; ++i) (void)random.unit();
    EXPECT_EQ(random.unit(), static_cast<double>(9981545732273789042u >> 11) * 0x1p-53);
}

TEST(SeededRandom, EqualSeedsGiveEqualNumbersOthersDoNot) {
    SeededRandom a(1), b(1), c(2);
    EXPECT_EQ(a.unit(), b.unit());
    EXPECT_NE(a.unit(), c.unit());
}

TEST(SeededRandom, StaysWithinItsSpread) {
    SeededRandom random(7);
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double value = random.within(10, 2);
        EXPECT_GE(value, 8);
        EXPECT_LT(value, 12);
        sum += value;
    }
    EXPECT_NEAR(sum / 10000, 10, 0.05);
    EXPECT_EQ(random.within(3, 0), 3);
}

}  // namespace
}  // namespace tedavis::host_sim::test_seeded_random
