#include "host_sim/scenario/smoothed_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_smoothed_value {
namespace {

TEST(SmoothedValue, ReachesItsTargetWithoutOvershoot) {
    SmoothedValue value(0, 2, 100);
    for (int i = 0; i < 2000; ++i) {
        value.step(1, 0.01);
        EXPECT_LE(value.value(), 1 + 1e-9);
    }
    EXPECT_NEAR(value.value(), 1, 1e-9);
}

TEST(SmoothedValue, FollowsTheAnalyticStepResponse) {
    SmoothedValue value(0, 2, 100);
    for (int i = 1; i <= 300; ++i) {
        value.step(1, 0.001);
        const double t = i * 0.001;
        EXPECT_NEAR(value.value(), 1 - (1 + 2 * t) * std::exp(-2 * t), 2e-3);
    }
}

TEST(SmoothedValue, KeepsItsRateWithinTheLimit) {
    SmoothedValue value(0, 3, 0.5);
    double last = 0;
    for (int i = 0; i < 3000; ++i) {
        value.step(10, 0.01);
        EXPECT_LE(value.value() - last, 0.005 + 1e-12);
        last = value.value();
    }
    EXPECT_NEAR(value.value(), 10, 1e-3);
}

}  // namespace
}  // namespace tedavis::host_sim::test_smoothed_value
