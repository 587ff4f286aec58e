#include "render_core/effects/quality_level.hpp"

#include <gtest/gtest.h>

namespace tedavis::effects::test_quality_level {
namespace {

TEST(QualityLevels, EveryQualityLevelAsksForNoMoreThanTheOneBefore) {
    EXPECT_EQ(kQualityLevels[0].tau_factor, 1);
    EXPECT_EQ(kQualityLevels[0].detail_factor, 1);
    for (std::size_t n = 1; n < kQualityLevelCount; ++n) {
        EXPECT_GE(kQualityLevels[n].tau_factor, kQualityLevels[n - 1].tau_factor);
        EXPECT_LE(kQualityLevels[n].detail_factor, kQualityLevels[n - 1].detail_factor);
        for (std::size_t e = 0; e < kEffectCount; ++e) {
            const auto effect = static_cast<Effect>(e);
            EXPECT_LE(given_up_on(n - 1).has(effect), given_up_on(n).has(effect)) << row_of(effect).name;
        }
    }
}

TEST(QualityLevels, WhatSafetyNeedsIsGivenUpAtNoQualityLevel) {
    for (const Effect effect : {Effect::terrain, Effect::warning_colors, Effect::ground_data, Effect::adjacent, Effect::haze}) {
        EXPECT_EQ(row_of(effect).given_up_from, kNeverGivenUp) << row_of(effect).name;
        EXPECT_FALSE(given_up_on(kQualityLevelCount - 1).has(effect));
    }
}

TEST(QualityLevels, WhatEmbellishesGoesFirst) {
    EXPECT_LT(row_of(Effect::depth_of_field).given_up_from, row_of(Effect::antialiasing).given_up_from);
    EXPECT_LT(row_of(Effect::antialiasing).given_up_from, row_of(Effect::silhouettes).given_up_from);
}

TEST(QualityLevels, NothingIsGivenUpThatTheDesignGetsWhole) {
    for (std::size_t e = 0; e < kEffectCount; ++e) EXPECT_FALSE(given_up_on(0).has(static_cast<Effect>(e)));
}

TEST(QualityLevels, TerrainIsNeverSoCoarseThatItWouldLoseItsWarningColors) {
    EXPECT_EQ(tau_px_on(0, 1, 4), 1);
    EXPECT_EQ(tau_px_on(2, 1, 4), 2);
    EXPECT_EQ(tau_px_on(kQualityLevelCount - 1, 1.5, 4), 4) << "not 6";
    EXPECT_EQ(tau_px_on(kQualityLevelCount - 1, 5, 4), 5) << "a design that asks for more is not made finer";
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
