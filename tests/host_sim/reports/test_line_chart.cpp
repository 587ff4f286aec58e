#include "host_sim/reports/line_chart.hpp"

#include <cpl_minixml.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace tedavis::host_sim::test_line_chart {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

LineChart ramp() {
    LineChart chart{"Altitude", "m", {0, 1, 2, 3, 4}, {}, {}};
    chart.curves.push_back({"own ship", "#123456", {0, 100, 200, 300, 400}});
    return chart;
}

std::string path_of(const std::string& svg) {
    std::smatch found;
    return std::regex_search(svg, found, std::regex("<path d='([^']*)'")) ? found[1].str() : "";
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

bool is_well_formed(const std::string& svg) {
    CPLXMLNode* tree = CPLParseXMLString(svg.c_str());
    CPLDestroyXMLNode(tree);
    return tree != nullptr;
}

TEST(LineChart, ARampIsAStraightLineThatRises) {
    const std::string path = path_of(line_chart_svg(ramp()));
    const std::regex point("[ML]([0-9.]+) ([0-9.]+)");
    std::vector<double> x, y;
    for (std::sregex_iterator it(path.begin(), path.end(), point), end; it != end; ++it) {
        x.push_back(std::stod((*it)[1]));
        y.push_back(std::stod((*it)[2]));
    }
    ASSERT_EQ(x.size(), 5u);
    for (std::size_t i = 1; i < 5; ++i) {
        EXPECT_NEAR(x[i] - x[i - 1], (x[4] - x[0]) / 4, 0.11);
        EXPECT_NEAR(y[i] - y[i - 1], (y[4] - y[0]) / 4, 0.11);
    }
    EXPECT_LT(y[4], y[0]) << "upwards is a smaller y in SVG";
}

TEST(LineChart, AGapInterruptsTheCurve) {
    LineChart chart = ramp();
    EXPECT_EQ(count(path_of(line_chart_svg(chart)), "M"), 1u);
    chart.curves[0].values[2] = std::nan("");
    const std::string path = path_of(line_chart_svg(chart));
    EXPECT_EQ(count(path, "M"), 2u);
    EXPECT_EQ(count(path, "L"), 2u);
}

TEST(LineChart, IsWellFormedWhateverTheNamesAndNumbers) {
    LineChart chart = ramp();
    chart.title = "<script> & 'more'";
    chart.curves.push_back({"b < c & \"d\"", "#000000", {1e300, -1e300, INFINITY, std::nan(""), 0}});
    chart.spans.push_back({1, 2, "approach & <final>", "#ff0000"});
    const std::string svg = line_chart_svg(chart);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, Not(HasSubstr("<script>")));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    EXPECT_FALSE(is_well_formed("<svg><b></svg>")) << "a control";
}

TEST(LineChart, DrawsNothingKnownWithoutFailing) {
    LineChart empty{"Empty", "m", {}, {}, {}};
    EXPECT_TRUE(is_well_formed(line_chart_svg(empty)));
    LineChart one{"One", "m", {5}, {{"a", "#000000", {3}}}, {}};
    EXPECT_TRUE(is_well_formed(line_chart_svg(one)));
    LineChart flat = ramp();
    flat.curves[0].values = {7, 7, 7, 7, 7};
    EXPECT_TRUE(is_well_formed(line_chart_svg(flat)));
}

TEST(LineChart, ARunThatGoesBackwardsHasItsSpansTheRightWayRound) {
    LineChart chart = ramp();
    chart.times_s = {4, 3, 2, 1, 0};
    chart.spans.push_back({3, 1, "cruise", "#ff0000"});
    std::smatch found;
    const std::string svg = line_chart_svg(chart);
    ASSERT_TRUE(std::regex_search(svg, found, std::regex("<rect [^>]*width='([0-9.]+)'")));
    EXPECT_GT(std::stod(found[1]), 100);
}

TEST(LineChart, ABandLiesBetweenItsValuesAndHasTheGapsOfBoth) {
    LineChart chart = ramp();
    chart.x_unit = "km";
    chart.bands.push_back({"#abcdef", {-10, 90, 190, 290, 390}, {10, 110, 210, 310, 410}});
    std::string svg = line_chart_svg(chart);
    EXPECT_TRUE(is_well_formed(svg));
    EXPECT_THAT(svg, HasSubstr("km</text>"));
    std::smatch found;
    ASSERT_TRUE(std::regex_search(svg, found, std::regex("<path class='band' d='([^']*)'")));
    EXPECT_EQ(count(found[1].str(), "M"), 1u);
    EXPECT_EQ(count(found[1].str(), "L"), 9u) << "five places on top, five back along the bottom";
    chart.bands[0].low[2] = std::nan("");
    svg = line_chart_svg(chart);
    ASSERT_TRUE(std::regex_search(svg, found, std::regex("<path class='band' d='([^']*)'")));
    EXPECT_EQ(count(found[1].str(), "M"), 2u);
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(line_chart_svg(ramp()), Not(HasSubstr("band")));
}

