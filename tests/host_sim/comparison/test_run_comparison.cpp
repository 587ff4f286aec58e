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
    EXPECT_EQ(ab.effects[0].instants_a, 30u);
    EXPECT_EQ(ba.effects[0].instants_b, 30u);
}

TEST(RunComparison, ListsTheSettingsThatDiffer) {
    ComparedRun a = made_run("a", 3), b = with_log(made_run("b", 3), "a.log");
    b.design = "cruise";
    const RunComparison runs = compared_runs(a, b, {});
    ASSERT_EQ(runs.settings.size(), 1u);
    EXPECT_EQ(runs.settings[0].name, "design");
    EXPECT_EQ(runs.settings[0].b, "cruise");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_comparison
