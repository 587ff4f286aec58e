#include "host_sim/comparison/comparison_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "host_sim/png_file.hpp"
#include "tests/host_sim/comparison/made_runs.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_comparison_page {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class ComparisonPage : public ::testing::Test {
protected:
    ComparisonPage() {
        const RgbaPicture picture{8, 6, std::vector<std::uint8_t>(192, 90)};
        write_png(place_.file("x.png"), view_of(picture));
        for (ComparedRun* const run : {&a_, &b_}) {
            run->log = "<flight>.log";
            for (ComparedFrame& frame : run->frames) frame.picture = place_.file("x.png");
        }
        b_.frames[5].values[kLabelsPlaced] = 9;
        b_.frames[6].effects = {"fog"};
        a_.closest = nlohmann::ordered_json::parse(
            R"({"by_height": [{"lat_deg": 46.001, "lon_deg": 9, "height_above_terrain_m": 95, "time_s": 3}]})");
    }
    [[nodiscard]] std::string page() const {
        const RunComparison runs = compared_runs(a_, b_, {});
        return comparison_page(runs, comparison_moments(runs), {nullptr, "The map has no terrain: <none>."});
    }
    const test_support::TemporaryFolder place_;
    ComparedRun a_ = made_run("a", 20), b_ = made_run("b", 20);
};

TEST_F(ComparisonPage, HasAllItsParts) {
    const std::string html = page();
    EXPECT_THAT(html, StartsWith(kComparisonPageBeginning));
    for (const char* part :
         {"B placed 4 labels more", "Tracks", "A: 312 ft", "1312 ft above the terrain", "The map has no terrain: &lt;none&gt;.",
          "Closest to the ground in flight", "A, B begin", "Side by side", "labels placed differ most",
          "Over the time of the log", "In numbers", "Effects drawn", "not certified", "&lt;flight&gt;.log"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    EXPECT_EQ(html.find("<flight>"), std::string::npos);
}

TEST_F(ComparisonPage, NeedsNothingButItself) {
    const std::string html = page();
    for (const char* part : {"<script", "<link", "@import", "http"}) EXPECT_THAT(html, Not(HasSubstr(part)));
    const std::regex source("(src|href)='([^']{0,22})");
    std::size_t pictures = 0;
    for (std::sregex_iterator it(html.begin(), html.end(), source), end; it != end; ++it, ++pictures)
        EXPECT_EQ((*it)[2].str(), "data:image/png;base64,");
    EXPECT_GE(pictures, 12u);
    EXPECT_EQ(pictures % 2, 0u) << "they stand in pairs";
}

TEST_F(ComparisonPage, EveryElementIsClosed) {
    const std::string html = page();
    for (const char* element : {"section", "table", "tr", "td", "figure", "svg", "div", "ul", "li", "h3", "p", "g", "text"}) {
        const auto count = [&](const std::string& pattern) {
            const std::regex expression(pattern);
            return std::distance(std::sregex_iterator(html.begin(), html.end(), expression), std::sregex_iterator());
        };
        EXPECT_EQ(count(std::string("<") + element + "[ >]"), count(std::string("</") + element + ">")) << element;
    }
}

TEST_F(ComparisonPage, RowsSayOfHowManyInstantsTheyAre) {
    for (std::size_t n = 0; n < 5; ++n) b_.frames[n].values[kAltitude] = kUnknown;
    b_.log = a_.log;
    const std::string html = page();
    EXPECT_THAT(html, HasSubstr("Altitude, ft (15 of 20 instants)"));
    EXPECT_THAT(html, HasSubstr("equal where both know it"));
    EXPECT_THAT(html, HasSubstr("equal everywhere")) << "the other quantities";
    EXPECT_THAT(html, HasSubstr("Known in one run alone, in instants: altitude (5 of 20)"));
}

/// A section may be longer than a page.
TEST_F(ComparisonPage, PrintsHeadingsWithWhatFollowsThem) {
    const std::string html = page(), print = html.substr(html.find("@media print{"));
    EXPECT_THAT(print, HasSubstr("h2,h3{break-after:avoid}"));
    EXPECT_THAT(print, Not(HasSubstr("section{break-inside")));
    EXPECT_THAT(print, HasSubstr(".moment{break-inside:avoid}"));
    EXPECT_THAT(html, HasSubstr("<div class='moment'><h3>"));
}

/// Each in one unit, whether in a sentence, a table, a caption or a curve.
TEST_F(ComparisonPage, HeightsAreInFeet) {
    const std::string html = page();
    EXPECT_THAT(html, HasSubstr("<td>Altitude, ft</td><td class='n'>3280.8</td>"));
    EXPECT_THAT(html, HasSubstr("Height above terrain, equal in A and B [ft]"));
    EXPECT_THAT(html, Not(HasSubstr("[m]")));
    EXPECT_FALSE(std::regex_search(html, std::regex("[0-9] m (above|higher|lower|apart, at)")))
        << "metres stand in parentheses alone, and on the scale";
}

TEST_F(ComparisonPage, WithoutPicturesItSaysSo) {
    for (ComparedFrame& frame : b_.frames) frame.picture.clear();
    const std::string html = page();
    EXPECT_THAT(html, Not(HasSubstr("Side by side")));
    EXPECT_THAT(html, HasSubstr("b has no pictures"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_comparison_page
