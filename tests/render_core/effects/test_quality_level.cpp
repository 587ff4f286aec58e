#include "render_core/effects/quality_level.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/six_levels.hpp"

namespace tedavis::effects::test_quality_level {
namespace {

std::string_view first_fault(const QualityLevels& levels) {
    for (std::size_t n = 0; n < levels.count; ++n)
        if (const std::string_view fault = fault_of(levels, n); !fault.empty()) return fault;
    return {};
}

TEST(QualityLevels, TheDesignsOwnPictureIsTheFirstOne) {
    QualityLevels levels = test_support::six_levels();
    EXPECT_EQ(first_fault(levels), "");
    EXPECT_EQ(first_fault(QualityLevels()), "");
    levels.at[0].tau_factor = 1.2;
    EXPECT_NE(fault_of(levels, 0), "");
    levels.at[0] = {1, 0.9, {}, 60, 1, 0};
    EXPECT_NE(fault_of(levels, 0), "");
    levels.at[0] = {1, 1, levels.at[1].given_up, 60, 1, 0};
    EXPECT_NE(fault_of(levels, 0), "");
    levels.at[0] = {1, 1, {}, 60, 1, 0.1};
    EXPECT_NE(fault_of(levels, 0), "") << "it does not differ from itself";
}

TEST(QualityLevels, EachKeepsNoMoreThanTheOneBeforeAndIsCheaper) {
    const auto fault_with = [](const auto& change) {
        QualityLevels levels = test_support::six_levels();
        change(levels.at[3]);
        return first_fault(levels);
    };
    const std::string_view kKeeps = "a quality level must keep no more than the one before it";
    EXPECT_EQ(fault_with([](QualityLevel& level) { level.tau_factor = 1.9; }), kKeeps);
    EXPECT_EQ(fault_with([](QualityLevel& level) { level.detail_factor = 0.7; }), kKeeps);
    EXPECT_EQ(fault_with([](QualityLevel& level) { level.given_up.remove(Effect::antialiasing); }), kKeeps);
    EXPECT_EQ(fault_with([](QualityLevel& level) { level.ms = 40; }).substr(0, 21), "of two quality levels");
    EXPECT_EQ(fault_with([](QualityLevel& level) {
                  level.ms = 45;
                  level.error_color = 0.9;  // not dominated, but out of order
              }),
              "a quality level must take less time than the one before it");
    EXPECT_EQ(fault_with([](QualityLevel& level) { level.error_px = level.error_color = 0.1; }).substr(0, 21),
              "of two quality levels")
        << "cheaper and more accurate than the level before, which is useless then";
}

/// Over every effect of the table.
TEST(QualityLevels, WhatSafetyNeedsIsGivenUpAtNoQualityLevel) {
    for (std::size_t e = 0; e < kEffectCount; ++e) {
        QualityLevels levels = test_support::six_levels();
        levels.at[5].given_up.add(static_cast<Effect>(e));
        EXPECT_EQ(first_fault(levels).empty(), row_of(static_cast<Effect>(e)).may_be_given_up) << e;
    }
    for (const Effect effect : {Effect::terrain, Effect::warning_colors, Effect::ground_data, Effect::adjacent, Effect::haze,
                                Effect::ridges, Effect::drape, Effect::vertical_lines, Effect::curtains, Effect::clutter})
        EXPECT_FALSE(row_of(effect).may_be_given_up) << row_of(effect).name;
}

TEST(QualityLevels, ALevelDominatesWhatIsNoBetterInAnything) {
    const QualityLevel level{2, 1, {}, 20, 2, 1};
    EXPECT_FALSE(dominates(level, level));
    EXPECT_TRUE(dominates(level, {2, 1, {}, 21, 2, 1}));
    EXPECT_TRUE(dominates(level, {2, 1, {}, 20, 2.5, 1}));
    EXPECT_TRUE(dominates(level, {2, 1, {}, 20, 2, 1.5}));
    EXPECT_FALSE(dominates(level, {2, 1, {}, 30, 3, 0.9}));
    EXPECT_FALSE(dominates(level, {2, 1, {}, 19, 3, 3}));
}

TEST(QualityLevels, TerrainIsNeverSoCoarseThatItWouldLoseItsWarningColors) {
    const QualityLevels levels = test_support::six_levels();
    EXPECT_EQ(tau_px_on(levels.at[0], 1, 4), 1);
    EXPECT_EQ(tau_px_on(levels.at[2], 1, 4), 2);
    EXPECT_EQ(tau_px_on(levels.at[5], 1.5, 4), 4) << "not 6";
    EXPECT_EQ(tau_px_on(levels.at[5], 5, 4), 5) << "a design that asks for more is not made finer";
}

TEST(QualityLevels, CountersThereAndBackAreNeverTooSmall) {
    FrameCounters counters;
    counters.megapixels = 1;
    counters.triangles = 100'000;
    counters.glyphs = 4000;
    counters.elements = 7;
    const Quality fine{1, 1}, coarse{4, 0.2};
    const FrameCounters less = counters_at(counters, fine, coarse);
    // Measured powers lie between 0.1 and 1, most above 0.3: 66,000 triangles.
    EXPECT_GE(less.triangles, 65'000);
    EXPECT_LT(less.triangles, counters.triangles);
    EXPECT_LT(less.glyphs, counters.glyphs / 20);
    EXPECT_EQ(less.elements, 7) << "features of the scene stay";
    EXPECT_EQ(less.megapixels, 1);
    const FrameCounters back = counters_at(less, coarse, fine);
    EXPECT_GE(back.triangles, counters.triangles);
    EXPECT_NEAR(back.glyphs, counters.glyphs, 1e-6);
    EXPECT_EQ(counters_at(counters, fine, fine).triangles, counters.triangles);
}

}  // namespace
}  // namespace tedavis::effects::test_quality_level
