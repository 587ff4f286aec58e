#include "render_core/design/band_widening.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "render_core/design/warning_bands.hpp"

namespace tedavis::design::test_band_widening {
namespace {

BandWidening widening_of(const WideningSettings& settings, const HeightAccuracy& accuracy) {
    return band_widening(settings, deviations_of_coverage(settings.coverage), accuracy);
}

TEST(BandWidening, QuantilesAreThoseOfTheTables) {
    // Abramowitz, Stegun, table 26.5 (upper tail 0.5, 0.1, 0.05, 0.01, 0.001).
    for (const auto& [coverage, deviations] :
         {std::pair{0.5, 0.0}, {0.9, 1.281551565545}, {0.95, 1.644853626951}, {0.99, 2.326347874041}, {0.999, 3.090232306168}})
        EXPECT_NEAR(deviations_of_coverage(coverage), deviations, 1e-9) << coverage;
}

TEST(BandWidening, AddsTheVariancesByTheirConventions) {
    const BandWidening got = widening_of({}, {19.59964, 16.44854});
    EXPECT_NEAR(got.position_sigma_m, 10, 1e-9);
    EXPECT_NEAR(got.terrain_sigma_m, 10, 1e-9);
    EXPECT_NEAR(got.lowered_m, 1.644853626951 * std::sqrt(200.0), 1e-6);
    EXPECT_FALSE(got.position_assumed || got.terrain_assumed);
}

TEST(BandWidening, WhatNobodyStatesTheDesignAssumesAndSaysSo) {
    WideningSettings settings;
    settings.terrain_accuracy_m = 100;
    const BandWidening unknown_terrain = widening_of(settings, {10, 0});
    EXPECT_TRUE(unknown_terrain.terrain_assumed);
    EXPECT_FALSE(unknown_terrain.position_assumed);
    EXPECT_NEAR(unknown_terrain.terrain_sigma_m, 100 / 1.644854, 1e-9);
    const BandWidening unknown_position = widening_of(settings, {std::nan(""), 10});
    EXPECT_TRUE(unknown_position.position_assumed);
    EXPECT_GT(unknown_position.lowered_m, 0);
    settings.enabled = false;
    EXPECT_EQ(widening_of(settings, {10, 10}).lowered_m, 0);
}

/// The greater an uncertainty or the coverage, the lower the limits: what was coloured stays coloured.
TEST(BandWidening, ColoredTerrainOnlyGrowsWithUncertainty) {
    const WarningBands bands = egpws_bands();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> accuracy(0.1, 200), coverage(0.5, 0.999), height(-1000, 1000);
    for (int n = 0; n < 2000; ++n) {
        HeightAccuracy less{accuracy(random), accuracy(random)}, more = less;
        WideningSettings settings, stricter;
        settings.coverage = stricter.coverage = coverage(random);
        if (n % 3 == 0) more.position_m *= 1.3;
        if (n % 3 == 1) more.terrain_m *= 1.3;
        if (n % 3 == 2) stricter.coverage = 0.5 * (1 + settings.coverage);
        const double lowered = widening_of(settings, less).lowered_m, further = widening_of(stricter, more).lowered_m;
        EXPECT_GT(further, lowered);
        const double above_m = height(random);
        EXPECT_LE(band_of(bands, above_m + further, false), band_of(bands, above_m + lowered, false))
            << "never a band of less danger";
    }
}

/// The oracle is chance itself: errors are drawn, and terrain at a limit is coloured as often as the design asks.
TEST(BandWidening, TerrainAtALimitHasItsColorAsOftenAsAsked) {
    std::mt19937 random(11);
    for (const double coverage : {0.8, 0.95, 0.99}) {
        WideningSettings settings;
        settings.coverage = coverage;
        const double lowered = widening_of(settings, {30, 16}).lowered_m;
        std::normal_distribution<double> position(0, 30 / 1.959964), terrain(0, 16 / 1.644854);
        constexpr int kTimes = 100'000;
        int colored = 0;
        for (int n = 0; n < kTimes; ++n) colored += terrain(random) - position(random) >= -lowered ? 1 : 0;
        EXPECT_NEAR(static_cast<double>(colored) / kTimes, coverage, 0.005);
    }
}

}  // namespace
}  // namespace tedavis::design::test_band_widening
