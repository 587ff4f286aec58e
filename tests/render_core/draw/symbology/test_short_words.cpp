#include "render_core/draw/symbology/short_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/policy/notice_table.hpp"
#include "tests/support/files/generated_page.hpp"

namespace tedavis::draw::test_short_words {
namespace {

constexpr float kEm_px = 11;

/// What is wrong with a table of short wordings; empty: nothing.
std::string fault_in(const std::vector<ShortWording>& rows) {
    for (const ShortWording& row : rows) {
        const std::string name(row.whole);
        if (row.shorter.empty() || text_width_px(row.shorter, kEm_px) >= text_width_px(row.whole, kEm_px))
            return name + " is not shorter";
        if (row.shorter.find('.') != std::string_view::npos) return name + " is cut";
        for (const ShortWording& other : rows) {
            if (&other != &row && (other.whole == row.whole || other.shorter == row.shorter)) return name + " is there twice";
            if (other.whole == row.shorter) return name + " becomes another text";
        }
        for (const policy::NoticeRow& notice : policy::notice_rows())
            if (notice.text == row.shorter) return name + " becomes another notice";
    }
    return "";
}

std::vector<ShortWording> table() { return {short_wordings().begin(), short_wordings().end()}; }

TEST(ShortWords, EveryOneIsShorterAndOfOneTextOnly) {
    EXPECT_EQ(fault_in(table()), "");
    std::vector<ShortWording> rows = table();
    rows.push_back({"TERRAIN OFF", "TERRAIN FAIL"});
    EXPECT_NE(fault_in(rows), "") << "control: another notice";
    rows.back() = {"TRK MAG", "HDG M"};
    EXPECT_NE(fault_in(rows), "") << "control: the wording of two texts";
    rows.back() = {"MINIMUMS", "MIN.."};
    EXPECT_NE(fault_in(rows), "") << "control: cut";
    rows.back() = {"OFF", "SWITCHED OFF"};
    EXPECT_NE(fault_in(rows), "") << "control: longer";
}

TEST(ShortWords, TheWholeStandsWhereItHasRoom) {
    for (const ShortWording& row : short_wordings()) {
        const float whole_px = text_width_px(row.whole, kEm_px);
        EXPECT_EQ(short_words(row.whole).within(whole_px, kEm_px), row.whole);
        EXPECT_EQ(short_words(row.whole).within(whole_px - 1, kEm_px), row.shorter);
        EXPECT_EQ(short_words_or_none(row.whole).within(whole_px - 1, kEm_px), row.shorter);
        EXPECT_EQ(short_words_or_none(row.whole).within(5, kEm_px), "");
    }
    EXPECT_EQ(short_wording("MINIMUMS"), "MINIMUMS");
    EXPECT_EQ(short_words("MINIMUMS").within(5, kEm_px), "MINIMUMS");
}

TEST(ShortWords, AreThePageOfTheModule) {
    std::string page = test_support::page_head({"text", "where it has no room"});
    for (const ShortWording& row : short_wordings()) page += test_support::page_row({row.whole, row.shorter});
    test_support::expect_page_part("render_core/draw/symbology/README.md", "short words", page);
}

}  // namespace
}  // namespace tedavis::draw::test_short_words
