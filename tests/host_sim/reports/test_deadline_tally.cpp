#include "host_sim/reports/deadline_tally.hpp"

#include <gtest/gtest.h>

#include "tests/support/flights/frame_result.hpp"

namespace tedavis::host_sim::test_deadline_tally {
namespace {

FrameResult frame(double time_s, double predicted_ms, double measured_ms, std::uint32_t quality_level = 0, bool changed = false) {
    FrameResult result = test_support::frame_result(0, time_s);
    result.record.governor = {33, predicted_ms, quality_level, changed, "x", 1, 1, {}};
    result.timing.total_ms = measured_ms;
    return result;
}

TEST(DeadlineTally, CountsWhatWasWithinAndWhatChanged) {
    DeadlineTally tally;
    tally.add(frame(1, 33, 40, 2, true));
    tally.add(frame(2, 34, 20, 2));
    tally.add(frame(4.5, 20, 33, 0, true));
    tally.add(frame(7, 0, 50, 1, true));
    const DeadlineSummary& s = tally.summary();
    EXPECT_EQ(s.deadline_ms, 33);
    EXPECT_EQ(s.frames, 4u);
    EXPECT_EQ(s.within_modelled, 2u) << "unknown is not within";
    EXPECT_EQ(s.within_measured, 2u);
    EXPECT_EQ(s.changes, 3u);
    EXPECT_DOUBLE_EQ(s.least_s_between_changes.value(), 2.5);
    EXPECT_EQ(s.frames_at_quality_level[2], 2u);
    EXPECT_EQ(deadline_text(s),
              "; deadline 33 ms: 50.00 % of frames within by the model, 50.00 % as measured, 3 changes at least 2.5 s apart");
}

TEST(DeadlineTally, WithoutADeadlineThereIsNothingToSay) {
    DeadlineTally tally;
    tally.add(test_support::frame_result(1, 1));
    EXPECT_EQ(tally.summary().frames, 0u);
    EXPECT_EQ(deadline_text(tally.summary()), "");
    tally.add(frame(1, 20, 20));
    EXPECT_FALSE(tally.summary().least_s_between_changes);
    EXPECT_EQ(deadline_text(tally.summary()),
              "; deadline 33 ms: 100.00 % of frames within by the model, 100.00 % as measured, 0 changes");
}

}  // namespace
}  // namespace tedavis::host_sim::test_deadline_tally
