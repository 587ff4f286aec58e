#include "host_sim/accuracy/compare_accuracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/made_knob.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_compare_accuracy {
namespace {

using test_support::made_report;
using ::testing::HasSubstr;
using ::testing::Not;

ComparedReport beside(const AccuracyReport& now, const AccuracyReport& earlier) {
    return compare_accuracy(now, earlier, "old.json", {});
}

TEST(CompareAccuracy, FindsNothingWorseInTheSameReport) {
    const ComparedReport same = beside(made_report(), made_report());
    EXPECT_EQ(same.levels.size(), 5u);
    EXPECT_TRUE(same.is_same_machine);
    EXPECT_FALSE(is_worse(same));
    EXPECT_THAT(comparison_text(same), HasSubstr("No level is worse"));
}

TEST(CompareAccuracy, FindsASlowerLevelBeyondTheLimitOnly) {
    AccuracyReport now = made_report();
    const double ms = now.knobs[0].levels[2].ms.median;
    now.knobs[0].levels[2].ms.median = 1.2 * ms;
    EXPECT_FALSE(is_worse(beside(now, made_report()))) << "control: within a quarter";
    now.knobs[0].levels[2].ms.median = 1.3 * ms;
    const ComparedReport slower = beside(now, made_report());
    EXPECT_TRUE(is_worse(slower));
    EXPECT_THAT(comparison_text(slower), HasSubstr("made, 4 steps: takes 15.600 ms, and took 12.000 ms"));
    now.knobs[0].noise = 0.4;
    EXPECT_FALSE(is_worse(beside(now, made_report()))) << "the noise hides it";
}

TEST(CompareAccuracy, JudgesNoTimesOfAnotherMachine) {
    AccuracyReport now = made_report(), earlier = made_report();
    earlier.conditions.processor = "another";
    now.knobs[0].levels[2].ms.median *= 10;
    const ComparedReport compared = beside(now, earlier);
    EXPECT_FALSE(is_worse(compared));
    EXPECT_THAT(comparison_text(compared), HasSubstr("times are not judged"));
    now.knobs[0].levels[2].error.max *= 10;
    EXPECT_TRUE(is_worse(beside(now, earlier))) << "control: errors do not depend on the machine";
}

TEST(CompareAccuracy, FindsALargerErrorAndAMissingLevel) {
    AccuracyReport now = made_report();
    now.knobs[0].levels[4].error.mean *= 1.5;
    EXPECT_TRUE(is_worse(beside(now, made_report())));
    now = made_report();
    now.knobs[0].levels.pop_back();
    const ComparedReport gone = beside(now, made_report());
    EXPECT_TRUE(is_worse(gone));
    EXPECT_THAT(gone.gone, ::testing::ElementsAre("made: 16 steps"));
    EXPECT_FALSE(is_worse(beside(made_report(), now))) << "control: a new level is not worse";
}

TEST(CompareAccuracy, TrustsNoErrorBelowTheReferencesBound) {
    AccuracyReport now = made_report(), earlier = made_report();
    for (AccuracyReport* const report : {&now, &earlier}) report->knobs[0].reference_bound = 10;
    now.knobs[0].levels[4].error.max *= 3;
    EXPECT_FALSE(is_worse(beside(now, earlier)));
}

TEST(CompareAccuracy, RefusesOtherInputs) {
    AccuracyReport earlier = made_report();
    earlier.conditions.is_quick = false;
    test_support::expect_user_error([&] { static_cast<void>(beside(made_report(), earlier)); },
                                    "--compare old.json: was measured over other heights, another flight, displays or extent");
    earlier = made_report();
    earlier.conditions.flight = "alps.log";
    earlier.conditions.flight_identity = 9;
    test_support::expect_user_error([&] { static_cast<void>(beside(made_report(), earlier)); }, "and alps.log, 640 x 360 pixels");
}

TEST(ComparisonTable, HasARowForEachLevelAndAColumnForEachReport) {
    AccuracyReport earlier = made_report();
    earlier.conditions.processor = "another machine's";
    const std::string table = comparison_table({beside(made_report(), made_report()), beside(made_report(), earlier)});
    EXPECT_THAT(table, HasSubstr("ms: another machine&#39;s"));
    std::size_t rows = 0;
    for (std::size_t at = table.find("<th>made</th>"); at != std::string::npos; at = table.find("<th>made</th>", at + 1)) ++rows;
    EXPECT_EQ(rows, 5u);
    EXPECT_EQ(comparison_table({}), "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_compare_accuracy
