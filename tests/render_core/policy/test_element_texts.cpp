// The table of red and amber texts is the page of the module. What is drawn is compared with it in
// tests/render_core/draw/symbology/test_alert_texts.cpp.
#include "render_core/policy/element_texts.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <tuple>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/generated_page.hpp"

namespace tedavis::policy::test_element_texts {
namespace {

/// "IAS KT, STALE" as "`IAS KT`, `STALE`".
std::string quoted(std::string_view texts) {
    std::string quoted = "`";
    for (const char c : texts)
        quoted += c == ',' ? std::string("`,") : c == ' ' && quoted.back() == ',' ? " `" : std::string(1, c);
    return quoted + "`";
}

std::string texts_page() {
    std::string page = test_support::page_head({"element", "state", "color", "texts", "cause", "what is removed"});
    for (const ElementText& row : element_texts())
        page += test_support::page_row({row.place, name_of(row.show), row.color == TextColor::red ? "red" : "amber",
                                        quoted(row.texts), row.cause, row.removed});
    return page;
}

TEST(ElementTexts, AreThePageOfTheModule) {
    test_support::expect_page_part("render_core/policy/README.md", "texts", texts_page());
}

TEST(ElementTexts, EveryRowIsOfAKnownPlaceAndSaidInOneSentence) {
    std::set<std::string_view> places = {"phase", "distortion", "legend", "notices"};
    for (std::size_t n = 0; n < kElementCount; ++n)
        EXPECT_TRUE(places.insert(name_of(static_cast<Element>(n))).second) << name_of(static_cast<Element>(n));
    std::set<std::tuple<std::string_view, ElementShow, std::string_view>> rows;
    for (const ElementText& row : element_texts()) {
        EXPECT_EQ(places.count(row.place), 1u) << row.place;
        EXPECT_TRUE(rows.insert({row.place, row.show, row.texts}).second) << row.place << " has a row twice";
        for (const std::string_view cell : {row.cause, row.removed}) {
            ASSERT_FALSE(cell.empty()) << row.place;
            EXPECT_EQ(cell.find('.'), cell.size() - 1) << "one sentence: " << cell;
        }
    }
}

/// The failure table of the display is written by hand and names every element that a signal states.
TEST(ElementTexts, NamesAreThoseOfTheFailureTable) {
    const std::string page = test_support::source_file("render_core/display/README.md");
    for (std::size_t n = 0; n < kElementCount; ++n) {
        const auto element = static_cast<Element>(n);
        const bool has_no_signal = element == Element::flight_path || element == Element::position ||
                                   element == Element::map_up || element == Element::airspeed_trend;
        const std::string cell = "| " + std::string(name_of(element)) + " |";
        EXPECT_EQ(page.find(cell) == std::string::npos, has_no_signal) << cell;
    }
}

}  // namespace
}  // namespace tedavis::policy::test_element_texts
