#include "host_sim/comparison/comparison_moments.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_comparison_moments {
namespace {

using ::testing::Contains;

ComparedRun pictured(const std::string& name) {
    ComparedRun run = with_log(made_run(name, 41), "same.log");
    for (ComparedFrame& frame : run.frames) frame.picture = "x.png";
    return run;
}

const ComparisonMoment* moment_at(const std::vector<ComparisonMoment>& moments, std::size_t instant) {
    for (const ComparisonMoment& moment : moments)
        if (moment.instant == instant) return &moment;
    return nullptr;
}

TEST(ComparisonMoments, AreSpreadOverEqualRuns) {
    const auto moments = comparison_moments(compared_runs(pictured("a"), pictured("b"), {}));
    ASSERT_EQ(moments.size(), 6u);
    for (std::size_t n = 0; n < 6; ++n) EXPECT_EQ(moments[n].instant, 8 * n);
    EXPECT_TRUE(moments.back().reasons.empty());
}

TEST(ComparisonMoments, ShowWhereRunsDifferMost) {
    ComparedRun a = pictured("a"), b = pictured("b");
    a.frames[3].values[kHeightAboveTerrain] = 100;
    b.frames[5].values[kHeightAboveTerrain] = 90;
    b.frames[11].values[kLabelsPlaced] = 9;
    b.frames[13].terrain_alert = 1;
    b.frames[17].phase = "approach.final";
    const auto moments = comparison_moments(compared_runs(a, b, {}));
    for (const auto& [instant, reason] : std::vector<std::pair<std::size_t, std::string>>{{3, "A is closest to the ground"},
                                                                                          {5, "B is closest to the ground"},
                                                                                          {11, "labels placed differ most"},
                                                                                          {13, "the terrain alerts differ first"},
                                                                                          {17, "the phases differ first"}}) {
        const ComparisonMoment* const moment = moment_at(moments, instant);
        ASSERT_NE(moment, nullptr) << instant;
        EXPECT_THAT(moment->reasons, Contains(reason));
    }
    for (std::size_t n = 1; n < moments.size(); ++n) EXPECT_LT(moments[n - 1].instant, moments[n].instant);
}

/// The closest point of the summary lies between two frames, or outside of what is compared.
TEST(ComparisonMoments, TheClosestPointIsThatOfTheSummary) {
    ComparedRun a = pictured("a"), b = pictured("b");
    a.frames[3].values[kHeightAboveTerrain] = 100;
    a.closest = nlohmann::ordered_json::parse(R"({"by_height": [{"time_s": 20.6, "height_above_terrain_m": 30}]})");
    b.closest = nlohmann::ordered_json::parse(R"({"by_height": [{"time_s": 900, "height_above_terrain_m": 30}]})");
    const auto moments = comparison_moments(compared_runs(a, b, {}));
    EXPECT_EQ(moment_at(moments, 4), nullptr);
    ASSERT_NE(moment_at(moments, 21), nullptr);
    EXPECT_THAT(moment_at(moments, 21)->reasons, Contains("A is closest to the ground"));
    for (const ComparisonMoment& moment : moments)
        for (const std::string& reason : moment.reasons) EXPECT_EQ(reason.find("B is closest"), std::string::npos);
}

TEST(ComparisonMoments, AreThoseOfWhichBothHaveThePicture) {
    ComparedRun a = pictured("a"), b = pictured("b");
    for (std::size_t n = 0; n < a.frames.size(); ++n) {
        if (n % 2 == 1) a.frames[n].picture.clear();
        if (n < 10) b.frames[n].picture.clear();
    }
    for (const ComparisonMoment& moment : comparison_moments(compared_runs(a, b, {}))) {
        EXPECT_GE(moment.instant, 10u);
        EXPECT_EQ(moment.instant % 2, 0u);
    }
    EXPECT_TRUE(comparison_moments(compared_runs(a, made_run("same", 41), {})).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_comparison_moments
