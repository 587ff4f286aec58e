// The table of notices: it is the page of the module, and the failure policy raises every row and nothing else.
#include "render_core/policy/notice_table.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/generated_page.hpp"
#include "tests/support/flights/random_policy.hpp"

namespace tedavis::policy::test_notice_table {
namespace {

constexpr int kCases = 20'000;
constexpr std::string_view kLevelNames[] = {"red", "amber", "white"};

std::string notices_page(base::Span<const NoticeRow> rows) {
    std::string page = test_support::page_head({"notice", "color", "flag", "cause", "what is removed", "what to do"});
    for (const NoticeRow& row : rows) {
        const std::string text = "`" + std::string(row.text) + "`",
                          flag = row.flag == RecordFlag::count_ ? "" : "`" + std::string(name_of(row.flag)) + "`";
        page += test_support::page_row(
            {text, kLevelNames[static_cast<std::size_t>(row.level)], flag, row.cause, row.removed, row.action});
    }
    return page;
}

/// The row of a notice; null where the table has none.
const NoticeRow* row_of(const Notice& notice) {
    for (const NoticeRow& row : notice_rows())
        if (row.text == notice.text.view() && row.level == notice.level) return &row;
    return nullptr;
}

std::set<NoticeId> all_ids() {
    std::set<NoticeId> ids;
    for (const NoticeRow& row : notice_rows()) ids.insert(row.id);
    return ids;
}

TEST(NoticeTable, IsThePageOfTheModule) {
    test_support::expect_page_part("render_core/policy/README.md", "notices", notices_page(notice_rows()));
}

/// Control: one word of a copy of the page.
TEST(NoticeTable, AChangedTextIsNotThePage) {
    std::string copy = test_support::source_file("render_core/policy/README.md");
    EXPECT_EQ(test_support::page_part(copy, "notices"), notices_page(notice_rows()));
    const std::size_t at = copy.find("OUTSIDE DATABASE");
    ASSERT_NE(at, std::string::npos);
    copy.replace(at, 7, "BEYOND ");
    EXPECT_NE(test_support::page_part(copy, "notices"), notices_page(notice_rows()));
}

TEST(NoticeTable, RowsAreToldApartAndFitTheNotice) {
    std::set<std::pair<std::string_view, NoticeLevel>> texts;
    for (const NoticeRow& row : notice_rows()) {
        EXPECT_TRUE(texts.insert({row.text, row.level}).second) << row.text;
        EXPECT_FALSE(base::FixedString<31>(row.text).cut()) << row.text;
        for (const std::string_view cell : {row.cause, row.removed, row.action}) {
            ASSERT_FALSE(cell.empty()) << row.text;
            EXPECT_EQ(cell.find('.', 0), cell.size() - 1) << "one sentence: " << cell;
        }
    }
}

/// The ids that a policy raises over many cases, which `limit` may narrow.
template <class Limit>
std::set<NoticeId> ids_raised(const Limit& limit) {
    std::set<NoticeId> seen;
    test_support::RandomPolicy random(1);
    for (int n = 0; n < kCases; ++n) {
        test_support::PolicyCase made = random.next();
        limit(made);
        for (const Notice& notice : made.decide().notices)
            if (const NoticeRow* row = row_of(notice); row != nullptr) seen.insert(row->id);
    }
    return seen;
}

TEST(NoticeTable, EveryNoticeHasAConditionThatRaisesIt) {
    EXPECT_EQ(ids_raised([](test_support::PolicyCase&) {}), all_ids());
}

TEST(NoticeTable, ANoticeWithoutItsConditionIsFoundMissing) {
    std::set<NoticeId> without = all_ids();
    without.erase(NoticeId::generated_flight);
    EXPECT_EQ(ids_raised([](test_support::PolicyCase& made) { made.conditions.generated_flight = false; }), without);
}

TEST(NoticeTable, NoticesComeFromTheTableInItsOrderAndWithTheirFlags) {
    test_support::RandomPolicy random(2);
    for (int n = 0; n < kCases; ++n) {
        const DisplayDecisions decisions = random.next().decide();
        const NoticeRow* before = nullptr;
        for (const Notice& notice : decisions.notices) {
            const NoticeRow* const row = row_of(notice);
            ASSERT_NE(row, nullptr) << notice.text.view();
            EXPECT_TRUE(before == nullptr || before->id < row->id) << row->text;
            EXPECT_TRUE(before == nullptr || before->level <= row->level) << row->text;
            const bool has_flag =
                row->flag == RecordFlag::count_ || test_support::has_flag(decisions, std::string(name_of(row->flag)));
            EXPECT_TRUE(has_flag) << row->text;
            before = row;
        }
    }
}

}  // namespace
}  // namespace tedavis::policy::test_notice_table
