#include "host_sim/reports/closest_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/reports/closest_report.hpp"

namespace tedavis::host_sim::test_closest_section {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(ClosestSection, IsASentenceThatAColleagueUnderstands) {
    ClosestReport report = test_support::closest_report();
    EXPECT_THAT(
        closest_sentence(report),
        StartsWith(
            "It came within 312 ft (95 m), ± 79 ft (95 %), of the ground below at 14:23:05.2 UTC at 46.7312 N 9.8123 E, in "
            "cruise; the display showed a terrain caution. The nearest ground in any direction was 262 ft (80 m) "
            "away, at bearing 120°, at 14:23:05.2 UTC."));
    report.assumes_heights = true;
    EXPECT_THAT(closest_sentence(report),
                StartsWith("By pressure altitude, taken for a height above sea level (--assume-geometric), "
                           "it came within 312 ft"));
    report.by_height.front().point.sample.own.is_geometric = false;
    EXPECT_THAT(closest_sentence(report), StartsWith("By pressure altitude alone, which is no height above sea level, it came"));
    report.by_height.front().point.sample.uncertainty.terrain_m = std::nullopt;
    report.by_height.front().frame.alert = policy::TerrainAhead::none;
    EXPECT_THAT(closest_sentence(report), HasSubstr("(95 m), of unstated uncertainty, of the ground"));
    EXPECT_THAT(closest_sentence(report), HasSubstr("showed no terrain alert"));
    report.by_height.front().point.sample.uncertainty = {15.0, std::nullopt, 16.0};
    EXPECT_THAT(closest_sentence(report), HasSubstr("(95 m), ± 52 ft (95 %) by the terrain alone, for the own"));
    report.by_height.clear();
    EXPECT_THAT(closest_sentence(report), StartsWith("No closest point:"));
}

TEST(ClosestSection, LinksThePictureAndDrawsTheProfileWithItsBands) {
    ClosestReport report = test_support::closest_report();
    std::string html = closest_html(report);
    EXPECT_THAT(html, HasSubstr("<a href='frames/000042.png'>frame 42, 0.3 s</a>"));
    EXPECT_THAT(html, HasSubstr("class='band'"));
    EXPECT_THAT(html, HasSubstr(" km</text>"));
    EXPECT_THAT(html, HasSubstr("<tr><td class='n'>1</td>"));
    EXPECT_THAT(html, HasSubstr("<tr><td class='n'>a</td>")) << "another number than that of the map's marks";
    EXPECT_THAT(html, Not(HasSubstr("<figure"))) << "no frame was drawn for it";
    report.by_height.front().frame.small_png = "bytes";
    EXPECT_THAT(closest_html(report), HasSubstr("The display at 14:23:05.2 UTC: 312 ft above the terrain, frame 42"));
    EXPECT_THAT(html, HasSubstr("<td class='n'>312</td><td class='n'>262</td><td class='n'>± 79</td>"))
        << "feet, as in the sentence";
    for (TrackSample& sample : report.track) sample.uncertainty = {};
    html = closest_html(report);
    EXPECT_THAT(html, Not(HasSubstr("class='band'"))) << "nothing stated, no band";
    EXPECT_EQ(closest_html({}), "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_closest_section
