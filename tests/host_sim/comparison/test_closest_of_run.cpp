#include "host_sim/comparison/closest_of_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_closest_of_run {
namespace {

using ::testing::HasSubstr;

ComparedRun with_summary(const char* closest) {
    ComparedRun run = made_run("a", 10);
    run.frames[3].values[kHeightAboveTerrain] = 150;
    run.closest = nlohmann::ordered_json::parse(closest);
    return run;
}

TEST(ClosestOfRun, IsThatOfTheSummary) {
    const auto closest = closest_of_run(with_summary(
        R"({"left_out_s": 30, "by_height": [{"time_s": 3.25, "lat_deg": 46.5, "lon_deg": 9.5, "height_above_terrain_m": 95.5, "phase": "approach",
            "sub_phase": "final"}, {"time_s": 9, "height_above_terrain_m": 90}]})"));
    ASSERT_TRUE(closest.has_value());
    EXPECT_EQ(closest->height_m, 95.5) << "the first of its points";
    EXPECT_EQ(closest->time_s, 3.25);
    EXPECT_EQ(closest->latitude_deg, 46.5);
    EXPECT_EQ(closest->longitude_deg, 9.5);
    EXPECT_EQ(closest->phase, "approach.final");
    EXPECT_TRUE(closest->is_of_summary && closest->has_place());
    EXPECT_THAT(searched_words(*closest),
                HasSubstr("its whole run, between its frames too, but for 30 s of take-off and landing"));
    EXPECT_EQ(closest->unknown_s, 0);
}

TEST(ClosestOfRun, SaysWhereNothingWasKnown) {
    const auto closest = closest_of_run(
        with_summary(R"({"left_out_s": 30, "unknown_s": 410.2, "by_height": [{"time_s": 3, "height_above_terrain_m": 95}]})"));
    ASSERT_TRUE(closest.has_value());
    EXPECT_EQ(closest->unknown_s, 410.2);
    EXPECT_EQ(searched_words(*closest),
              "its whole run, between its frames too, but for 30 s of take-off and landing and 410 s without a position or known "
              "ground");
}

TEST(ClosestOfRun, WithoutThatItIsTheLowestFrameInFlight) {
    for (const char* none :
         {"null", "{}", R"({"by_height": []})", R"({"by_height": [{"time_s": 1}]})", R"({"by_height": [7]})"}) {
        ComparedRun run = with_summary(none);
        run.frames[5].values[kHeightAboveTerrain] = 0;
        run.frames[5].phase = "approach.landing";
        run.frames[6].values[kHeightAboveTerrain] = kUnknown;
        const auto closest = closest_of_run(run);
        ASSERT_TRUE(closest.has_value()) << none;
        EXPECT_EQ(closest->height_m, 150) << none;
        EXPECT_EQ(closest->time_s, 3);
        EXPECT_EQ(closest->latitude_deg, run.frames[3].latitude_deg);
        EXPECT_FALSE(closest->is_of_summary);
        EXPECT_THAT(searched_words(*closest), HasSubstr("its frames in flight"));
    }
}

TEST(ClosestOfRun, NeedsAPhaseAndAHeight) {
    ComparedRun run = with_summary("null");
    for (ComparedFrame& frame : run.frames) frame.phase = "unknown";
    EXPECT_FALSE(closest_of_run(run).has_value());
    for (ComparedFrame& frame : run.frames) frame.phase = "cruise", frame.values[kHeightAboveTerrain] = kUnknown;
    EXPECT_FALSE(closest_of_run(run).has_value());
    run.frames[4].values[kHeightAboveTerrain] = 300;
    run.frames[4].has_place = false;
    ASSERT_TRUE(closest_of_run(run).has_value());
    EXPECT_FALSE(closest_of_run(run)->has_place());
}

}  // namespace
}  // namespace tedavis::host_sim::test_closest_of_run
