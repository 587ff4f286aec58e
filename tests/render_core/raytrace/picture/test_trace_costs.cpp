#include "render_core/raytrace/picture/trace_costs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::raytrace {
namespace {

TEST(TraceCosts, FollowMeasurementsByAnExponentialMean) {
    TraceCosts costs;
    costs.expect(1, RegionKind::far, 3);
    EXPECT_EQ(costs.of(1, RegionKind::far), 3);
    costs.measure(1, RegionKind::far, 8);
    EXPECT_EQ(costs.of(1, RegionKind::far), 8);
    costs.measure(1, RegionKind::far, 4);
    EXPECT_EQ(costs.of(1, RegionKind::far), 7);
    for (const float wrong : {0.0f, -1.0f, std::nanf(""), HUGE_VALF}) costs.measure(1, RegionKind::far, wrong);
    EXPECT_EQ(costs.of(1, RegionKind::far), 7);
    for (int n = 0; n < 60; ++n) costs.measure(1, RegionKind::far, 2);
    EXPECT_NEAR(costs.of(1, RegionKind::far), 2, 1e-5);
    EXPECT_EQ(costs.of(1, RegionKind::near), 0);
}

TEST(TraceCosts, OfAWholePictureAreScaledToItsTime) {
    TraceCosts costs;
    costs.expect(0, RegionKind::far, 1);
    costs.expect(2, RegionKind::near, 4);
    costs.expect(2, RegionKind::far, 5);
    const RegionView regions[] = {{RegionKind::far, 1}, {RegionKind::near, 1}, {RegionKind::far, 1}};
    const std::uint8_t levels[] = {0, 2, 0};
    EXPECT_EQ(costs.sum(regions, levels), 6);
    for (int n = 0; n < 80; ++n) costs.measure_picture(regions, levels, 12);
    EXPECT_NEAR(costs.of(0, RegionKind::far), 2, 1e-3);
    EXPECT_NEAR(costs.of(2, RegionKind::near), 8, 1e-3);
    EXPECT_EQ(costs.of(2, RegionKind::far), 5);
    costs.measure_picture(regions, levels, std::nanf(""));
    EXPECT_NEAR(costs.sum(regions, levels), 12, 1e-2);
}

}  // namespace
}  // namespace tedavis::raytrace
