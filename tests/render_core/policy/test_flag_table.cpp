// The table of flags: it is the page of the module, and the failure policy raises its rows, states of signals, and nothing else.
#include "render_core/policy/flag_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "tests/support/files/generated_page.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/flights/random_policy.hpp"

namespace tedavis::policy::test_flag_table {
namespace {

/// Those that planner and record add to the policy's; tests of the display look at them.
constexpr RecordFlag kOfTheDisplay[] = {RecordFlag::vertical_accuracy_assumed,
                                        RecordFlag::terrain_failing,
                                        RecordFlag::terrain_accuracy_assumed,
                                        RecordFlag::terrain_tau_raised,
                                        RecordFlag::terrain_late,
                                        RecordFlag::terrain_void,
                                        RecordFlag::terrain_not_traced,
                                        RecordFlag::ground_data_missing,
                                        RecordFlag::ground_data_no_date,
                                        RecordFlag::ground_data_unit,
                                        RecordFlag::adjacent_missing,
                                        RecordFlag::adjacent_cut,
                                        RecordFlag::adjacent_unit,
                                        RecordFlag::data_missing,
                                        RecordFlag::legend_cut,
                                        RecordFlag::utc_lost,
                                        RecordFlag::deadline_missed,
                                        RecordFlag::arithmetic_changed};

bool is_of_the_display(RecordFlag flag) {
    return std::find(std::begin(kOfTheDisplay), std::end(kOfTheDisplay), flag) != std::end(kOfTheDisplay);
}

std::string flags_page(base::Span<const FlagRow> rows) {
    std::string page = test_support::page_head({"flag", "raised in", "cause", "consequence"});
    for (const FlagRow& row : rows) {
        const std::string name = "`" + std::string(row.name) + "`";
        page +=
            test_support::page_row({name, is_of_the_display(row.flag) ? "`display`" : "`policy`", row.cause, row.consequence});
    }
    return page;
}

/// "signal.state" of a rule that asks for a flag.
std::set<std::string> signal_flags() {
    std::set<std::string> names;
    for (const SignalRule& rule : signal_rules())
        for (const base::SignalState state : test_support::kBadStates)
            if ((consequences(rule, state) & kFlag) != 0)
                names.insert(std::string(to_string(rule.signal)) + "." + to_string(state));
    return names;
}

TEST(FlagTable, IsThePageOfTheModule) {
    test_support::expect_page_part("render_core/policy/README.md", "flags", flags_page(flag_rows()));
}

TEST(FlagTable, NamesAreUniqueAndNoStatesOfSignals) {
    std::set<std::string> names = signal_flags();
    for (const FlagRow& row : flag_rows()) {
        EXPECT_TRUE(names.insert(std::string(row.name)).second) << row.name;
        EXPECT_FALSE(base::FixedString<47>(row.name).cut()) << row.name;
        EXPECT_EQ(name_of(row.flag), row.name);
        for (const std::string_view cell : {row.cause, row.consequence}) {
            ASSERT_FALSE(cell.empty()) << row.name;
            EXPECT_EQ(cell.find('.'), cell.size() - 1) << "one sentence: " << cell;
        }
    }
}

TEST(FlagTable, ThePolicyRaisesItsFlagsAndNoOthers) {
    std::set<std::string> expected = signal_flags(), seen;
    for (const FlagRow& row : flag_rows())
        if (!is_of_the_display(row.flag)) expected.insert(std::string(row.name));
    test_support::RandomPolicy random(3);
    for (int n = 0; n < 20'000; ++n)
        for (const std::string& name : test_support::flags_of(random.next().decide())) seen.insert(name);
    for (const std::string& name : seen) EXPECT_EQ(expected.count(name), 1u) << name << " is in no table";
    for (const FlagRow& row : flag_rows())
        EXPECT_EQ(seen.count(std::string(row.name)), is_of_the_display(row.flag) ? 0u : 1u) << row.name;
}

/// What the sources of a folder say after "RecordFlag::".
std::set<std::string> flags_named_in(const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test_support::source_dir() + "/" + folder)) {
        if (entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        const std::string text{std::istreambuf_iterator<char>(file), {}}, mark = "RecordFlag::";
        for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
            const std::size_t begin = at + mark.size();
            names.insert(text.substr(begin, text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", begin) - begin));
        }
    }
    return names;
}

TEST(FlagTable, TheDisplayNamesItsFlagsAndNoOthers) {
    std::set<std::string> expected;
    for (const RecordFlag flag : kOfTheDisplay) {
        std::string name(name_of(flag));
        std::replace(name.begin(), name.end(), '.', '_');
        expected.insert(name);
    }
    EXPECT_EQ(flags_named_in("render_core/display"), expected);
    EXPECT_NE(flags_named_in("render_core/policy"), expected) << "the control";
}

/// Control: without its condition a flag is not seen.
TEST(FlagTable, AFlagWithoutItsConditionIsNotRaised) {
    test_support::RandomPolicy random(3);
    for (int n = 0; n < 2000; ++n) {
        test_support::PolicyCase made = random.next();
        made.state.traffic.is_cut = false;
        EXPECT_FALSE(test_support::has_flag(made.decide(), "traffic.cut"));
    }
}

}  // namespace
}  // namespace tedavis::policy::test_flag_table
