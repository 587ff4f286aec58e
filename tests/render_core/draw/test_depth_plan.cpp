#include "render_core/draw/depth_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace tedavis::draw::test_depth_plan {
namespace {

constexpr double kGap = 0.3e-3 * 1.01;  ///< of the distance, which must be told

/// The step of a 24-bit depth buffer that a depth falls on, by the projection itself.
std::int64_t step_of(const DepthRange& range, double depth_m) {
    const long double n = range.near_m, f = range.far_m, z = depth_m;
    const long double ndc = (f + n) / (f - n) - 2 * f * n / ((f - n) * z);
    return static_cast<std::int64_t>((ndc + 1) / 2 * 16777215.0L);
}

/// The least number of steps between two depths that are a gap apart, over the whole range.
std::int64_t least_steps(const DepthRange& range) {
    std::int64_t least = 1 << 24;
    for (double z = range.near_m; z * (1 + kGap) <= range.far_m; z *= 1.0007)
        least = std::min(least, step_of(range, z * (1 + kGap)) - step_of(range, z));
    return least;
}

TEST(DepthPlan, EveryGapIsToldFourStepsApart) {
    for (const double near_m : {0.5, 1.0, 5.0, 20.0, 50.0, 400.0})
        for (const double far_m : {2000.0, 20000.0, 100000.0, 400000.0}) {
            const DepthPlan plan = plan_depth(near_m, far_m);
            for (std::size_t n = 0; n < plan.count; ++n)
                EXPECT_GE(least_steps(plan.ranges[n]), 3) << near_m << " .. " << far_m << ", range " << n;
        }
    EXPECT_LT(least_steps({1, 400000}), 1) << "control: one range is not enough";
}

TEST(DepthPlan, TheRangesCoverEverythingAndOverlapTheFarOneFirst) {
    int parted = 0;
    for (const double near_m : {0.5, 5.0, 50.0})
        for (double far_m = 2.5 * near_m; far_m < 400000; far_m *= 1.3) {
            const DepthPlan plan = plan_depth(near_m, far_m);
            EXPECT_EQ(plan.ranges[plan.count - 1].near_m, near_m);
            EXPECT_EQ(plan.ranges[0].far_m, far_m);
            for (std::size_t n = 0; n < plan.count; ++n) EXPECT_LT(plan.ranges[n].near_m, plan.ranges[n].far_m);
            if (plan.count == 1) continue;
            ++parted;
            ASSERT_EQ(plan.count, 2u);
            EXPECT_LT(plan.ranges[0].near_m, plan.ranges[1].far_m);
            EXPECT_GT(plan.ranges[0].near_m, plan.ranges[1].near_m);
        }
    EXPECT_GT(parted, 10);
}

TEST(DepthPlan, OneRangeWhereItIsEnough) {
    EXPECT_EQ(plan_depth(20, 20000).count, 1u);
    EXPECT_EQ(plan_depth(1, 1000).count, 1u);
    EXPECT_EQ(plan_depth(1, 20000).count, 2u);
}

TEST(DepthPlan, RangesPartWhereTheNearerOneEnds) {
    const DepthPlan one = plan_depth(50, 2000), two = plan_depth(1, 400'000);
    EXPECT_EQ(one.parting_m(), 0);
    ASSERT_EQ(two.count, 2u);
    EXPECT_EQ(two.parting_m(), two.ranges[1].far_m);
    EXPECT_GT(two.parting_m(), two.ranges[0].near_m) << "in the overlap";
}

}  // namespace
}  // namespace tedavis::draw::test_depth_plan
