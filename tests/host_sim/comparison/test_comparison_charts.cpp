#include "host_sim/comparison/comparison_charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_comparison_charts {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t charts_in(const std::string& html) {
    std::size_t count = 0;
    for (std::size_t at = html.find("<svg"); at != std::string::npos; at = html.find("<svg", at + 1)) ++count;
    return count;
}

TEST(ComparisonCharts, ThereIsOneForEachQuantityThatTheRecordsHold) {
    const ComparedRun run = made_run("a", 20);
    const std::string html = comparison_charts(compared_runs(run, run, {}));
    EXPECT_EQ(charts_in(html), kQuantityCount - 1) << "no record has crowded regions";
    EXPECT_THAT(html, HasSubstr("Altitude, equal in A and B [m]"));
    EXPECT_THAT(html, Not(HasSubstr("B - A")));
}

TEST(ComparisonCharts, ADifferenceHasACurveOfItsOwn) {
    ComparedRun a = made_run("a", 20), b = a;
    b.frames[4].values[kLabelsPlaced] += 2;
    const std::string html = comparison_charts(compared_runs(a, b, {}));
    EXPECT_EQ(charts_in(html), kQuantityCount);
    EXPECT_THAT(html, HasSubstr("B - A"));
    EXPECT_THAT(html, Not(HasSubstr("Labels placed, equal")));
}

TEST(ComparisonStates, HaveARowForEachRunAndAlertsWhereThereAreAny) {
    ComparedRun a = made_run("a", 20), b = a;
    EXPECT_THAT(comparison_states(compared_runs(a, b, {})), Not(HasSubstr("alert<")));
    b.frames[4].terrain_alert = 2;
    const std::string html = comparison_states(compared_runs(a, b, {}));
    for (const char* row : {"A, phase", "B, phase", "A, terrain alert", "B, terrain alert", "<title>warning</title>"})
        EXPECT_THAT(html, HasSubstr(row));
    EXPECT_THAT(html, Not(HasSubstr("obstacle alert")));
    EXPECT_EQ(comparison_states(compared_runs(made_run("a", 1), made_run("a", 1), {})), "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_comparison_charts
