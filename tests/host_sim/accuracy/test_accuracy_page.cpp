#include "host_sim/accuracy/accuracy_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <regex>

#include "tests/host_sim/accuracy/made_knob.hpp"
#include "tests/support/programs/browser_page.hpp"

namespace tedavis::host_sim::test_accuracy_page {
namespace {

using ::testing::HasSubstr;

AccuracyReport made_report() {
    AccuracyReport report = test_support::made_report();
    report.not_measured = {"another"};
    return report;
}

/// The numbers of a level's row, as the page has them.
std::vector<double> numbers_of(const std::string& page, const std::string& level) {
    const std::size_t begin = page.find("<th>" + level + "</th>"), end = page.find("</tr>", begin);
    if (begin == std::string::npos) return {};
    const std::string row = page.substr(begin, end - begin);
    const std::regex cell(R"(<td class='n'>([^<]*)</td>)");
    std::vector<double> numbers;
    for (std::sregex_iterator it(row.begin(), row.end(), cell), none; it != none; ++it)
        numbers.push_back(std::strtod((*it)[1].str().c_str(), nullptr));
    return numbers;
}

/// Median, mean error and greatest error of every level are those of the report.
bool has_the_numbers(const std::string& page, const AccuracyReport& report) {
    for (const MeasuredLevel& level : report.knobs[0].levels) {
        const std::vector<double> numbers = numbers_of(page, level.name);
        const double expected[] = {level.ms.median, level.error.mean, level.error.max};
        if (numbers.size() != 3) return false;
        for (std::size_t n = 0; n < 3; ++n)
            if (std::abs(numbers[n] - expected[n]) > 0.006 * expected[n]) return false;  // three digits are shown
    }
    return true;
}

TEST(AccuracyPage, ShowsTheNumbersOfTheReport) {
    const AccuracyReport report = made_report();
    std::string page = accuracy_page(report);
    EXPECT_TRUE(has_the_numbers(page, report));
    const std::size_t at = page.find("<td class='n'>", page.find("<th>4 steps</th>"));
    page.replace(at, 14, "<td class='n'>9");
    EXPECT_FALSE(has_the_numbers(page, report)) << "control: a wrong number";
}

TEST(AccuracyPage, SaysWhatAReaderAsksFirst) {
    const std::string page = accuracy_page(made_report());
    for (const char* const text :
         {"settings measured", "alps.tdb", "a renderer", "commit", "quick run", "What the next level costs",
          "Reference: the truth", "itself within 1e-09", "the measurement agrees", "are not ranked", "tedavis accuracy -o x",
          "Not measured", "another"})
        EXPECT_THAT(page, HasSubstr(text));
    EXPECT_THAT(page, ::testing::Not(HasSubstr("http"))) << "nothing comes from the network";
}

TEST(AccuracyPage, SaysWhyASettingHasOneLevel) {
    AccuracyReport report = made_report();
    EXPECT_THAT(accuracy_page(report), ::testing::Not(HasSubstr("Settings with one level"))) << "control";
    report.knobs.push_back(test_support::made_knob_of_one_level());
    const std::string page = accuracy_page(report);
    for (const char* const text : {"Settings with one level", "<td>ours</td><td class='n'>3.000</td>", "not offered",
                                   "The product has the first level only: one is enough."})
        EXPECT_THAT(page, HasSubstr(text));
    const std::size_t section = page.find("id='alone'");
    ASSERT_NE(section, std::string::npos);
    EXPECT_EQ(page.find("What the next level costs", section), std::string::npos);
    EXPECT_EQ(page.find("amount^", section), std::string::npos) << "no law of alternatives";
}

TEST(AccuracyPage, OpensInABrowserWithoutAMessage) {
    ASSERT_TRUE(test_support::has_browser()) << "Chromium is not installed (toolchains/install_packages tests)";
    const test_support::TemporaryFolder place;
    for (const int width : {1200, 400}) {
        const auto seen = test_support::open_in_browser(place, accuracy_page(made_report()), width);
        EXPECT_EQ(seen.failure, "");
        EXPECT_THAT(seen.console, ::testing::IsEmpty());
        EXPECT_THAT(seen.document, HasSubstr("What accuracy costs in time"));
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_page
