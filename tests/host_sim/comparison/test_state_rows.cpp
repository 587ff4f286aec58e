#include "host_sim/comparison/state_rows.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace tedavis::host_sim::test_state_rows {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(StateRows, SpansStandInProportionToTheAxis) {
    const std::string svg =
        state_rows_svg("Phases", {{"A", {{0, 30, "cruise", "#111"}, {30, 40, "approach.<final>", "#222"}}}}, 0, 40, "s");
    const std::regex rectangle("<rect x='([0-9.]+)' y='[0-9.]+' width='([0-9.]+)'");
    std::vector<std::pair<double, double>> spans;
    for (std::sregex_iterator it(svg.begin(), svg.end(), rectangle), end; it != end; ++it)
        spans.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
    ASSERT_EQ(spans.size(), 2u);
    EXPECT_NEAR(spans[0].second, 3 * spans[1].second, 0.3);
    EXPECT_NEAR(spans[0].first + spans[0].second, spans[1].first, 0.2);
    EXPECT_THAT(svg, HasSubstr("approach.&lt;final&gt;"));
    EXPECT_THAT(svg, HasSubstr(">10 s</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("<final>")));
}

TEST(StateRows, ANarrowSpanHasItsLabelAsATitleAlone) {
    const std::string svg = state_rows_svg("", {{"A", {{0, 0.1, "takeoff.second_climb", "#111"}}}}, 0, 1000, "s");
    EXPECT_THAT(svg, HasSubstr("<title>takeoff.second_climb</title>"));
    EXPECT_THAT(svg, Not(HasSubstr("class='span'")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_state_rows
