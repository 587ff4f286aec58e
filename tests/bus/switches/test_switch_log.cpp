#include "bus/switches/switch_log.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_switch_log {
namespace {

SwitchLogLine parse(const std::string& line) { return parse_switch_log_line(line, three_lines()); }

TEST(SwitchLog, an_edge_is_read) {
    const SwitchLogLine line = parse("(1700000000.123456) p.B 1");
    ASSERT_EQ(line.kind, SwitchLineKind::edge);
    EXPECT_EQ(line.edge.time.ns, 1'700'000'000'123'456'000);
    EXPECT_EQ(line.edge.line, 1);
    EXPECT_TRUE(line.edge.level);
    EXPECT_EQ(parse("(0.000000001) p.A 0").edge.time.ns, 1);
    EXPECT_EQ(parse("  (0000000007.000001)\t p.C  0 \r").edge.time.ns, 7'000'001'000)
        << "blanks and carriage returns are allowed";
}

TEST(SwitchLog, comments_and_blank_lines_are_no_faults) {
    for (const char* text : {"", "   ", "\r", "# tedavis switch log 1", "  # (1.000000) p.A 1"})
        EXPECT_EQ(parse(text).kind, SwitchLineKind::comment) << text;
}

TEST(SwitchLog, every_way_to_break_a_line_is_named) {
    struct Case {
        const char* text;
        SwitchLineKind kind;
        SwitchLineFault fault;
    };
    const auto bad = SwitchLineKind::malformed;
    const Case cases[] = {
        {"1700000000.123456 p.A 1", bad, SwitchLineFault::time_stamp},
        {"(1700000000) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(1700000000.12345) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(1700000000.1234567) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(17000000001.123456) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(9999999999.123456) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(.123456) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(-1.123456) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(1.12345x) p.A 1", bad, SwitchLineFault::time_stamp},
        {"(nan.000000) p.A 1", bad, SwitchLineFault::time_stamp},
        {"()", bad, SwitchLineFault::time_stamp},
        {"(1.123456 p.A 1", bad, SwitchLineFault::time_stamp},
        {"(1.123456) p.A", bad, SwitchLineFault::level},
        {"(1.123456) p.A 2", bad, SwitchLineFault::level},
        {"(1.123456) p.A 01", bad, SwitchLineFault::level},
        {"(1.123456) p.A 1 1", bad, SwitchLineFault::level},
        {"(1.123456)", bad, SwitchLineFault::level},
        {"(1.123456) p.Z 1", SwitchLineKind::unknown_line, SwitchLineFault::line_name},
        {"(1.123456) A 1", SwitchLineKind::unknown_line, SwitchLineFault::line_name},
        {"(1.123456) P.A 1", SwitchLineKind::unknown_line, SwitchLineFault::line_name},
    };
    for (const Case& c : cases) {
        EXPECT_EQ(parse(c.text).kind, c.kind) << c.text;
        EXPECT_EQ(parse(c.text).fault, c.fault) << c.text << ": " << describe(parse(c.text).fault);
    }
}

TEST(SwitchLog, what_is_written_is_read_back) {
    const SwitchConfig config = three_lines();
    std::mt19937_64 random(3);
    std::uniform_int_distribution<std::int64_t> ns(0, 9'000'000'000'000'000'000);
    char text[kMaxSwitchLogLine];
    for (int i = 0; i < 10'000; ++i) {
        SwitchEdge written{{ns(random)}, static_cast<std::uint8_t>(random() % 3), random() % 2 == 0};
        if (i % 2 == 0) written.time.ns -= written.time.ns % 1000;
        const std::size_t length = format_switch_log_line(written, config, text);
        ASSERT_GT(length, 0u);
        ASSERT_EQ(text[length - 1], '\n');
        const SwitchLogLine read = parse_switch_log_line({text, length - 1}, config);
        ASSERT_EQ(read.kind, SwitchLineKind::edge) << text;
        ASSERT_EQ(read.edge.time, written.time);
        ASSERT_EQ(read.edge.line, written.line);
        ASSERT_EQ(read.edge.level, written.level);
    }
}

TEST(SwitchLog, digits_are_as_many_as_needed) {
    char text[kMaxSwitchLogLine];
    const auto written = [&](std::int64_t ns) {
        return std::string(text, format_switch_log_line({{ns}, 2, true}, three_lines(), text));
    };
    EXPECT_EQ(written(1'700'000'061'250'000'000), "(1700000061.250000) p.C 1\n");
    EXPECT_EQ(written(1'700'000'061'250'000'001), "(1700000061.250000001) p.C 1\n");
    EXPECT_EQ(written(7), "(0000000000.000000007) p.C 1\n");
}

TEST(SwitchLog, what_cannot_be_written_is_refused) {
    char text[kMaxSwitchLogLine];
    EXPECT_EQ(format_switch_log_line({{-1}, 0, true}, three_lines(), text), 0u);
    EXPECT_EQ(format_switch_log_line({{1}, 3, true}, three_lines(), text), 0u);
    EXPECT_EQ(format_switch_log_line({{1}, 0, true}, three_lines(), base::Span<char>(text, kMaxSwitchLogLine - 1)), 0u);
}

TEST(SwitchLog, the_longest_line_fits) {
    const std::string name(63, 'n');
    const SwitchConfig config =
        config_from("[[line]]\nchip='" + name + "'\nname='" + name + "'\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    char text[kMaxSwitchLogLine];
    const std::size_t length = format_switch_log_line({{8'999'999'999'999'999'999}, 0, true}, config, text);
    EXPECT_GT(length, 2 * name.size());
    EXPECT_EQ(parse_switch_log_line({text, length}, config).kind, SwitchLineKind::malformed)
        << "the newline is not part of the line";
    EXPECT_EQ(parse_switch_log_line({text, length - 1}, config).kind, SwitchLineKind::edge);
}

TEST(SwitchLog, the_header_is_asked_for_exactly) {
    EXPECT_TRUE(has_switch_log_header(kSwitchLogHeader));
    EXPECT_TRUE(has_switch_log_header("# tedavis switch log 1\r\n(1.000000) p.A 1\n"));
    EXPECT_TRUE(has_switch_log_header("# tedavis switch log 1"));
    EXPECT_FALSE(has_switch_log_header(""));
    EXPECT_FALSE(has_switch_log_header("# tedavis switch log 2\n"));
    EXPECT_FALSE(has_switch_log_header("# tedavis switch log 10\n"));
    EXPECT_FALSE(has_switch_log_header("\x89PNG\r\n"));
    EXPECT_FALSE(has_switch_log_header("(1700000000.000000) p.A 1\n"));
}

TEST(SwitchLog, every_fault_has_its_own_words) {
    std::set<std::string> words;
    for (int i = 0; i <= static_cast<int>(SwitchLineFault::time_runs_back); ++i)
        EXPECT_TRUE(words.insert(describe(static_cast<SwitchLineFault>(i))).second);
}

}  // namespace
}  // namespace tedavis::bus::test_switch_log
