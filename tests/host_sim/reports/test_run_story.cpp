#include "host_sim/reports/run_story.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_run_story {
namespace {

using test_support::frame_result;

TEST(RunStory, KeepsASampleAFrame) {
    RunStory story(base::Time{0});
    for (std::uint64_t n = 0; n < 10; ++n)
        (void)story.add(frame_result(n, 0.5 * static_cast<double>(n)), n == 3 ? std::nan("") : 250, 60);
    ASSERT_EQ(story.samples().size(), 10u);
    EXPECT_EQ(story.samples()[4].time_s, 2);
    EXPECT_EQ(story.samples()[4].altitude_msl_m, 1510);
    EXPECT_EQ(story.samples()[4].height_above_terrain_m, 250);
    EXPECT_EQ(story.samples()[4].ground_speed_mps, 60);
    EXPECT_EQ(story.samples()[4].total_ms, 3);
    EXPECT_TRUE(story.samples()[4].height_above_terrain_known);
    EXPECT_FALSE(story.samples()[3].height_above_terrain_known);
    EXPECT_TRUE(story.samples()[4].position_valid);
}

TEST(RunStory, LongRunsKeepEvenlySpacedSamplesFromTheirBeginning) {
    RunStory story(base::Time{0});
    for (std::uint64_t n = 0; n < 100'000; ++n) (void)story.add(frame_result(n, static_cast<double>(n)), 0, 0);
    ASSERT_LT(story.samples().size(), 4097u);
    ASSERT_GT(story.samples().size(), 1000u);
    const double step = story.samples()[1].time_s - story.samples()[0].time_s;
    EXPECT_EQ(story.samples()[0].time_s, 0);
    for (std::size_t i = 1; i < story.samples().size(); ++i)
        EXPECT_NEAR(story.samples()[i].time_s - story.samples()[i - 1].time_s, step, 1e-6);
    EXPECT_GT(story.samples().back().time_s, 100'000 - 2 * step);
}

TEST(RunStory, PhasesJoinWhileTheyAreTheSameFromTheSameSource) {
    RunStory story(base::Time{0});
    for (std::uint64_t n = 0; n < 9; ++n) {
        FrameResult result = frame_result(n, static_cast<double>(n));
        if (n >= 3) result.record.phase.phase = flight::kTakeoffStart;
        if (n >= 6) result.record.phase.source = flight::PhaseSource::motion;
        (void)story.add(result, 0, 0);
    }
    ASSERT_EQ(story.phases().size(), 3u);
    EXPECT_EQ(story.phases()[0].phase, "takeoff.first_climb");
    EXPECT_EQ(story.phases()[0].source, "can");
    EXPECT_EQ(story.phases()[0].end_s, 3);
    EXPECT_EQ(story.phases()[1].phase, "takeoff.start");
    EXPECT_EQ(story.phases()[1].begin_s, 3);
    EXPECT_EQ(story.phases()[1].end_s, 6);
    EXPECT_EQ(story.phases()[2].source, "motion");
    EXPECT_EQ(story.phases()[2].end_s, 8);
}

TEST(RunStory, FlagsKnowFirstLastAndHowOften) {
    RunStory story(base::Time{0});
    for (std::uint64_t n = 0; n < 10; ++n) {
        FrameResult result = frame_result(n, static_cast<double>(n));
        const bool raised = n == 2 || n == 3 || n == 7;
        ASSERT_TRUE(!raised || result.record.flags.try_push_back(display::Name("altitude.stale")));
        (void)story.add(result, 0, 0);
    }
    ASSERT_EQ(story.flags().size(), 1u);
    const RunStory::FlagSpan& span = story.flags().at("altitude.stale");
    EXPECT_EQ(span.first_s, 2);
    EXPECT_EQ(span.last_s, 7);
    EXPECT_EQ(span.frames, 3u);
}

TEST(RunStory, PicturesAreFewAndSmallAndSpread) {
    RunStory story(base::Time{0});
    const RgbaPicture picture{800, 4, std::vector<std::uint8_t>(800 * 4 * 4, 77)};
    for (std::uint64_t n = 0; n < 1000; ++n) {
        const FrameResult result = frame_result(n, static_cast<double>(n));
        if (story.add(result, 0, 0)) story.add_picture(result, view_of(picture));
    }
    EXPECT_GE(story.thumbnails().size(), 12u);
    EXPECT_LT(story.thumbnails().size(), 32u);
    EXPECT_EQ(story.thumbnails()[0].frame, 0u);
    EXPECT_GT(story.thumbnails().back().frame, 900u);
    EXPECT_EQ(story.thumbnails()[0].png.substr(1, 3), "PNG");
    EXPECT_EQ(story.thumbnails()[0].phase, "takeoff.first_climb");
}

}  // namespace
}  // namespace tedavis::host_sim::test_run_story
