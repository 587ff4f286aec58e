#include "host_sim/reports/run_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_run_words {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr std::int64_t kNoon_s = 1'780'315'200;  // 2026-06-01T12:00:00Z

/// Ten frames a minute apart: six in take-off with terrain first, four in cruise with data first.
RunStory story_of(bool has_date, bool is_confirmed = true) {
    RunStory story(base::Time{0});
    for (int n = 0; n < 10; ++n) {
        FrameResult result = test_support::frame_result(static_cast<std::uint64_t>(n), 60.0 * n);
        const bool cruises = n >= 6;
        if (cruises) result.record.phase.phase = {flight::Scenario::cruise, 0};
        for (std::size_t aspect = 0; aspect < design::kMainAspects; ++aspect)
            EXPECT_TRUE(result.record.weights.try_push_back(
                {display::Name(design::kMainAspectNames[aspect]), aspect == (cruises ? 1u : 0u) ? 1.0 : 0.3, 1}));
        result.record.flight_time = {base::Time{(kNoon_s + 60 * n) * 1'000'000'000}, has_date, is_confirmed};
        static_cast<void>(story.add(result, 300, 60));
    }
    return story;
}

RunSummary summary() {
    RunSummary s;
    s.log = "/somewhere/alps.log";
    s.design = "designs/cruise.toml";
    s.device = "es3-mid";
    s.frames = 10;
    return s;
}

TEST(RunWords, DurationsAreWords) {
    EXPECT_EQ(duration_words(0.4), "0 s");
    EXPECT_EQ(duration_words(59.6), "1 min 00 s");
    EXPECT_EQ(duration_words(754), "12 min 34 s");
    EXPECT_EQ(duration_words(2 * 3600 + 5 * 60 + 3), "2 h 05 min");
}

TEST(RunWords, TheTitleIsTheDayAndTheTimeOfDay) {
    EXPECT_EQ(run_title(summary(), story_of(true)), "Flight of 2026-06-01, 12:00:00 to 12:09:00 UTC");
    EXPECT_THAT(run_title(summary(), story_of(true, false)), HasSubstr("(time not confirmed by the bus)"));
    EXPECT_EQ(run_title(summary(), story_of(false)), "Run of alps.log");
}

TEST(RunWords, ATimeIsThatOfTheDayWhereItIsKnown) {
    EXPECT_EQ(time_words(90, story_of(true)), "12:01:30");
    EXPECT_EQ(time_words(90, story_of(false)), "90.0 s");
}

TEST(RunWords, PhasesAndFirstAspectsAreAddedUp) {
    const auto sentences = run_sentences(summary(), story_of(true));
    EXPECT_THAT(sentences, Contains("Flight phases: takeoff 6 min 00 s, cruise 3 min 00 s."));
    EXPECT_THAT(sentences, Contains("The picture put first: terrain 6 min 00 s, data 3 min 00 s."));
    EXPECT_THAT(sentences.front(), HasSubstr("10 frames of 9 min 00 s of alps.log"));
}

void add(AlertHindrance hindrance, std::uint64_t frames, double minutes, TerrainAlertCounts& counts) {
    counts.frames_by[static_cast<std::size_t>(hindrance)] += frames;
    counts.hours_by[static_cast<std::size_t>(hindrance)] += minutes / 60;
    counts.hours += minutes / 60;
}

TEST(RunWords, AlertsAreSaidWithTheFalseOnes) {
    RunSummary s = summary();
    EXPECT_THAT(run_sentences(s, story_of(true)), Contains("Without terrain no terrain alert could be given."));
    add(AlertHindrance::none, 12, 12, s.terrain_alerts);
    s.terrain_frames = 10;
    EXPECT_THAT(run_sentences(s, story_of(true)), Contains("No terrain alert was given."));
    s.frames_over_void = 4;
    EXPECT_THAT(run_sentences(s, story_of(true)),
                Contains(HasSubstr("; in 4 frames the height of the ground below the aircraft was not known.")));
    s.terrain_alerts.count = 3;
    s.terrain_alerts.warnings = 1;
    s.terrain_alerts.false_count = 2;
    EXPECT_THAT(run_sentences(s, story_of(true)),
                Contains("3 terrain alerts were given, 1 with a warning; 2 were false, as the aircraft then kept clear of the "
                         "ground."));
    add(AlertHindrance::outside, 8, 8, s.terrain_alerts);
    EXPECT_THAT(run_sentences(s, story_of(true)),
                Contains(HasSubstr("; alerts were possible in 12 min 00 s of 20 min 00 s, for in the others the aircraft was "
                                   "outside the terrain database.")));
}

TEST(RunWords, WhereNoAlertWasPossibleItIsSaid) {
    RunSummary s = summary();
    TerrainAlertCounts& counts = s.terrain_alerts;
    add(AlertHindrance::degraded, 540, 9, counts);
    EXPECT_THAT(run_sentences(s, story_of(true)), Contains("No terrain alert could be given: in all frames the position or the "
                                                           "height was not reliable (TERRAIN DEGRADED)."));
    add(AlertHindrance::none, 180, 3, counts);
    EXPECT_THAT(run_sentences(s, story_of(true)),
                Contains("No terrain alert was given; alerts were possible in 3 min 00 s of 12 min 00 s, for in the others the "
                         "position or the height was not reliable (TERRAIN DEGRADED)."));
    counts.has_gaps = true;
    EXPECT_THAT(run_sentences(s, story_of(true)), Contains(HasSubstr("alerts were possible in 180 of 720 frames, for in the")));
    add(AlertHindrance::no_position, 600, 10, counts);
    EXPECT_THAT(run_sentences(s, story_of(true)),
                Contains(HasSubstr("for in the others the position was not known (600 frames) and the position or the height was "
                                   "not reliable (TERRAIN DEGRADED) (540 frames).")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_words
