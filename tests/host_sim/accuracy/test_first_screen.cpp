#include "host_sim/accuracy/first_screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_first_screen {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Five levels that take 1, 2, 4, 8 and 16 ms a frame and are 1, 0.5, 0.25, 0.125 and 0.0625 m off.
AccuracyReport framed_report() {
    AccuracyReport report = test_support::made_report();
    report.knobs[0].name = kFrameSettings;
    for (MeasuredLevel& level : report.knobs[0].levels) level.options = "--steps " + level.name.substr(0, level.name.find(' '));
    return report;
}

TEST(FirstScreen, SaysTheBestOfATimeAndWhatTheNextLevelCosts) {
    const std::string page = first_screen(framed_report());
    EXPECT_THAT(page, HasSubstr("The best settings for 60 frames/s (16.7 ms) are 16 steps, 16.0 ms, at most"));
    EXPECT_THAT(page, HasSubstr("No other settings are more accurate."));
    EXPECT_THAT(page, HasSubstr("<th>12 ms</th><td class='n aside'>12.0</td><td>8 steps</td><td class='n'>0.125</td>"
                                "<td class='n aside'>0.125</td><td class='n'>8.00</td>"));
    EXPECT_THAT(page, HasSubstr("<td>16 steps</td><td>x 2.00 time, x 0.50 error</td><td>--steps 8</td>"));
}

TEST(FirstScreen, SaysTheQuickestForAnError) {
    EXPECT_THAT(
        first_screen(framed_report()),
        HasSubstr("<th>0.5 m</th><td>2 steps</td><td class='n'>0.5</td><td class='n aside'>0.5</td><td class='n'>2.00</td>"));
    EXPECT_THAT(first_screen(framed_report()), HasSubstr("<th>1 m</th><td>1 steps</td>"));
}

TEST(FirstScreen, TrustsWhatIsProvenAndNotWhatWasMeasured) {
    AccuracyReport report = framed_report();
    for (MeasuredLevel& level : report.knobs[0].levels) level.proven = 2 * level.error.max;
    const std::string page = first_screen(report);
    EXPECT_THAT(page, HasSubstr("at most 0.12 m off (proven; 0.062 measured)"));
    EXPECT_THAT(page, HasSubstr("<th>0.5 m</th><td>4 steps</td><td class='n'>0.5</td><td class='n aside'>0.25</td>"));
    report.knobs[0].levels[4].proven = 10;
    EXPECT_THAT(first_screen(report), HasSubstr("The best settings for 60 frames/s (16.7 ms) are 8 steps"))
        << "16 steps prove less, although they were found to be more accurate";
}

TEST(FirstScreen, SaysWhereNothingIsQuickEnough) {
    AccuracyReport report = framed_report();
    for (MeasuredLevel& level : report.knobs[0].levels) level.kept_ms = 1000;
    const std::string page = first_screen(report);
    EXPECT_THAT(page, HasSubstr("No settings keep to 60 frames/s"));
    EXPECT_THAT(page, HasSubstr("no settings keep to it"));
}

TEST(FirstScreen, SaysWhatWasNotMeasured) {
    EXPECT_THAT(first_screen(test_support::made_report()), HasSubstr("--knob frame_settings"));
    EXPECT_THAT(first_screen(framed_report()), Not(HasSubstr("--knob"))) << "control";
}

TEST(FirstScreen, StatesTheMarginOfItsAnswer) {
    AccuracyReport report = framed_report();
    MeasuredKnob& knob = report.knobs[0];
    knob.noise = 0.1;
    knob.moments = 20;
    knob.dearest = 1.2;
    const std::string page = first_screen(report);
    EXPECT_THAT(page,
                HasSubstr("The best settings for 60 frames/s (16.7 ms) are 8 steps, 8.0 ms, at most 0.12 m off. 95 of 100 "
                          "frames of the slowest measured place took at most 8 ms; with a margin of 32 % (10 % for the noise "
                          "of the machine, 20 % by which the dearest of 20 further moments of the flight takes longer than "
                          "that place) that is 10.6 ms, so at least 99 of 100 are expected to keep to it."));
    EXPECT_THAT(page, HasSubstr("<b>10.6 ms</b>"));
    EXPECT_THAT(page, HasSubstr("95 of 100 frames, with a margin of 32 %"));
    EXPECT_THAT(page, HasSubstr("<td class='n'>8.00</td><td class='n aside'>10.56</td>"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_first_screen
