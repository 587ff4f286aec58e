#include "render_core/effects/clutter_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace tedavis::effects::test_clutter_budget {
namespace {

constexpr std::size_t kRegion = scene::DetailRegions::kAcross * 2 + 3;

ClutterMap of(float measure) {
    ClutterMap map;
    map.is_known = true;
    map.measure.fill(measure);
    return map;
}

double left(float whole, float least, double budget) {
    return static_cast<double>(detail_within({of(whole), of(least)}, budget).factor[kRegion]);
}

TEST(ClutterBudget, OnlyRegionsBeyondItLoseDetail) {
    ClutterMeasures measures{of(0.2f), of(0.1f)};
    measures.whole.measure[kRegion] = 0.5f;
    const scene::DetailRegions regions = detail_within(measures, 0.4);
    for (std::size_t n = 0; n < regions.factor.size(); ++n)
        EXPECT_FLOAT_EQ(regions.factor[n], n == kRegion ? 0.8125f : 1.0f) << n << ": a quarter of the way to a quarter of detail";
    EXPECT_FLOAT_EQ(static_cast<float>(regions.at(3.5 / 8, 2.5 / 6)), 0.8125f);
    EXPECT_EQ(regions.at(2.99 / 8, 2.5 / 6), 1);
    EXPECT_EQ(regions.at(4.01 / 8, 2.5 / 6), 1);
    EXPECT_EQ(regions.at(-3, 9), 1) << "beyond the screen";
    EXPECT_FALSE(regions.is_whole());
}

/// The model is what it says: a picture whose density changes in proportion comes to lie on the budget.
TEST(ClutterBudget, InProportionTheBudgetIsHeldExactlyWhereItCanBe) {
    for (const double budget : {0.1, 0.25, 0.4})
        for (float whole = 0.05f; whole < 0.9f; whole += 0.07f)
            for (float least = 0.01f; least < whole - 0.02f; least += 0.05f) {
                const double lost = (1 - left(whole, least, budget)) / (1 - kMinDetailLeft);
                const double reached = static_cast<double>(whole) - lost * static_cast<double>(whole - least);
                EXPECT_NEAR(reached, std::max(std::min(budget, static_cast<double>(whole)), static_cast<double>(least)), 1e-6);
            }
}

TEST(ClutterBudget, WhatIsNotEnoughGivesWayFurther) {
    const ClutterMeasures measures{of(0.5f), of(0.1f)};
    const scene::DetailRegions first = detail_within(measures, 0.3);
    ASSERT_NEAR(static_cast<double>(first.factor[kRegion]), 0.625, 1e-6);
    EXPECT_EQ(less_detail(first, of(0.29f), measures, 0.3, 1).factor, first.factor) << "it is";
    const scene::DetailRegions second = less_detail(first, of(0.4f), measures, 0.3, 1);
    EXPECT_NEAR(static_cast<double>(second.factor[kRegion]), 0.5, 1e-6) << "a third of the way that is left";
    EXPECT_EQ(less_detail(second, of(0.1f), measures, 0.05, 1).factor, second.factor) << "calmer it cannot be";
    EXPECT_NEAR(static_cast<double>(less_detail(first, of(0.4f), measures, 0.3, 2).factor[kRegion]), 0.375, 1e-6);
    EXPECT_EQ(less_detail(first, of(0.4f), measures, 0.3, 100).factor[kRegion], static_cast<float>(kMinDetailLeft));
    scene::DetailRegions left = first;
    for (int n = 0; n < 50; ++n) left = less_detail(left, of(0.45f), measures, 0.3, 1);
    EXPECT_NEAR(static_cast<double>(left.factor[kRegion]), kMinDetailLeft, 1e-3) << "but never less than the least";
}

TEST(ClutterBudget, TheLastResortTakesTheRegionsRoundItToo) {
    const ClutterMeasures measures{of(0.5f), of(0.1f)};
    ClutterMap reached = of(0.2f);
    reached.measure[0] = reached.measure[kRegion] = 0.5f;
    const scene::DetailRegions left = least_round(scene::DetailRegions(), reached, measures, 0.3);
    for (std::size_t n = 0; n < left.factor.size(); ++n) {
        const std::size_t column = n % scene::DetailRegions::kAcross, row = n / scene::DetailRegions::kAcross;
        const bool is_round = (column >= 2 && column <= 4 && row >= 1 && row <= 3) || (column <= 1 && row <= 1);
        EXPECT_EQ(left.factor[n], is_round ? static_cast<float>(kMinDetailLeft) : 1) << n;
    }
}

TEST(ClutterBudget, ExcessIsWhatCouldBeWithinTheBudgetAndIsNot) {
    ClutterMeasures measures{of(0.5f), of(0.1f)};
    EXPECT_EQ(excess(of(0.3f), measures, 0.3000001), 0);
    EXPECT_NEAR(excess(of(0.35f), measures, 0.3), 48 * 0.05, 1e-4);
    measures.least.measure[kRegion] = 0.5f;
    EXPECT_NEAR(excess(of(0.35f), measures, 0.3), 47 * 0.05, 1e-4) << "there nothing helps";
    ClutterMap unknown = of(0.9f);
    unknown.is_known = false;
    EXPECT_EQ(excess(unknown, measures, 0.3), 0);
}

TEST(ClutterBudget, MoreClutterOrLessBudgetNeverLeavesMore) {
    for (float whole = 0.1f; whole < 0.9f; whole += 0.05f)
        for (double budget = 0; budget <= 1; budget += 0.05) {
            EXPECT_GE(left(whole, 0.05f, budget), left(whole + 0.05f, 0.05f, budget));
            EXPECT_GE(left(whole, 0.05f, budget + 0.05), left(whole, 0.05f, budget));
            EXPECT_GE(left(whole, 0.05f, budget), kMinDetailLeft);
        }
}

TEST(ClutterBudget, WhereGivingWayHelpsNothingNothingGivesWay) {
    EXPECT_EQ(left(0.8f, 0.8f, 0.2), 1) << "clutter of the terrain's own";
    EXPECT_EQ(left(0.8f, 0.9f, 0.2), 1) << "fewer glyphs that are larger have more edges";
    EXPECT_EQ(left(0.8f, 0.5f, 0.2), kMinDetailLeft) << "control: it helps, but not enough";
}

TEST(ClutterBudget, WhatIsNotKnownTakesNothingAway) {
    ClutterMeasures measures{of(0.8f), of(0.1f)};
    EXPECT_FALSE(detail_within(measures, 0.1).is_whole()) << "control";
    EXPECT_TRUE(is_beyond(measures.whole, 0.1)) << "control";
    EXPECT_TRUE(detail_within(measures, 1).is_whole()) << "no budget";
    EXPECT_FALSE(is_beyond(of(1), 1)) << "no budget";
    measures.least.is_known = false;
    EXPECT_TRUE(detail_within(measures, 0.1).is_whole());
    measures = {of(0.8f), of(0.1f)};
    measures.whole.is_known = false;
    EXPECT_TRUE(detail_within(measures, 0.1).is_whole());
    EXPECT_FALSE(is_beyond(measures.whole, 0.1));
    const ClutterMap no_number = of(std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(detail_within({no_number, of(0)}, 0.1).is_whole());
    EXPECT_TRUE(detail_within({of(0.8f), no_number}, 0.1).is_whole());
    EXPECT_FALSE(is_beyond(no_number, 0.1));
}

}  // namespace
}  // namespace tedavis::effects::test_clutter_budget
