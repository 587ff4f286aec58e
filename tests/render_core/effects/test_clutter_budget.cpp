#include "render_core/effects/clutter_budget.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tedavis::effects::test_clutter_budget {
namespace {

ClutterMap of(float measure) {
    ClutterMap map;
    map.is_known = true;
    map.measure.fill(measure);
    return map;
}

TEST(ClutterBudget, OnlyRegionsBeyondItLoseDetail) {
    ClutterMap map = of(0.2f);
    map.measure[scene::DetailRegions::kAcross * 2 + 3] = 0.8f;
    const scene::DetailRegions regions = detail_within(map, 0.4);
    for (std::size_t n = 0; n < regions.factor.size(); ++n)
        EXPECT_FLOAT_EQ(regions.factor[n], n == scene::DetailRegions::kAcross * 2 + 3 ? 0.5f : 1.0f) << n;
    EXPECT_FLOAT_EQ(static_cast<float>(regions.at(3.5 / 8, 2.5 / 6)), 0.5f);
    EXPECT_EQ(regions.at(2.99 / 8, 2.5 / 6), 1);
    EXPECT_EQ(regions.at(4.01 / 8, 2.5 / 6), 1);
    EXPECT_EQ(regions.at(-3, 9), 1) << "beyond the screen";
    EXPECT_FALSE(regions.is_whole());
}

TEST(ClutterBudget, MoreClutterOrLessBudgetNeverLeavesMore) {
    for (float measure = 0; measure < 1; measure += 0.05f)
        for (double budget = 0; budget <= 1; budget += 0.05) {
            const auto left = [](float clutter, double allowed) { return detail_within(of(clutter), allowed).factor[0]; };
            EXPECT_GE(left(measure, budget), left(measure + 0.05f, budget));
            EXPECT_GE(left(measure, budget + 0.05), left(measure, budget));
            EXPECT_GE(left(measure, budget), static_cast<float>(kLeastDetailLeft));
        }
}

TEST(ClutterBudget, WhatIsNotKnownTakesNothingAway) {
    ClutterMap unknown = of(1);
    unknown.is_known = false;
    EXPECT_TRUE(detail_within(unknown, 0.1).is_whole());
    EXPECT_TRUE(detail_within(of(std::numeric_limits<float>::quiet_NaN()), 0.1).is_whole());
    EXPECT_TRUE(detail_within(of(1), 1).is_whole()) << "no budget";
}

}  // namespace
}  // namespace tedavis::effects::test_clutter_budget
