#include "host_sim/sweep/sweep_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/host_sim/sweep/made_sweep.hpp"
#include "tests/support/programs/browser_page.hpp"

namespace tedavis::host_sim::test_sweep_report {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

TEST(SweepReport, HasATableAHeight) {
    const std::string page = sweep_report_page(test_support::made_sweep());
    for (const char* part : {"Viewpoints round 36.6000, -84.2500", "a &lt;b&gt;.tdb", "From 500 m above the place",
                             "From 1500 m above the place", "<th>6000 m</th>", "from 270&deg;", "below the ground",
                             "outside the terrain", "place 3.0 &times;", "behind terrain", "most clutter", "not certified"})
        EXPECT_THAT(page, HasSubstr(part));
    EXPECT_EQ(count(page, "<td class='none'>"), 2u);
    EXPECT_EQ(count(page, "class='out'"), 2u) << "those that stand out are marked";
    EXPECT_EQ(count(page, "<img "), 14u + 2 * 3);
    EXPECT_EQ(count(page, "<img alt='"), count(page, "<img ")) << "each picture is told in words";
    EXPECT_THAT(page, Not(HasSubstr("interrupted")));
    EXPECT_THAT(page, Not(HasSubstr("comes first in the design")));
}

TEST(SweepReport, NeedsNothingButItself) {
    const std::string page = sweep_report_page(test_support::made_sweep());
    for (const char* part : {"http", "<link", "@import", "url(", "href="}) EXPECT_THAT(page, Not(HasSubstr(part)));
    for (const std::string element : {"section", "article", "table", "tr", "td", "th", "figure", "div", "p"})
        EXPECT_EQ(count(page, "<" + element + ">") + count(page, "<" + element + " "), count(page, "</" + element + ">"))
            << element;
}

TEST(SweepReport, SaysWhatIsMissing) {
    Sweep sweep = test_support::made_sweep();
    sweep.views.resize(9);
    sweep.standing_out.clear();
    sweep.interrupted = true;
    const std::string page = sweep_report_page(sweep);
    EXPECT_THAT(page, HasSubstr("interrupted, the rest is missing"));
    EXPECT_EQ(count(page, "not drawn"), 5u);
}

constexpr const char* kLooker = R"js(<script>
window.addEventListener("load",function(){
var shown=Array.prototype.filter.call(document.images,function(i){return i.complete&&i.naturalWidth>0&&i.getClientRects().length>0;});
var v={pictures:shown.length,overflow:document.documentElement.scrollWidth-window.innerWidth};
var pre=document.createElement("pre");pre.id="verdict";pre.textContent=JSON.stringify(v);document.body.appendChild(pre);
});
</script>)js";

TEST(SweepReport, OpensInABrowser) {
    ASSERT_TRUE(test_support::has_browser()) << "Chromium is not installed (toolchains/install_packages tests)";
    const test_support::TemporaryFolder place;
    for (const int width : {1280, 600}) {
        std::string page = sweep_report_page(test_support::made_sweep());
        const auto seen = test_support::open_in_browser(place, page.insert(page.rfind("</body>"), kLooker), width);
        EXPECT_EQ(seen.failure, "");
        EXPECT_THAT(seen.console, IsEmpty());
        std::smatch found;
        ASSERT_TRUE(std::regex_search(seen.document, found, std::regex("<pre id=\"verdict\">([^<]*)</pre>")));
        const auto verdict = nlohmann::json::parse(found[1].str());
        EXPECT_EQ(verdict["pictures"], 20);
        EXPECT_LE(verdict["overflow"], 0) << "nothing is wider than the screen";
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_sweep_report
