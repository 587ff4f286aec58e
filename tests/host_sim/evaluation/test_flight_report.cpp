#include "host_sim/evaluation/flight_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/browser_page.hpp"

namespace tedavis::host_sim::test_flight_report {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

FlightReport single(bool with_layers = false) {
    FlightReport report;
    report.flights.push_back(test_support::made_flight(90));
    if (with_layers) test_support::give_layers(report.flights[0]);
    test_support::give_moments(report.flights[0]);
    return report;
}

FlightReport two() {
    FlightReport report;
    report.flights = {test_support::made_flight(90), test_support::made_flight(90, 0.15)};
    report.flights[1].run.design = "cruise";
    report.comparison = compared(report.flights[0], report.flights[1]);
    test_support::give_moments(report.flights[0], "A");
    test_support::give_moments(report.flights[1], "B");
    return report;
}

std::size_t count(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    return static_cast<std::size_t>(
        std::distance(std::sregex_iterator(text.begin(), text.end(), expression), std::sregex_iterator()));
}

TEST(FlightReport, TellsTheFlight) {
    const std::string page = flight_report_page(single());
    for (const char* part : {"<!DOCTYPE html>", "flight &lt;1&gt;.log", "approach.final", "id='moment-A'", "id='moment-C'",
                             "Peaks rise by at least", "Where the clutter is", "not certified", "<desc>Line graph of clutter"})
        EXPECT_THAT(page, HasSubstr(part));
    EXPECT_THAT(page, Not(HasSubstr("What draws the eye"))) << "without layer masks";
    EXPECT_THAT(page, Not(HasSubstr("Recorded gaze")));
    EXPECT_EQ(count(page, "<tr class='all'>"), 1u);
}

TEST(FlightReport, OtherMeasuresAreHeldAgainstTheEdges) {
    FlightReport report = single();
    EXPECT_THAT(flight_report_page(report), Not(HasSubstr("pairs of peaks"))) << "all are alike";
    test_support::give_disputed_moments(report.flights[0]);
    const std::string page = flight_report_page(report);
    EXPECT_THAT(page, HasSubstr("Of 3 pairs of peaks Feature Congestion orders 3 as the edges do, Subband Entropy 2."));
    EXPECT_THAT(page, HasSubstr("Feature Congestion 6.00, Subband Entropy 3.60 bits"));
}

TEST(FlightReport, ThePrioritizedAspectIsMarked) {
    const std::string page = flight_report_page(single(true));
    EXPECT_THAT(page, HasSubstr("What draws the eye"));
    EXPECT_THAT(page, HasSubstr("<td class='n first'>30 % &#9670;</td>")) << "data in cruise";
    EXPECT_THAT(page, HasSubstr("<td class='n first'>50 % &#9670;</td>")) << "terrain in the approach";
}

TEST(FlightReport, TwoDesignsStandInOneGraph) {
    const std::string page = flight_report_page(two());
    for (const char* part : {"Clutter of two designs", "A default", "B cruise", "stroke-dasharray='6 3'", "Differences by phase",
                             "class='n more'>+0.050", "id='moment-A1'", "id='moment-B3'"})
        EXPECT_THAT(page, HasSubstr(part));
}

TEST(FlightReport, GazeHasATable) {
    FlightReport report = single();
    report.flights[0].measures[4].gaze = GazeScore{7, 0.625, std::nullopt};
    const std::string page = flight_report_page(report);
    EXPECT_THAT(page, HasSubstr("Recorded gaze"));
    EXPECT_THAT(page, HasSubstr("0.625"));
    EXPECT_THAT(page, HasSubstr("flat"));
}

// Nothing is fetched: pictures are data, links lead within the page.
TEST(FlightReport, NeedsNothingButItself) {
    for (const std::string& page : {flight_report_page(single(true)), flight_report_page(two())}) {
        for (const char* part : {"http", "<link", "@import", "url("}) EXPECT_THAT(page, Not(HasSubstr(part)));
        const std::regex source("(src|href)=[\"']([^\"']{0,22})");
        for (std::sregex_iterator it(page.begin(), page.end(), source), end; it != end; ++it) {
            const std::string target = (*it)[2].str();
            EXPECT_TRUE(target == "data:image/png;base64," || target[0] == '#') << target;
        }
        for (const char* element :
             {"section", "article", "table", "tr", "td", "figure", "svg", "div", "ul", "li", "dl", "a", "details"})
            EXPECT_EQ(count(page, std::string("<") + element + "[ >]"), count(page, std::string("</") + element + ">"))
                << element;
        EXPECT_EQ(count(page, "<img "), count(page, "<img alt='[^']+'")) << "each picture is told in words";
    }
}

TEST(FlightReport, EveryMarkLeadsToACard) {
    const std::string page = flight_report_page(two());
    const std::regex link("href='#([^']+)'");
    std::size_t links = 0;
    for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it, ++links)
        EXPECT_EQ(count(page, "id='" + (*it)[1].str() + "'"), 1u);
    EXPECT_EQ(links, 6u * 3) << "two drawings and the list, three peaks of each";
}

