#include "host_sim/importers/local_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_local_fit {
namespace {

const std::vector<double> kUneven = {0, 0.5, 1.7, 2.0, 3.1, 4.4, 5.0, 6.3, 9.0};

TEST(LocalFit, ReproducesAParabolaAtUnevenTimes) {
    std::vector<double> values;
    for (const double t : kUneven) values.push_back(1e6 + 3 * t - 0.7 * t * t);
    for (const double window : {0.1, 2.0, 100.0}) {
        const FittedSeries fitted = fit_locally(kUneven, values, window);
        for (std::size_t i = 0; i < kUneven.size(); ++i) {
            EXPECT_NEAR(fitted.values[i], values[i], 1e-6) << window;
            EXPECT_NEAR(fitted.slopes[i], 3 - 1.4 * kUneven[i], 1e-6) << window;
        }
    }
}

TEST(LocalFit, ThreeNeighboursPassThroughTheSamples) {
    const std::vector<double> values = {3, 1, 4, 1, 5, 9, 2, 6, 5};
    const FittedSeries fitted = fit_locally(kUneven, values, 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(fitted.values[i], values[i], 1e-9);
}

TEST(LocalFit, AveragesNoiseAway) {
    std::vector<double> times, values;
    for (int i = 0; i < 200; ++i) {
        times.push_back(i);
        values.push_back(10.0 + (i % 2 == 0 ? 1.0 : -1.0));
    }
    const FittedSeries fitted = fit_locally(times, values, 8);
    for (std::size_t i = 10; i < 190; ++i) EXPECT_LT(std::abs(fitted.values[i] - 10), 0.3);
}

TEST(LocalFit, TakesOneAndTwoSamples) {
    EXPECT_EQ(fit_locally({5}, {7}, 1).slopes[0], 0);
    const FittedSeries two = fit_locally({1, 3}, {2, 8}, 1);
    EXPECT_EQ(two.slopes[0], 3);
    EXPECT_EQ(two.slopes[1], 3);
    EXPECT_EQ(two.values[1], 8);
}

}  // namespace
}  // namespace tedavis::host_sim::test_local_fit
