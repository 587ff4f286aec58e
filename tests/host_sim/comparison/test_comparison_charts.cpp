#include "host_sim/comparison/comparison_charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>

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
    EXPECT_THAT(html, HasSubstr("Altitude, equal in A and B [ft]"));
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

std::size_t curves_begun_in(const std::string& svg) {
    std::size_t count = 0;
    for (std::size_t at = svg.find('M'); at < svg.size() - 1; at = svg.find('M', at + 1))
        count += std::isdigit(static_cast<unsigned char>(svg[at + 1])) != 0 ? 1 : 0;
    return count;
}

/// The curve of an aircraft that becomes much faster is whole; a time that is not shown breaks it.
TEST(ComparisonCharts, GapsByPlaceAreThoseInTime) {
    ComparedRun run = made_run("a", 40);
    double north_m = 0;
    for (std::size_t n = 0; n < 40; ++n) {
        run.frames[n] = made_frame(n, static_cast<double>(n), north_m, 0);
        north_m += n < 30 ? 1 : 60;
    }
    const AlignmentRequest by_place{Alignment::place, 3000};
    const std::size_t whole = curves_begun_in(comparison_charts(compared_runs(run, run, by_place)));
    EXPECT_EQ(whole, kQuantityCount - 1) << "though it is faster at the end";
    for (std::size_t n = 20; n < 40; ++n) run.frames[n].time_s += 100;
    EXPECT_EQ(curves_begun_in(comparison_charts(compared_runs(run, run, by_place))), 2 * whole);
}

TEST(ComparisonCharts, WhatOneRunAloneKnowsIsNotDrawnAsEqual) {
    ComparedRun a = made_run("a", 20), b = a;
    for (std::size_t n = 0; n < 8; ++n) b.frames[n].values[kAltitude] = kUnknown;
    EXPECT_THAT(comparison_charts(compared_runs(a, b, {})), Not(HasSubstr("Altitude, equal in A and B")));
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
