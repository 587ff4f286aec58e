#include "host_sim/scene_builder/grid_preparation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tedavis::host_sim::test_grid_preparation {
namespace {

using scene::Uncertainty;
using scene::ValueState;

const float kNone = std::numeric_limits<float>::quiet_NaN();

PreparedPlane plane_of(int columns, int rows, std::vector<float> values, double level = 0.1) {
    PreparedPlane plane;
    plane.columns = columns;
    plane.rows = rows;
    for (const float value : values) plane.states.push_back(std::isnan(value) ? ValueState::missing : ValueState::valid);
    plane.uncertainties.assign(values.size(), Uncertainty::from_level(level));
    plane.values = std::move(values);
    return plane;
}

TEST(GridPreparation, GapsAreFilledMarkedAndUnsure) {
    PreparedPlane plane = plane_of(5, 1, {10, kNone, kNone, kNone, 20});
    fill_gaps(plane, 1.5, 0.25);
    EXPECT_EQ(plane.values[1], 10);
    EXPECT_TRUE(std::isnan(plane.values[2])) << "too far from both";
    EXPECT_EQ(plane.values[3], 20);
    EXPECT_EQ(plane.states[1], ValueState::interpolated);
    EXPECT_EQ(plane.states[0], ValueState::valid);
    EXPECT_NEAR(plane.uncertainties[1].level(), 0.35, 2.0 / 254);
    EXPECT_NEAR(plane.uncertainties[0].level(), 0.1, 1.0 / 254) << "known ones stay as sure as they were";
    plane = plane_of(5, 1, {10, kNone, kNone, kNone, 20});
    fill_gaps(plane, 3, 0.25);
    EXPECT_NEAR(plane.values[2], 15, 1e-5);
    EXPECT_NEAR(plane.values[1], (10 + 20 / 9.0) / (1 + 1 / 9.0), 1e-5);
    EXPECT_NEAR(plane.uncertainties[2].level(), 0.6, 2.0 / 254) << "two cells away";
}

TEST(GridPreparation, WithoutReachNothingIsFilled) {
    PreparedPlane plane = plane_of(3, 1, {1, kNone, 3});
    fill_gaps(plane, 0, 0.5);
    EXPECT_TRUE(std::isnan(plane.values[1]));
    PreparedPlane unknown = plane_of(3, 1, {1, kNone, 3});
    unknown.uncertainties[2] = {};
    fill_gaps(unknown, 1, 0.5);
    EXPECT_FALSE(unknown.uncertainties[1].is_known());
}

TEST(GridPreparation, SmoothingKeepsLevelFieldsAndGaps) {
    PreparedPlane plane = plane_of(6, 6, std::vector<float>(36, 7));
    plane.values[14] = kNone;
    smooth(plane, 1);
    for (std::size_t n = 0; n < 36; ++n) {
        if (n == 14)
            EXPECT_TRUE(std::isnan(plane.values[n]));
        else
            EXPECT_NEAR(plane.values[n], 7, 1e-5);
    }
    EXPECT_NEAR(plane.uncertainties[0].level(), 0.1, 2.0 / 254);
}

TEST(GridPreparation, SmoothingIsAGaussian) {
    PreparedPlane plane = plane_of(21, 1, std::vector<float>(21, 0));
    plane.values[10] = 1;
    smooth(plane, 2);
    double sum = 0, variance = 0;
    for (int n = 0; n < 21; ++n) {
        const auto value = double{plane.values[static_cast<std::size_t>(n)]};
        sum += value;
        variance += value * (n - 10) * (n - 10);
    }
    EXPECT_NEAR(sum, 1, 0.02);
    EXPECT_NEAR(variance / sum, 4, 0.35) << "cut at three standard deviations";
    PreparedPlane same = plane_of(3, 1, {1, 5, 2});
    smooth(same, 0);
    EXPECT_EQ(same.values, (std::vector<float>{1, 5, 2}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_preparation