TEST(LineChart, EscapesAndRounds) {
    EXPECT_EQ(escaped_html("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c&#39;");
    EXPECT_EQ(decimal(1.25, 1), "1.2");
    EXPECT_EQ(decimal(-3, 0), "-3");
    EXPECT_EQ(decimal(1e300, 0), "1000000000000000");
}

TEST(LineChart, MarksAreLinksAtTheirPlaces) {
    LineChart chart = ramp();
    chart.description = "a ramp & <more>";
    EXPECT_THAT(line_chart_svg(chart), HasSubstr("role='img'"));
    chart.marks.push_back({2, 200, "A", "#a", "the middle"});
    const std::string svg = line_chart_svg(chart);
    EXPECT_TRUE(is_well_formed(svg));
    for (const char* part : {"role='group'", "<desc>a ramp &amp; &lt;more&gt;</desc>", "href='#a'", "aria-label='the middle'"})
        EXPECT_THAT(svg, HasSubstr(part));
    std::smatch place;
    ASSERT_TRUE(std::regex_search(svg, place, std::regex("class='place' cx='([0-9.]+)' cy='([0-9.]+)'")));
    const std::string middle = "L" + place[1].str() + " " + place[2].str();
    EXPECT_THAT(path_of(svg), HasSubstr(middle)) << "on the curve";
    chart.marks.push_back({2, 200, "B", "#b", "the same place"});
    const std::string rows = line_chart_svg(chart);
    const std::regex label("class='label' cx='[0-9.]+' cy='([0-9.]+)' r='([0-9.]+)'");
    std::sregex_iterator first(rows.begin(), rows.end(), label), second = std::next(first);
    EXPECT_GT(std::stod((*second)[1]) - std::stod((*first)[1]), 2 * std::stod((*first)[2])) << "labels do not touch";
}

// Of a long run the drawing keeps what stands out, and no more points than it has room for.
TEST(LineChart, LongCurvesKeepTheirExtremes) {
    LineChart chart{"Long", "", {}, {}, {}};
    chart.curves.push_back({"c", "#000000", {}});
    for (int n = 0; n < 12000; ++n) {
        chart.times_s.push_back(0.1 * n);
        chart.curves[0].values.push_back(n == 7001 ? 9 : n == 3003 ? -9 : 0.001 * (n % 7));
    }
    const std::string path = path_of(line_chart_svg(chart));
    EXPECT_LT(count(path, "L"), 2 * 480u);
    double least = 1e9, greatest = -1e9;
    const std::regex point("[ML][0-9.]+ ([0-9.]+)");
    for (std::sregex_iterator it(path.begin(), path.end(), point), end; it != end; ++it) {
        least = std::min(least, std::stod((*it)[1]));
        greatest = std::max(greatest, std::stod((*it)[1]));
    }
    chart.times_s = {0, 1, 2};
    chart.curves[0].values = {-9, 0, 9};
    const std::string ends = path_of(line_chart_svg(chart));
    std::sregex_iterator it(ends.begin(), ends.end(), point);
    EXPECT_NEAR(greatest, std::stod((*it)[1]), 0.11);
    EXPECT_NEAR(least, std::stod((*std::next(it, 2))[1]), 0.11);
}

TEST(LineChart, AGapInTheTimesIsOneInCurvesAndBands) {
    LineChart chart{"", "", {0, 1, 2, 30, 31}, {{"a", "#111", {1, 2, 3, 4, 5}}}, {}};
    chart.bands = {{"#222", {0, 1, 2, 3, 4}, {2, 3, 4, 5, 6}}};
    const LineChart parted = with_gaps(chart);
    ASSERT_EQ(parted.times_s.size(), 6u);
    EXPECT_EQ(parted.times_s[3], 16);
    for (const auto* const values : {&parted.curves[0].values, &parted.bands[0].low, &parted.bands[0].high}) {
        ASSERT_EQ(values->size(), 6u);
        EXPECT_TRUE(std::isnan((*values)[3]));
    }
    chart.times_s = {0, 1, 2, 3, 4};
    EXPECT_EQ(with_gaps(chart).times_s, chart.times_s);
}

}  // namespace
}  // namespace tedavis::host_sim::test_line_chart
