#include "bus/switches/switch_log_source.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_switch_log_source {
namespace {

constexpr base::Time kEnd{std::numeric_limits<std::int64_t>::max()};

const char* const kLog =
    "# tedavis switch log 1\n"
    "(1700000000.000000) p.A 1\n"
    "(1700000000.000000) p.B 0\n"
    "\n"
    "(1700000000.000000) p.C 0\n"
    "(1700000001.000000) p.Z 1\n"
    "(1700000002.000000) p.A x\n"
    "(1700000003.000000) p.A 0\r\n"
    "(1700000002.500000) p.B 1\n"
    "(1700000003.010000) p.B 1";

std::vector<SwitchEdge> read_all(SwitchLogSource& source, base::Time until, std::size_t portion) {
    std::vector<SwitchEdge> all, out(portion);
    for (std::size_t count = 1; count > 0;) {
        count = source.read(until, out);
        all.insert(all.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count));
    }
    return all;
}

TEST(SwitchLogSource, edges_come_up_to_the_time_asked_for) {
    SwitchLogSource source(kLog, three_lines());
    EXPECT_EQ(read_all(source, at_ms(-1), 8).size(), 0u);
    EXPECT_EQ(read_all(source, at_ms(0), 8).size(), 3u) << "the levels at start";
    EXPECT_EQ(source.health(), SourceHealth::running);
    EXPECT_EQ(read_all(source, at_ms(2999), 8).size(), 0u);
    EXPECT_EQ(read_all(source, at_ms(3000), 8).size(), 1u);
    const auto last = read_all(source, kEnd, 8);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].line, 1) << "the last line needs no newline";
    EXPECT_EQ(source.health(), SourceHealth::ended);
    EXPECT_EQ(source.statistics().edges, 5u);
}

TEST(SwitchLogSource, broken_lines_are_counted_and_named_by_number) {
    SwitchLogSource source(kLog, three_lines());
    static_cast<void>(read_all(source, kEnd, 8));
    EXPECT_EQ(source.statistics().malformed, 2u);
    EXPECT_EQ(source.statistics().unknown_lines, 1u);
    ASSERT_EQ(source.reports().size(), 3u);
    EXPECT_EQ(source.reports()[0].line, 6u);
    EXPECT_EQ(source.reports()[0].fault, SwitchLineFault::line_name);
    EXPECT_EQ(source.reports()[1].line, 7u);
    EXPECT_EQ(source.reports()[1].fault, SwitchLineFault::level);
    EXPECT_EQ(source.reports()[2].line, 9u);
    EXPECT_EQ(source.reports()[2].fault, SwitchLineFault::time_runs_back);
}

TEST(SwitchLogSource, the_portion_size_makes_no_difference) {
    SwitchLogSource one(kLog, three_lines()), many(kLog, three_lines());
    const auto a = read_all(one, kEnd, 1), b = read_all(many, kEnd, 100);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].time, b[i].time);
        EXPECT_EQ(a[i].line, b[i].line);
        EXPECT_EQ(a[i].level, b[i].level);
    }
}

TEST(SwitchLogSource, restarting_gives_the_same_again) {
    SwitchLogSource source(kLog, three_lines());
    const auto first = read_all(source, kEnd, 3);
    source.restart();
    EXPECT_EQ(source.statistics().malformed, 0u);
    EXPECT_EQ(read_all(source, kEnd, 3).size(), first.size());
    EXPECT_EQ(source.statistics().malformed, 2u);
    EXPECT_EQ(source.reports().size(), 3u);
}

TEST(SwitchLogSource, rubbish_is_survived_and_counted) {
    std::mt19937 random(17);
    std::string rubbish;
    for (int i = 0; i < 100'000; ++i) rubbish += static_cast<char>(random());
    SwitchLogSource source(rubbish, three_lines());
    EXPECT_EQ(read_all(source, kEnd, 16).size(), 0u);
    EXPECT_GT(source.statistics().malformed, 100u);
    EXPECT_EQ(source.reports().size(), kMaxSwitchLineReports) << "only the first are kept";
    EXPECT_EQ(source.health(), SourceHealth::ended);
}

TEST(SwitchLogSource, an_empty_text_has_ended) {
    SwitchLogSource source("", three_lines());
    EXPECT_EQ(read_all(source, kEnd, 4).size(), 0u);
    EXPECT_EQ(source.health(), SourceHealth::ended);
}

}  // namespace
}  // namespace tedavis::bus::test_switch_log_source
