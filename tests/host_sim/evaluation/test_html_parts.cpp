#include "host_sim/evaluation/html_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace tedavis::host_sim::test_html_parts {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(HtmlParts, EscapeTheirTexts) {
    const std::string bad = "<i>&'\"";
    for (const std::string& html :
         {html_section(bad, ""), html_cell(bad), html_number(bad), html_aside(bad), html_phase(bad), html_fact(bad, bad),
          html_figure("", bad, bad), layer_bar({{bad, 1, 1}}, ""), layer_key({{bad, 1, 1}})})
        EXPECT_THAT(html, Not(HasSubstr("<i>"))) << html;
}

TEST(HtmlParts, TheKeySaysWhatTheOutlineMeansWhereThereIsOne) {
    EXPECT_THAT(layer_key({{"data", 1, 1}}), HasSubstr("comes first"));
    EXPECT_THAT(layer_key({{"data", 1, 1}}, false), Not(HasSubstr("comes first")));
}

TEST(HtmlParts, NumbersAsTheyAreRead) {
    EXPECT_EQ(seconds_text(312), "312.0 s");
    EXPECT_EQ(clutter_text(0.18749), "0.187");
    EXPECT_EQ(percent_text(0.336), "34 %");
}

TEST(HtmlParts, ABarIsAsWideAsItsShares) {
    const std::string bar = layer_bar({{"terrain", 0.6, 0.5}, {"data", 0.4, 0.5}, {"labels", 0, 0}}, "data");
    double sum = 0;
    const std::regex width("width:([0-9.]+)%");
    for (std::sregex_iterator it(bar.begin(), bar.end(), width), end; it != end; ++it) sum += std::stod((*it)[1]);
    EXPECT_NEAR(sum, 100, 1e-9);
    EXPECT_THAT(bar, HasSubstr("class='first' title='data 40 %, comes first'"));
    EXPECT_THAT(bar, Not(HasSubstr("labels")));
    EXPECT_EQ(layer_bar({}, "data"), "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_html_parts
