#include "host_sim/importers/monotone_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tedavis::host_sim::test_monotone_curve {
namespace {

TEST(MonotoneCurve, PassesThroughItsSamplesAndNeverLeavesTheirRange) {
    std::mt19937 random(3);
    std::vector<double> times, values;
    for (double t = 0; times.size() < 300; t += 0.1 + static_cast<double>(random() % 100) / 20) {
        times.push_back(t);
        values.push_back(static_cast<double>(random() % 2000) - 1000);
    }
    const MonotoneCurve curve(times, values);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        EXPECT_EQ(curve.at(times[i]), values[i]);
        for (int k = 0; k <= 20; ++k) {
            const double value = curve.at(times[i] + (times[i + 1] - times[i]) * k / 20);
            EXPECT_GE(value, std::min(values[i], values[i + 1]));
            EXPECT_LE(value, std::max(values[i], values[i + 1]));
        }
    }
}

TEST(MonotoneCurve, RisesWhereTheSamplesRise) {
    const MonotoneCurve curve({0, 1, 2, 10, 11}, {0, 0.1, 5, 5.2, 50});
    double last = -1;
    for (double t = 0; t <= 11; t += 0.01) {
        EXPECT_GE(curve.at(t), last - 1e-12);
        last = curve.at(t);
    }
}

TEST(MonotoneCurve, IsALineThroughALine) {
    const MonotoneCurve curve({0, 1, 4, 5}, {2, 4, 10, 12});
    for (double t = 0; t <= 5; t += 0.1) EXPECT_NEAR(curve.at(t), 2 + 2 * t, 1e-12);
}

TEST(MonotoneCurve, HoldsOutsideAndSaysWhatItCovers) {
    const MonotoneCurve curve({1, 2, 12}, {5, 6, 7});
    EXPECT_EQ(curve.at(-100), 5);
    EXPECT_EQ(curve.at(100), 7);
    EXPECT_TRUE(curve.covers(1.5, 3));
    EXPECT_FALSE(curve.covers(5, 3));
    EXPECT_TRUE(curve.covers(5, 10));
    EXPECT_FALSE(curve.covers(0.9, 10));
    EXPECT_FALSE(curve.covers(12.1, 10));
    EXPECT_FALSE(MonotoneCurve().covers(0, 1));
    EXPECT_EQ(MonotoneCurve({3}, {8}).at(77), 8);
}

}  // namespace
}  // namespace tedavis::host_sim::test_monotone_curve
