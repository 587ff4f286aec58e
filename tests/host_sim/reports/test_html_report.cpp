#include "host_sim/reports/html_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/frame_result.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_html_report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RunStory short_story() {
    RunStory story(base::Time{0});
    const RgbaPicture picture{4, 4, std::vector<std::uint8_t>(64, 200)};
    for (std::uint64_t n = 0; n < 5; ++n) {
        FrameResult result = test_support::frame_result(n, static_cast<double>(n));
        EXPECT_TRUE(n != 3 || result.record.flags.try_push_back(display::Name("altitude.stale")));
        if (story.add(result, 300, 60)) story.add_picture(result, view_of(picture));
        if (n == 1) story.add_legend("ridge & valley", true, result, view_of(picture));
    }
    return story;
}

RunSummary summary() {
    RunSummary s;
    s.log = "flight <1> & co.log";
    s.frames = 5;
    s.notes = {"<b>broken</b> line"};
    return s;
}

TEST(HtmlReport, TellsTheWholeStory) {
    const std::string html = html_report(summary(), short_story(), {});
    for (const char* part : {"<!DOCTYPE html>", "takeoff.first_climb", "altitude.stale", "Memory", "Ground speed",
                             "frame 0, 0.0 s", "not certified", "design ridge &amp; valley: frame 1, 1.0 s"})
        EXPECT_THAT(html, HasSubstr(part));
    EXPECT_THAT(html, HasSubstr("worst terrain error</th><td>no terrain was drawn"));
    EXPECT_THAT(html, HasSubstr("flight &lt;1&gt; &amp; co.log"));
    EXPECT_THAT(html, Not(HasSubstr("<b>broken</b>")));
    EXPECT_THAT(html_report(summary(), RunStory(base::Time{0}), {}), HasSubstr("None were raised."));
}

// Nothing is fetched and nothing runs: every source is a data URI, and there are no scripts, links or imports.
TEST(HtmlReport, NeedsNothingButItself) {
    const std::string html = html_report(summary(), short_story(), {});
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, Not(HasSubstr("<link")));
    EXPECT_THAT(html, Not(HasSubstr("@import")));
    EXPECT_THAT(html, Not(HasSubstr("http")));
    const std::regex source("(src|href)='([^']{0,22})");
    std::size_t pictures = 0;
    for (std::sregex_iterator it(html.begin(), html.end(), source), end; it != end; ++it, ++pictures)
        EXPECT_EQ((*it)[2].str(), "data:image/png;base64,");
    EXPECT_EQ(pictures, 6u);
}

TEST(HtmlReport, EveryElementIsClosed) {
    const std::string html = html_report(summary(), short_story(), {});
    for (const char* element : {"section", "table", "tr", "td", "figure", "svg", "div", "ul", "li"}) {
        const auto count = [&](const std::string& pattern) {
            const std::regex expression(pattern);
            return std::distance(std::sregex_iterator(html.begin(), html.end(), expression), std::sregex_iterator());
        };
        EXPECT_EQ(count(std::string("<") + element + "[ >]"), count(std::string("</") + element + ">")) << element;
    }
}

TEST(HtmlReport, MarksWhatMustNotBe) {
    RunSummary bad = summary();
    EXPECT_THAT(html_report(bad, short_story(), {}), Not(HasSubstr("class='bad'")));
    bad.heap_allocations_after_start = 2;
    EXPECT_THAT(html_report(bad, short_story(), {}), HasSubstr("class='bad'>2"));
}

TEST(HtmlReport, WarningsStandBeforeTheSummary) {
    RunSummary warned = summary();
    EXPECT_THAT(html_report(warned, short_story(), {}), Not(HasSubstr("Warnings")));
    EXPECT_THAT(html_report(warned, short_story(), {}), Not(HasSubstr("chunks arrived")));
    warned.warnings = {{"terrain.outside", "60 of 107 frames lie outside <X>.tdb", 60}};
    warned.worst_start_error_px = 35.25;
    const std::string html = html_report(warned, short_story(), {});
    EXPECT_THAT(html, HasSubstr("60 of 107 frames lie outside &lt;X&gt;.tdb"));
    EXPECT_LT(html.find("60 of 107"), html.find("<h2>Summary"));
    EXPECT_THAT(html, HasSubstr("worst terrain error while its first chunks arrived</th><td>35.250 px"));
}

/// The run stands at 46.5 N, 9.75 E.
TEST(HtmlReport, TheMapSaysWhatItShowsOfGhosts) {
    RunSummary beside = summary();
    beside.ghosts = {{"a.log",
                      "a",
                      GhostAlign::time,
                      0,
                      {{0, 46.5, 9.751}, {1, 46.501, 9.751, false}, {2, 46.502, 9.751}, {3, 46.503, 9.751}}},
                     {"b.log", "b", GhostAlign::place, {}, {{0, 46.5, 9.751, false}, {1, 46.501, 9.751}, {2, 48, 9.751}}},
                     {"c.log", "c", GhostAlign::takeoff, 4, {{0, 50, 9.751}, {1, 50.1, 9.751}}}};
    const std::string html = html_report(beside, short_story(), {});
    EXPECT_THAT(html, HasSubstr("Violet, without phases: ghost a, ghost b, ghost c."));
    EXPECT_THAT(html, HasSubstr("The line of ghost a has gaps where its log has no position."));
    EXPECT_THAT(html, HasSubstr("The line of ghost b is cut at the border: a part of its flight lies beyond this map"));
    EXPECT_THAT(html, HasSubstr("ghost b has gaps where its log has no position, or where it was not near this flight."));
    EXPECT_THAT(html, HasSubstr("All of ghost c lies beyond this map"));
    EXPECT_THAT(html, Not(HasSubstr("The line of ghost c")));
    EXPECT_THAT(html_report(summary(), short_story(), {}), Not(HasSubstr("Violet")));
}

/// So that its page and its time are small.
TEST(HtmlReport, ALongGhostIsThinnedButKeepsItsGaps) {
    RunSummary beside = summary();
    beside.ghosts = {{"a.log", "a", GhostAlign::time, 0, {}}};
    for (int n = 0; n < 10'000; ++n)
        beside.ghosts[0].places.push_back({1.0 * n, 46.495 + 1e-6 * n, 9.751, n != 5001 && n != 7003});
    const std::string html = html_report(beside, short_story(), {});
    const std::string color = "stroke='#8a2fc0'";
    std::size_t lines = 0;
    for (std::size_t at = html.find(color); at != std::string::npos; at = html.find(color, at + 1)) ++lines;
    EXPECT_EQ(lines, 3u);
    EXPECT_LT(html.size(), html_report(summary(), short_story(), {}).size() + 120'000);
}

TEST(HtmlReport, WritesBothFilesWhole) {
    const test_support::TemporaryFolder folder;
    write_run_reports(folder.path(), summary(), short_story(), {});
    EXPECT_EQ(nlohmann::json::parse(folder.read("summary.json"))["frames"], 5);
    EXPECT_THAT(folder.read("report.html"), HasSubstr("</html>"));
    EXPECT_EQ(folder.entries(), 2u);
    test_support::expect_user_error([&] { write_run_reports(folder.file("none"), summary(), short_story(), {}); },
                                    "summary.json");
}

}  // namespace
}  // namespace tedavis::host_sim::test_html_report
