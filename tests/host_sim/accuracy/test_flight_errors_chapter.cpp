#include "host_sim/accuracy/flight_errors_chapter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace tedavis::host_sim::test_flight_errors_chapter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

FlightErrors made_flight() {
    FlightErrors flight;
    flight.flight = "a flight";
    flight.asked_px = 1;
    flight.moments = {{10, 0.9, 0.5, 12, 100, "36,-84,1000,0,0,0"},
                      {20, 0.8, 0.7, 13, 90, "37,-84,1000,0,0,0", " --phase cruise"}};
    flight.terrain = "dir/alps.tdb";
    flight.drawn = " --terrain dir/alps.tdb --size 640x360";
    flight.lines = {{4, 3.5, 2.1, 600, 0, {0.4, 0.6}}, {1, 0.9, 0.7, 500, 0, {0.5, 0.78}}};
    return flight;
}

TEST(FlightErrorsChapter, ShowsTheThreeLinesAndHowTightTheBoundIs) {
    const std::string page = flight_errors_chapter({made_flight()});
    EXPECT_THAT(
        page,
        HasSubstr("<th>4 px</th><td class='n'>3.5</td><td class='n'>2.1</td><td class='n'>40 %</td><td class='n'>60 %</td><td "
                  "class='n'>600</td>"));
    EXPECT_THAT(
        page, HasSubstr("The greatest measured error, 0.7 px, is at 20 s: tedavis shot --pose 37,-84,1000,0,0,0 --tau 1 --phase "
                        "cruise --terrain dir/alps.tdb --size 640x360 -o worst.png"));
    EXPECT_THAT(page, Not(HasSubstr("class='dominated'")));
}

TEST(FlightErrorsChapter, MarksABrokenBound) {
    FlightErrors flight = made_flight();
    EXPECT_TRUE(flight.holds());
    flight.moments[0].measured_px = flight.moments[0].proven_px + 0.1;
    EXPECT_FALSE(flight.holds()) << "along the flight";
    flight = made_flight();
    flight.lines[1].broken = 3;
    EXPECT_FALSE(flight.holds());
    EXPECT_THAT(flight_errors_chapter({flight}), HasSubstr("<tr class='dominated'><th>1 px</th>"));
    EXPECT_THAT(flight_errors_text({flight}), HasSubstr("500 samples, 3 above the bound"));
}

/// Heights of the first points of the three lines in the drawing: upwards is less.
std::vector<double> first_heights(const std::string& svg) {
    std::vector<double> heights;
    for (std::size_t at = svg.find("points='"); at != std::string::npos; at = svg.find("points='", at + 1))
        heights.push_back(std::strtod(svg.c_str() + svg.find(',', at) + 1, nullptr));
    return heights;
}

TEST(ToleranceChart, DrawsWhatWasAskedAboveWhatWasProvenAboveWhatWasMeasured) {
    const std::vector<double> heights = first_heights(tolerance_chart_svg({made_flight()}));
    ASSERT_EQ(heights.size(), 3u);
    EXPECT_LT(heights[0], heights[1]);
    EXPECT_LT(heights[1], heights[2]);
    FlightErrors broken = made_flight();
    broken.lines[0].measured_px = 3.9;
    const std::vector<double> wrong = first_heights(tolerance_chart_svg({broken}));
    EXPECT_LT(wrong[2], wrong[1]) << "control: above the bound";
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(ToleranceChart, HasMarksOfItsOwnForEachFlightAndSaysHowTightItsBoundIs) {
    FlightErrors other = made_flight();
    other.flight = "logs/other.log";
    other.moments[0].measured_px = 0.18;
    other.moments[1].measured_px = 0.08;
    const std::string one = tolerance_chart_svg({made_flight()}), both = tolerance_chart_svg({made_flight(), other});
    EXPECT_EQ(first_heights(both).size(), 5u);
    EXPECT_EQ(count_of(both, "d='M-5 -5h10v10h-10z'"), 5u) << "two points of two lines, and the legend";
    EXPECT_EQ(count_of(both, "d='M0 -6l6 11h-12z'"), 5u);
    EXPECT_EQ(count_of(one, "d='M0 -6l6 11h-12z'"), 0u) << "control";
    EXPECT_THAT(both, HasSubstr("a flight over alps.tdb: 72 % of the bound in the median, 87 % at most"));
    EXPECT_THAT(both, HasSubstr("other.log over alps.tdb: 15 % of the bound in the median, 20 % at most"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_errors_chapter
