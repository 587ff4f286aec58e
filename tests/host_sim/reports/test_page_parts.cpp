#include "host_sim/reports/page_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_page_parts {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(PageParts, TextsAreSafeAndHtmlIsNot) {
    EXPECT_EQ(text_cell("<b> & 'c'"), "<td>&lt;b&gt; &amp; &#39;c&#39;</td>");
    EXPECT_EQ(number_cell("<b>1</b>"), "<td class='n'><b>1</b></td>");
    EXPECT_EQ(page_section("A", "<p>b</p>"), "<section><h2>A</h2><p>b</p></section>\n");
    EXPECT_THAT(page_figure("<c>", "abc"), HasSubstr("alt='&lt;c&gt;' src='data:image/png;base64,YWJj'"));
    EXPECT_THAT(page_table("<th>h</th>", "<tr></tr>"), HasSubstr("<thead><tr><th>h</th></tr></thead><tbody><tr></tr></tbody>"));
    EXPECT_EQ(folded_part("more", "x"), "<details><summary>more</summary>x</details>\n");
}

TEST(PageParts, APageIsWhole) {
    const std::string page = html_page("A & B", "<p>x</p>", ".mine{}");
    EXPECT_THAT(page, StartsWith("<!DOCTYPE html>\n<html lang='en'><head>"));
    EXPECT_THAT(page, HasSubstr("<title>A &amp; B</title>"));
    EXPECT_THAT(page, HasSubstr(".mine{}</style>"));
    EXPECT_THAT(page, EndsWith("<p>x</p></body></html>\n"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_page_parts