/// Reads the page as a user does: looks at the graph, clicks the last peak in it, and says what is to be seen then.
constexpr const char* kUser = R"js(<script>
window.addEventListener("load",function(){
function seen(e){return e.getClientRects().length>0;}
function all(s){return Array.prototype.slice.call(document.querySelectorAll(s));}
var v={};
v.graphs=all("svg.chart").filter(seen).length;
v.curves=all("svg.chart > path").filter(function(p){return seen(p)&&p.getTotalLength()>100;}).length;
v.phases=all("svg.chart rect").filter(seen).length;
v.overflow=document.documentElement.scrollWidth-window.innerWidth;
v.first=all(".moment").filter(seen).map(function(m){return m.id;});
var marks=all("svg.chart a.mark").filter(seen);
v.marks=marks.length;
if(marks.length>0)marks[marks.length-1].dispatchEvent(new MouseEvent("click",{bubbles:true,cancelable:true,view:window}));
setTimeout(function(){
var cards=all(".moment").filter(seen);
v.clicked=cards.map(function(m){return m.id;});
v.pictures=cards.length===0?0:Array.prototype.slice.call(cards[0].querySelectorAll("img")).filter(function(i){
return seen(i)&&i.complete&&i.naturalWidth>0;}).length;
var pre=document.createElement("pre");pre.id="verdict";pre.textContent=JSON.stringify(v);document.body.appendChild(pre);
},500);
});
</script>)js";

nlohmann::json verdict_of(const std::string& document) {
    std::smatch found;
    if (!std::regex_search(document, found, std::regex("<pre id=\"verdict\">([^<]*)</pre>"))) return {};
    return nlohmann::json::parse(found[1].str(), nullptr, false);
}

class ReportInABrowser : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(test_support::has_browser()) << "Chromium is not installed (toolchains/install_packages tests)";
    }
    /// What the user saw, and what the console said.
    nlohmann::json use(std::string page, int width = 1280) {
        const std::size_t end = page.rfind("</body>");
        seen_ = test_support::open_in_browser(place_, page.insert(end, kUser), width);
        EXPECT_EQ(seen_.failure, "");
        return verdict_of(seen_.document);
    }
    test_support::TemporaryFolder place_;
    test_support::BrowserPage seen_;
};

TEST_F(ReportInABrowser, AClickOnAPeakShowsItsPictures) {
    for (const int width : {1280, 600}) {
        const nlohmann::json verdict = use(flight_report_page(single(true)), width);
        EXPECT_THAT(seen_.console, IsEmpty());
        EXPECT_EQ(verdict["graphs"], 1) << "one of the two drawings";
        EXPECT_EQ(verdict["curves"], 1);
        EXPECT_EQ(verdict["phases"], 2);
        EXPECT_EQ(verdict["marks"], 3);
        EXPECT_EQ(verdict["first"], nlohmann::json({"moment-A"}));
        EXPECT_EQ(verdict["clicked"], nlohmann::json({"moment-C"}));
        EXPECT_EQ(verdict["pictures"], 5);
        EXPECT_LE(verdict["overflow"], 0) << "nothing is wider than the screen";
    }
}

TEST_F(ReportInABrowser, TwoDesignsToo) {
    const nlohmann::json verdict = use(flight_report_page(two()));
    EXPECT_THAT(seen_.console, IsEmpty());
    EXPECT_EQ(verdict["curves"], 2);
    EXPECT_EQ(verdict["clicked"], nlohmann::json({"moment-B3"}));
    EXPECT_EQ(verdict["pictures"], 10);
}

std::string with(std::string page, const std::string& what, const std::string& instead) {
    const std::size_t at = page.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? page : page.replace(at, what.size(), instead);
}

// Negative controls: the check sees each kind of fault.
TEST_F(ReportInABrowser, ABrokenPageIsFound) {
    const std::string page = flight_report_page(single());
    (void)use(with(page, "classList.toggle(\"shown\"", "classList.toggel(\"shown\""));
    EXPECT_FALSE(seen_.console.empty());
    EXPECT_THAT(seen_.console, ::testing::Each(HasSubstr("toggel")));
    const nlohmann::json deaf = use(with(page, "addEventListener(\"hashchange\"", "addEventListener(\"hashchanged\""));
    EXPECT_EQ(deaf["clicked"], nlohmann::json({"moment-A"})) << "the click does nothing";
    std::string blind_page = page;
    for (std::size_t at = 0; (at = blind_page.find("base64,", at)) != std::string::npos; at += 8) blind_page[at + 7] = '!';
    EXPECT_EQ(use(blind_page)["pictures"], 0) << "no picture can be shown";
    EXPECT_EQ(use(with(page, "<path d='M", "<path d='X"))["curves"], 0) << "no graph";
}

// Without scripts every card stands there, and marks lead to them.
TEST_F(ReportInABrowser, WorksWithoutScripts) {
    const std::string page = flight_report_page(single());
    const std::size_t begin = page.rfind("<script>"), end = page.rfind("</script>");
    const nlohmann::json verdict = use(page.substr(0, begin) + page.substr(end + 9));
    EXPECT_EQ(verdict["first"].size(), 3u);
    EXPECT_EQ(verdict["pictures"], 5);
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_report
