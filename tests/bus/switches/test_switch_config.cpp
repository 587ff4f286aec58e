#include "bus/switches/switch_config.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_switch_config {
namespace {

std::string message_of(const std::string& text) {
    const auto loaded = load_switch_config(text, "t.toml");
    return loaded.ok() ? std::string() : std::string(loaded.error().message.view());
}

const std::string kLine = "[[line]]\nchip='p'\nname='A'\n";
const std::string kPattern = "[[pattern]]\nphase='ground'\nhigh=['A']\n";

TEST(SwitchConfig, reads_lines_patterns_and_times) {
    const SwitchConfig config = config_from(
        "title='Panel'\ndebounce_ms=20\nsettle_ms=300\n[[line]]\nchip='fe200000.gpio'\nname='X'\nactive_low=true\npull='up'\n" +
        kLine + "[[pattern]]\nphase='takeoff.first_climb'\nhigh=['A', 'X']\n[[pattern]]\nphase='ground'\nhigh=[]\n");
    EXPECT_EQ(config.title.view(), "Panel");
    EXPECT_EQ(config.debounce, base::Duration::milliseconds(20));
    EXPECT_EQ(config.settle, base::Duration::milliseconds(300));
    ASSERT_EQ(config.lines.size(), 2u);
    EXPECT_TRUE(config.lines[0].active_low);
    EXPECT_EQ(config.lines[0].pull, LinePull::up);
    EXPECT_FALSE(config.lines[1].active_low);
    EXPECT_EQ(config.lines[1].pull, LinePull::none);
    EXPECT_EQ(config.all_lines(), 0b11u);
    ASSERT_NE(config.find_pattern(0b11), nullptr);
    EXPECT_EQ(config.find_pattern(0b11)->phase, flight::kTakeoffFirstClimb);
    EXPECT_EQ(config.find_pattern(0b00)->phase.scenario, flight::Scenario::ground);
    EXPECT_EQ(config.find_pattern(0b01), nullptr);
    EXPECT_EQ(config.find_line("fe200000.gpio.X"), 0u) << "labels may contain dots";
    EXPECT_EQ(config.find_line("p.A"), 1u);
    EXPECT_EQ(config.find_line("p.X"), 2u);
    EXPECT_EQ(config.find_line("A"), 2u);
}

TEST(SwitchConfig, the_line_of_the_legend_is_no_part_of_the_patterns) {
    const SwitchConfig config = three_lines_and_legend();
    ASSERT_EQ(config.lines.size(), 4u);
    EXPECT_EQ(config.find_line("p.LEGEND"), 3u) << "the last one";
    EXPECT_EQ(config.all_lines(), 0b1111u);
    EXPECT_EQ(config.phase_lines(), 0b0111u);
    EXPECT_TRUE(config.asks_for_legend({0b1111, 0b1001}));
    EXPECT_FALSE(config.asks_for_legend({0b1111, 0b0001}));
    EXPECT_FALSE(config.asks_for_legend({0b0111, 0b1001})) << "its level is not known";
    EXPECT_FALSE(three_lines().asks_for_legend({0b1111, 0b1111})) << "there is no such line";
    EXPECT_EQ(three_lines().phase_lines(), 0b0111u);
    EXPECT_EQ(message_of(kLine + "[legend]\nchip='p'\nname='L'\n[[pattern]]\nphase='ground'\nhigh=['L']\n"),
              "t.toml:9: 'L' is none of the lines; correct it");
    EXPECT_EQ(message_of(kLine + "[legend]\nchip='p'\nname='A'\n" + kPattern),
              "t.toml:6: line 'p.A' is listed twice; remove one");
    EXPECT_EQ(message_of("[legend]\nchip='p'\nname='L'\n"), "t.toml: no line is listed; add at least one [[line]]");
}

TEST(SwitchConfig, defaults_are_30_and_200_ms) {
    const SwitchConfig config = config_from(kLine + kPattern);
    EXPECT_EQ(config.debounce, base::Duration::milliseconds(30));
    EXPECT_EQ(config.settle, base::Duration::milliseconds(200));
}

TEST(SwitchConfig, a_line_may_be_known_by_its_offset) {
    const std::string by_offset = "[[line]]\nchip='p'\nname='A'\noffset=4\n";
    const SwitchConfig config = config_from(by_offset + "[[line]]\nchip='p'\nname='B'\n" + kPattern);
    EXPECT_EQ(config.lines[0].offset, 4);
    EXPECT_LT(config.lines[1].offset, 0) << "by its name";
    EXPECT_EQ(config.find_line("p.A"), 0u) << "a switch log names it all the same";
    EXPECT_EQ(message_of(by_offset + "[[line]]\nchip='p'\nname='B'\noffset=4\n" + kPattern),
              "t.toml:8: another line of this chip has this offset; correct one");
    EXPECT_EQ(message_of("[[line]]\nchip='p'\nname='A'\noffset=-1\n" + kPattern).find("t.toml:4: 'offset'"), 0u);
}

TEST(SwitchConfig, faults_are_one_sentence_with_the_line) {
    EXPECT_EQ(message_of(kLine + "[[pattern]]\nphase='climbing'\nhigh=['A']\n"),
              "t.toml:5: 'climbing' is no flight phase; write for instance \"takeoff.first_climb\"");
    EXPECT_EQ(message_of(kLine + "[[pattern]]\nphase='ground'\nhigh=['B']\n"), "t.toml:6: 'B' is none of the lines; correct it");
    EXPECT_EQ(message_of(kLine + "[[pattern]]\nphase='ground'\nhigh=['A', 'A']\n"), "t.toml:6: 'A' is listed twice; remove one");
    EXPECT_EQ(message_of(kLine + "[[pattern]]\nphase='ground'\n"),
              "t.toml:5: this pattern has no 'high'; list the active lines, [] for none");
    EXPECT_EQ(message_of(kLine + kPattern + kPattern), "t.toml:9: another pattern has the same lines high; make them differ");
    EXPECT_EQ(message_of(kLine + kLine + kPattern), "t.toml:6: line 'p.A' is listed twice; remove one");
    EXPECT_EQ(message_of(kPattern), "t.toml:3: 'A' is none of the lines; correct it");
    EXPECT_EQ(message_of(kLine), "t.toml: no pattern is listed; add at least one [[pattern]]");
    EXPECT_EQ(message_of(""), "t.toml: no line is listed; add at least one [[line]]");
    EXPECT_EQ(message_of("debounce_ms=5000\n" + kLine + kPattern),
              "t.toml:1: 'debounce_ms' must be a whole number from 0 to 1000");
    EXPECT_EQ(message_of("debounce_ms=nan\n" + kLine + kPattern),
              "t.toml:1: 'debounce_ms' must be a whole number from 0 to 1000");
    EXPECT_EQ(message_of("[[line]]\nchip='p'\nname='A B'\n" + kPattern),
              "t.toml:3: 'name' must be 1 to 63 characters without blanks or '#'");
    EXPECT_EQ(message_of(kLine + "pul='up'\n" + kPattern), "t.toml:4: unknown key 'line.pul'; correct or remove it");
    EXPECT_EQ(message_of(kLine + "pull='sideways'\n" + kPattern), "t.toml:4: 'pull' must be one of: none, off, up, down");
}

TEST(SwitchConfig, a_name_on_two_chips_must_be_written_with_its_chip) {
    const std::string two = kLine + "[[line]]\nchip='q'\nname='A'\n";
    EXPECT_EQ(message_of(two + "[[pattern]]\nphase='ground'\nhigh=['A']\n"),
              "t.toml:9: 'A' names several lines; write \"chip.name\"");
    EXPECT_EQ(config_from(two + "[[pattern]]\nphase='ground'\nhigh=['q.A']\n").patterns[0].high, 0b10u);
}

TEST(SwitchConfig, the_code_is_checked_for_every_pattern) {
    const std::string lines = "[[line]]\nchip='p'\nname='A'\n[[line]]\nchip='p'\nname='B'\n";
    const auto with = [&](const char* code, const char* high) {
        return message_of(std::string("code='") + code + "'\n" + lines + "[[pattern]]\nphase='ground'\nhigh=" + high + "\n");
    };
    for (const char* high : {"[]", "['A']", "['A','B']"}) {
        const int ones = high[1] == ']' ? 0 : high[4] == ']' ? 1 : 2;
        EXPECT_EQ(with("one_hot", high).empty(), ones == 1);
        EXPECT_EQ(with("odd_parity", high).empty(), ones % 2 == 1);
        EXPECT_EQ(with("even_parity", high).empty(), ones % 2 == 0);
        EXPECT_EQ(with("free", high), "");
    }
    EXPECT_EQ(with("one_hot", "[]"), "t.toml:10: this pattern breaks the code 'one_hot'; correct it");
}

TEST(SwitchConfig, more_lines_or_patterns_than_fit_are_refused) {
    std::string lines, patterns;
    for (int i = 0; i < 17; ++i) lines += "[[line]]\nchip='p'\nname='L" + std::to_string(i) + "'\n";
    EXPECT_NE(message_of(lines + "[[pattern]]\nphase='ground'\nhigh=['L0']\n").find("more than 16 lines"), std::string::npos);
    const std::string six = lines.substr(0, lines.find("[[line]]\nchip='p'\nname='L6'"));
    for (int i = 0; i < 33; ++i) {
        patterns += "[[pattern]]\nphase='ground'\nhigh=[";
        for (int bit = 0; bit < 6; ++bit)
            if ((i >> bit & 1) != 0) patterns += "'L" + std::to_string(bit) + "',";
        patterns += "]\n";
    }
    EXPECT_NE(message_of(six + patterns).find("more than 32 patterns"), std::string::npos);
}

TEST(SwitchConfig, shipped_files_load_and_reach_the_scenarios) {
    for (const char* name : {"one_hot.toml", "coded_parity.toml"}) {
        const SwitchConfig config = config_from(shipped_text(name));
        std::set<flight::Scenario> scenarios;
        for (const SwitchPattern& pattern : config.patterns) scenarios.insert(pattern.phase.scenario);
        EXPECT_EQ(scenarios.size(), 6u) << name;
    }
}

TEST(SwitchConfig, one_wrong_line_never_turns_a_shipped_pattern_into_another) {
    for (const char* name : {"one_hot.toml", "coded_parity.toml"}) {
        const SwitchConfig config = config_from(shipped_text(name));
        EXPECT_EQ(config.find_pattern(0), nullptr) << name << ": a dead panel states nothing";
        for (const SwitchPattern& pattern : config.patterns)
            for (std::size_t line = 0; line < config.lines.size(); ++line)
                EXPECT_EQ(config.find_pattern(pattern.high ^ (1u << line)), nullptr) << name;
    }
}

}  // namespace
}  // namespace tedavis::bus::test_switch_config
