#include "host_sim/comparison/run_comparison.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_run_comparison {
namespace {

TEST(RunComparison, ARunDiffersNowhereFromItself) {
    for (const Alignment by : {Alignment::time, Alignment::place}) {
        AlignmentRequest request;
        request.by = by;
        const ComparedRun run = made_run("a", 30);
        const RunComparison runs = compared_runs(run, run, request);
        EXPECT_TRUE(runs.is_equal());
        EXPECT_EQ(runs.equal_pictures, 30u);
        EXPECT_TRUE(runs.settings.empty());
        for (const QuantityDifference& one : runs.quantities) EXPECT_EQ(one.greatest, 0) << kQuantities[one.quantity].name;
        EXPECT_EQ(runs.find(kCrowdedRegions), nullptr) << "no record has it";
        EXPECT_NE(runs.find(kAltitude), nullptr);
    }
}

/// Each change alone is a difference.
TEST(RunComparison, AChangedRunDiffers) {
    const ComparedRun run = made_run("a", 30);
    const auto is_equal_with = [&](auto change) {
        ComparedRun other = run;
        change(other.frames[7]);
        return compared_runs(run, other, {}).is_equal();
    };
    EXPECT_TRUE(is_equal_with([](ComparedFrame&) {}));
    EXPECT_FALSE(is_equal_with([](ComparedFrame& frame) { frame.values[kAltitude] += 1e-9; }));
    EXPECT_FALSE(is_equal_with([](ComparedFrame& frame) { frame.values[kLabelsPlaced] += 1; }));
    EXPECT_FALSE(is_equal_with([](ComparedFrame& frame) { frame.hash = "11"; }));
    EXPECT_FALSE(is_equal_with([](ComparedFrame& frame) { frame.phase = "approach.final"; }));
    EXPECT_FALSE(is_equal_with([](ComparedFrame& frame) { frame.terrain_alert = 1; }));
    EXPECT_FALSE(is_equal_with([](ComparedFrame& frame) { frame.effects = {"fog", "haze"}; }));
}

/// A flight that climbs, and the same a second later in the log.
TEST(RunComparison, AShiftedRunDiffersByItsShift) {
    ComparedRun a = made_run("a", 30), b = with_log(made_run("b", 30), "a.log");
    for (std::size_t n = 0; n < 30; ++n) {
        a.frames[n].values[kAltitude] = 1000 + 5 * static_cast<double>(n);
        b.frames[n].values[kAltitude] = 1000 + 5 * (static_cast<double>(n) - 1);
    }
    const RunComparison runs = compared_runs(a, b, {});
    const QuantityDifference& altitude = *runs.find(kAltitude);
    EXPECT_DOUBLE_EQ(altitude.mean_b - altitude.mean_a, -5);
    EXPECT_DOUBLE_EQ(altitude.greatest, -5);
    EXPECT_FALSE(runs.is_equal());
}

/// Exchanged runs have exchanged values and differences of the other sign.
TEST(RunComparison, ItIsSymmetricWhereTheTimesAreTheSame) {
    ComparedRun a = made_run("a", 30), b = with_log(made_run("b", 30), "a.log");
    for (std::size_t n = 0; n < 30; ++n) {
        a.frames[n].values[kLabelsPlaced] = static_cast<double>(n * 7 % 11);
        b.frames[n].values[kLabelsPlaced] = static_cast<double>(n * 5 % 13);
        b.frames[n].effects = {"fog"};
        b.frames[n].terrain_alert = n < 3 ? 1 : 0;
    }
    const RunComparison ab = compared_runs(a, b, {}), ba = compared_runs(with_log(b, "b.log"), with_log(a, "b.log"), {});
    const QuantityDifference &one = *ab.find(kLabelsPlaced), &other = *ba.find(kLabelsPlaced);
    EXPECT_DOUBLE_EQ(one.mean_a, other.mean_b);
    EXPECT_DOUBLE_EQ(one.median_b, other.median_a);
    EXPECT_EQ(one.greatest, -other.greatest);
    EXPECT_EQ(one.greatest_at, other.greatest_at);
    EXPECT_EQ(one.least_a_at, other.least_b_at);
    EXPECT_EQ(ab.terrain_b, ba.terrain_a);
    ASSERT_EQ(ab.effects.size(), 2u);
    EXPECT_EQ(ab.effects[0].name, "shadow") << "what differs most comes first";
    EXPECT_EQ(ab.effects[0].frames_a, 30u);
    EXPECT_EQ(ba.effects[0].frames_b, 30u);
}

/// Of B every fourth frame: each is the nearest one to several frames of A, and counts once.
TEST(RunComparison, AFrameCountsOnceHoweverManyInstantsItIsNearestTo) {
    ComparedRun a = made_run("a", 41), b = with_log(made_run("b", 11, 0, 4), "a.log");
    b.frames[5].terrain_alert = 2;
    b.frames[5].effects = {"haze", "haze"};  // of two layers
    b.frames[5].values[kLabelsPlaced] = 16;
    b.frames[5].values[kFrameTime] = 1000;
    const RunComparison runs = compared_runs(a, b, {});
    EXPECT_EQ(runs.aligned.instants.size(), 41u);
    EXPECT_EQ(runs.compared_a.size(), 41u);
    EXPECT_EQ(runs.compared_b.size(), 11u);
    EXPECT_EQ(runs.terrain_b, (AlertLevels{10, 0, 1}));
    EXPECT_EQ(runs.obstacles_b, (AlertLevels{11, 0, 0}));
    for (const EffectDifference& effect : runs.effects)
        EXPECT_EQ(effect.frames_b, effect.name == "haze" ? 1u : 10u) << effect.name;
    EXPECT_EQ(runs.find(kLabelsPlaced)->values_b, 11u);
    EXPECT_DOUBLE_EQ(runs.find(kLabelsPlaced)->sum_b(), 10 * 5 + 16);
    EXPECT_DOUBLE_EQ(runs.find(kLabelsPlaced)->mean_a, 5);
    EXPECT_EQ(runs.find(kAltitude)->values_b, 41u) << "interpolated at each instant";
}

/// Equally many frames with an alert, at other moments.
TEST(RunComparison, AlertsAtOtherMomentsAreADifference) {
    ComparedRun a = made_run("a", 30), b = a;
    a.frames[3].obstacle_alert = 1;
    b.frames[9].obstacle_alert = 1;
    EXPECT_FALSE(compared_runs(a, b, {}).is_equal());
}

TEST(RunComparison, TheClosestPointsAreThoseOfTheWholeRuns) {
    ComparedRun a = made_run("a", 30), b = with_log(made_run("b", 10, 10), "a.log");
    a.frames[2].values[kHeightAboveTerrain] = 50;  // before B begins
    const RunComparison runs = compared_runs(a, b, {});
    EXPECT_EQ(runs.find(kHeightAboveTerrain)->least_a, 400) << "of the instants";
    EXPECT_EQ(runs.closest_a->height_m, 50);
    EXPECT_EQ(runs.closest_a->time_s, 2);
    EXPECT_EQ(runs.closest_b->height_m, 400);
}

TEST(RunComparison, ListsTheSettingsThatDiffer) {
    ComparedRun a = made_run("a", 3), b = with_log(made_run("b", 3), "a.log");
    b.design = "cruise";
    const RunComparison runs = compared_runs(a, b, {});
    ASSERT_EQ(runs.settings.size(), 1u);
    EXPECT_EQ(runs.settings[0].name, "design");
    EXPECT_EQ(runs.settings[0].b, "cruise");
}

/// As of runs with --frames none: their pictures are neither equal nor unequal.
TEST(RunComparison, PicturesWithoutAHashAreNotCompared) {
    for (const char* unknown : {"", "0000000000000000"}) {
        ComparedRun a = made_run("a", 30), b = a;
        for (std::size_t n = 0; n < 20; ++n) a.frames[n].hash = b.frames[n + 10].hash = unknown;
        EXPECT_EQ(compared_runs(a, b, {}).known_pictures, 0u) << "each instant lacks one";
        EXPECT_EQ(compared_runs(a, a, {}).known_pictures, 10u);
        EXPECT_EQ(compared_runs(a, a, {}).equal_pictures, 10u);
        EXPECT_EQ(compared_runs(a, b, {}).equal_pictures, 0u);
        EXPECT_TRUE(compared_runs(a, b, {}).is_equal());
        ComparedRun c = a;
        c.frames[25].hash = "11";
        EXPECT_FALSE(compared_runs(a, c, {}).is_equal()) << "the others still count";
    }
}

TEST(RunComparison, MeasuredTimesAreNoDifference) {
    const ComparedRun a = made_run("a", 30);
    ComparedRun b = a;
    for (ComparedFrame& frame : b.frames) frame.values[kFrameTime] += static_cast<double>(frame.frame);
    b.frames[3].values[kFrameTime] = kUnknown;
    const RunComparison runs = compared_runs(a, b, {});
    EXPECT_EQ(runs.find(kFrameTime)->greatest, 29) << "it is told all the same";
    EXPECT_TRUE(runs.is_equal());
}

TEST(RunComparison, WhatOneRunAloneKnowsIsADifference) {
    ComparedRun a = made_run("a", 30), b = a;
    for (std::size_t n = 0; n < 12; ++n) b.frames[n].values[kAltitude] = kUnknown;
    const RunComparison runs = compared_runs(a, b, {});
    EXPECT_EQ(runs.known_by_one[kAltitude], 12u);
    EXPECT_EQ(runs.find(kAltitude)->count, 18u);
    EXPECT_FALSE(runs.is_equal());
    EXPECT_TRUE(compared_runs(b, b, {}).is_equal()) << "what neither knows is none";
    for (ComparedFrame& frame : b.frames) frame.values[kAltitude] = kUnknown;
    EXPECT_EQ(compared_runs(a, b, {}).find(kAltitude), nullptr);
    EXPECT_FALSE(compared_runs(a, b, {}).is_equal()) << "it is nowhere known to both";
}

/// An aircraft on the runway is not in flight, and without the phase none is known to be.
TEST(RunComparison, TheClosestPointNeedsAPhase) {
    ComparedRun a = made_run("a", 30);
    a.frames[0].values[kHeightAboveTerrain] = 0;
    for (const char* phase : {"unknown", "", "ground"}) {
        a.frames[0].phase = phase;
        EXPECT_EQ(compared_runs(a, a, {}).find(kHeightAboveTerrain)->least_a, 400) << phase;
    }
    for (ComparedFrame& frame : a.frames) frame.phase = "unknown";
    EXPECT_TRUE(std::isnan(compared_runs(a, a, {}).find(kHeightAboveTerrain)->least_a));
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_comparison
