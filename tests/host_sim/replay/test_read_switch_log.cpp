#include "host_sim/replay/read_switch_log.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_read_switch_log {
namespace {

TEST(ReadSwitchLog, GivesTheWholeText) {
    const test_support::TemporaryFolder folder;
    const std::string text = "# tedavis switch log 1\n(1.000000) p.A 1\n";
    EXPECT_EQ(read_switch_log(folder.write("s", text)), text);
}

TEST(ReadSwitchLog, RefusesWhatIsNone) {
    const test_support::TemporaryFolder folder;
    const auto refuses = [&](const std::string& text) {
        test_support::expect_user_error([&] { (void)read_switch_log(folder.write("x.switches", text)); },
                                        "x.switches:1: not a switch log; give one whose first line is '# tedavis switch log 1'");
    };
    refuses("");
    refuses("(1.000000) can0 12C#0000\n");
    refuses("# tedavis switch log 12\n");
    test_support::expect_user_error([&] { (void)read_switch_log(folder.file("none")); }, "none: no such file; check the path");
}

constexpr char kPanel[] =
    "title = 'x'\ncode = 'free'\n[[line]]\nchip = 'p'\nname = 'A'\n[[line]]\nchip = 'p'\nname = 'B'\n"
    "[[pattern]]\nphase = 'cruise'\nhigh = ['A']\n";

bus::SwitchConfig panel() {
    const auto config = bus::load_switch_config(kPanel, "x.toml");
    EXPECT_TRUE(config.ok());
    return config.value();
}

Findings found(const std::string& lines, const bus::SwitchConfig& with = panel()) {
    const std::string text = "# tedavis switch log 1\n" + lines;
    return switch_findings("x.switches", text, "small", with, read_panel(text, with));
}

const std::string kSound = "(1.000000) p.A 1\n(1.000000) p.B 0\n(2.000000) p.A 0\n";

TEST(ReadSwitchLog, ASoundLogHasEdgesAndNoFindings) {
    EXPECT_TRUE(found(kSound).empty());
    const PanelReading reading = read_panel(kSound, panel());
    ASSERT_EQ(reading.edges.size(), 3u);
    EXPECT_EQ(reading.edges[1].line, 1);
    EXPECT_EQ(reading.statistics.edges, 3u);
}

TEST(ReadSwitchLog, ATypoIsNamedWithItsLine) {
    const Findings findings = found(kSound + "# a comment\n(3.000000) p.C 1\n");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "switches.unknown_line");
    EXPECT_EQ(findings[0].text,
              "x.switches: names that the panel small does not have in 1 of 4 lines (the first: line 6 '(3.000000) p.C 1')");
}

TEST(ReadSwitchLog, ALogOfAnotherPanelIsCalledSo) {
    const Findings findings = found("(1.000000) q.GROUND 1\n(2.000000) q.GROUND 0\n");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].name, "switches.other_panel");
    EXPECT_EQ(findings[0].count, 2u);
    EXPECT_NE(findings[0].text.find("none of 2 lines is of the panel small (the first: line 2 '(1.000000) q.GROUND 1')"),
              std::string::npos)
        << findings[0].text;
    ASSERT_EQ(found("# nothing\n").size(), 1u);
    EXPECT_EQ(found("# nothing\n")[0].name, "switches.empty");
}

TEST(ReadSwitchLog, BrokenLinesAndLinesWithoutALevelAreCounted) {
    const Findings findings = found("(1.000000) p.A 1\nwords\n(0.500000) p.A 0\n");
    ASSERT_EQ(findings.size(), 2u);
    EXPECT_EQ(findings[0].name, "switches.broken_lines");
    EXPECT_EQ(findings[0].count, 2u) << "words, and a time that runs back";
    EXPECT_EQ(findings[1].name, "switches.never_stated");
    EXPECT_EQ(findings[1].text,
              "x.switches: no level for 1 of 2 phase lines of the panel small (p.B), so that it states no phase");
}

/// A log from before the panel had a line for the legend states every phase.
TEST(ReadSwitchLog, TheLegendsLineNeedsNoLevel) {
    const std::string legend = "[legend]\nchip = 'p'\nname = 'LEGEND'\n";
    const auto loaded = bus::load_switch_config(kPanel + legend, "x.toml");
    ASSERT_TRUE(loaded.ok());
    EXPECT_TRUE(found(kSound, loaded.value()).empty());
    EXPECT_TRUE(found(kSound + "(3.000000) p.LEGEND 1\n", loaded.value()).empty());
    const Findings lacking = found("(1.000000) p.A 1\n(3.000000) p.LEGEND 1\n", loaded.value());
    ASSERT_EQ(lacking.size(), 1u) << "the control: a line of the phase needs its level";
    EXPECT_EQ(lacking[0].text,
              "x.switches: no level for 1 of 2 phase lines of the panel small (p.B), so that it states no phase");
}

TEST(ReadSwitchLog, EdgesOfAnotherTimeAreSaid) {
    const auto at = [](std::int64_t seconds) { return base::Time{seconds * 1'000'000'000}; };
    const std::vector<bus::SwitchEdge> edges{{at(1'000'000), 0, true}, {at(1'000'100), 0, false}};
    const auto text = [&](std::int64_t first, std::int64_t last) {
        const Findings findings = switch_time_findings("x.switches", edges, at(first), at(last));
        return findings.empty() ? std::string() : findings[0].name + ": " + findings[0].text;
    };
    EXPECT_EQ(text(1'000'050, 1'000'090), "");
    EXPECT_EQ(text(1'000'100 + 86'400, 2'000'000), "") << "a panel that was set the day before";
    EXPECT_EQ(text(999'000, 999'980),
              "switches.another_time: x.switches: all 2 edges lie 20 s after the log's end; give the switch log of this flight");
    EXPECT_NE(text(1'000'101 + 86'400, 2'000'000).find("86401 s and more before the log's begin"), std::string::npos);
    EXPECT_TRUE(switch_time_findings("x.switches", {}, at(0), at(1)).empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_read_switch_log
