#include "host_sim/accuracy/accuracy_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_accuracy_text {
namespace {

using ::testing::HasSubstr;

using test_support::made_report;

TEST(AccuracyText, HasATableAndTheLaws) {
    const std::string text = accuracy_text(made_report());
    EXPECT_THAT(text, HasSubstr("quick"));
    EXPECT_THAT(text, HasSubstr("alps.tdb"));
    EXPECT_THAT(text, HasSubstr("\n  4 steps                      12.000"));
    EXPECT_THAT(text, HasSubstr("error ~ amount^-1.00 (R2 1.000"));
    EXPECT_THAT(text, HasSubstr("made up): agrees"));
}

TEST(AccuracyText, SaysWhyASettingHasOneLevelAndChoosesNoAlternative) {
    AccuracyReport report = made_report();
    report.knobs = {test_support::made_knob_of_one_level()};
    const std::string text = accuracy_text(report);
    EXPECT_THAT(text, HasSubstr("one level: one is enough"));
    EXPECT_THAT(text, HasSubstr("not offered"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("amount^")));
    EXPECT_THAT(budget_text(report, 100), HasSubstr("alone: ours (3.000 ms"));
    EXPECT_THAT(target_text(report, 0.3, "m", "--target-error 0.3m"), HasSubstr("no level keeps to it"));
}

TEST(AccuracyText, AnswersByBudget) {
    const AccuracyReport report = made_report();
    EXPECT_THAT(
        budget_text(report, 13),
        HasSubstr("made: 4 steps (12.000 ms, at most 0.25 m); 95 of 100 rounds took at most 12 ms; with a margin of 0 % (0 % "
                  "for the noise of the machine) that is 12 ms, so at least 95 of 100 are expected to keep to it"));
    test_support::expect_user_error(
        [&] { static_cast<void>(budget_text(report, 1)); },
        "--budget-ms 1: no level of any measured setting keeps to it; the quickest needs 3 ms, with the margin");
    AccuracyReport two = made_report();
    two.knobs.push_back(two.knobs[0]);
    two.knobs[1].name = "slow";
    for (MeasuredLevel& level : two.knobs[1].levels) level.ms.p95 *= 100;
    EXPECT_THAT(budget_text(two, 13), HasSubstr("slow: no level keeps to it"));
}

TEST(AccuracyText, SaysHowReplayGetsAFramesSettings) {
    AccuracyReport report = made_report();
    report.knobs[0].name = kFrameSettings;
    report.knobs[0].levels[2].options = "--tau 2";
    EXPECT_THAT(
        budget_text(report, 4),
        HasSubstr("frame_settings: 4 steps (4.000 ms, at most 0.25 m); 95 of 100 frames of the slowest measured place took at "
                  "most 4 ms; with a margin of 0 % (0 % for the noise of the machine) that is 4 ms, so at least 99 of 100 are "
                  "expected to keep to it; tedavis replay LOG -o DIR --tau 2"));
    EXPECT_THAT(target_text(report, 0.3, "m", ""),
                HasSubstr("frame_settings: 4 steps (4.000 ms, at most 0.25 m); tedavis replay"));
}

TEST(AccuracyText, NamesEachUnitOnce) {
    AccuracyReport report = made_report();
    report.knobs.insert(report.knobs.begin(), 2, report.knobs[0]);
    report.knobs[0].unit = report.knobs[1].unit = "m of height";
    test_support::expect_user_error([&] { static_cast<void>(target_text(report, 1, "px", "--target-error 1px")); },
                                    "the units are m of height, m");
}

TEST(AccuracyText, AnswersByErrorInTheKnobsUnit) {
    const AccuracyReport report = made_report();
    EXPECT_THAT(target_text(report, 0.3, "m", "--target-error 0.3m"), HasSubstr("made: 4 steps"));
    test_support::expect_user_error([&] { static_cast<void>(target_text(report, 0.3, "px", "--target-error 0.3px")); },
                                    "--target-error 0.3px: no measured knob has errors in 'px'; the units are m");
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_text
