#include "bus/switches/switch_to_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_switch_to_phase {
namespace {

using flight::Scenario;

std::string shown(const SwitchPhase& status) {
    const std::string phase = status.statement.stated ? flight::scenario_name(status.statement.phase) : "-";
    return phase + (status.fault ? "!" : "");
}

class Panel {
public:
    explicit Panel(const SwitchConfig& config = three_lines()) : phase_(config) {}
    /// One edge a line at 0 ms.
    Panel& start(std::uint32_t high) {
        for (std::size_t i = 0; i < phase_.config().lines.size(); ++i)
            phase_.add(edge(0, static_cast<int>(i), (high >> i & 1) != 0));
        return *this;
    }
    Panel& set(std::int64_t ms, int line, bool level) {
        phase_.add(edge(ms, line, level));
        return *this;
    }
    std::string at(std::int64_t ms) const { return shown(phase_.status(at_ms(ms))); }
    SwitchToPhase& phase() { return phase_; }

private:
    SwitchToPhase phase_;
};

TEST(SwitchToPhase, truth_table_of_every_pattern_at_start) {
    const char* expected[8] = {"-!", "ground", "cruise", "-!", "approach", "-!", "-!", "-!"};
    for (std::uint32_t high = 0; high < 8; ++high) EXPECT_EQ(Panel().start(high).at(250), expected[high]) << high;
}

TEST(SwitchToPhase, every_pattern_of_the_shipped_files_states_its_phase_and_every_other_is_a_fault) {
    for (const char* name : {"one_hot.toml", "coded_parity.toml"}) {
        const SwitchConfig config = config_from(shipped_text(name));
        for (std::uint32_t high = 0; high <= config.all_lines(); ++high) {
            Panel panel(config);
            const SwitchPhase status = panel.start(high).phase().status(at_ms(1000));
            const SwitchPattern* pattern = config.find_pattern(high);
            EXPECT_EQ(status.fault, pattern == nullptr) << name << " " << high;
            EXPECT_EQ(status.statement.stated, pattern != nullptr && pattern->phase.scenario != Scenario::unknown);
            if (status.statement.stated) {
                EXPECT_EQ(status.statement.phase, pattern->phase);
            }
        }
    }
}

TEST(SwitchToPhase, the_line_of_the_legend_changes_no_phase) {
    Panel panel(three_lines_and_legend());
    panel.set(0, 0, false).set(0, 1, true).set(0, 2, false);
    EXPECT_EQ(panel.at(1000), "cruise") << "before the line has reported";
    panel.set(2000, 3, true);
    EXPECT_EQ(panel.at(3000), "cruise");
    EXPECT_EQ(panel.phase().status(at_ms(3000)).levels.high, 0b1010u);
    panel.set(4000, 3, false);
    EXPECT_EQ(panel.at(5000), "cruise");
}

TEST(SwitchToPhase, states_nothing_before_any_edge) { EXPECT_EQ(Panel().at(10'000), "-"); }

TEST(SwitchToPhase, a_line_that_never_reports_is_a_fault_after_the_settle_time) {
    Panel panel;
    panel.set(0, 0, true).set(0, 1, false);
    EXPECT_EQ(panel.at(199), "-");
    EXPECT_EQ(panel.at(200), "-!");
    panel.set(300, 2, false);
    EXPECT_EQ(panel.at(300), "ground");
}

TEST(SwitchToPhase, turning_the_knob_through_nothing_raises_no_flag) {
    Panel panel;
    panel.start(0b001).set(1000, 0, false).set(1150, 1, true);
    EXPECT_EQ(panel.at(1100), "ground");
    EXPECT_EQ(panel.at(1179), "ground");
    EXPECT_EQ(panel.at(1180), "cruise");
}

TEST(SwitchToPhase, an_impossible_pattern_keeps_the_last_phase_and_raises_the_fault_until_a_valid_one) {
    Panel panel;
    panel.start(0b001).set(1000, 1, true);
    EXPECT_EQ(panel.at(1229), "ground");
    EXPECT_EQ(panel.at(1230), "ground!") << "30 ms debounce and 200 ms settle time";
    EXPECT_EQ(panel.at(100'000), "ground!");
    panel.set(100'000, 0, false);
    EXPECT_EQ(panel.at(100'029), "ground!");
    EXPECT_EQ(panel.at(100'030), "cruise");
}

TEST(SwitchToPhase, one_impossible_pattern_after_another_does_not_restart_the_settle_time) {
    Panel panel;
    panel.start(0b001).set(1000, 1, true).set(1100, 2, true).set(1180, 0, false);
    EXPECT_EQ(panel.at(1230), "ground!");
}

/// The phases that a panel shows, millisecond by millisecond, when its lines go from one pattern to another in the given order,
/// `apart_ms` between two of them.
std::vector<std::string> shown_between(const SwitchConfig& config, std::uint32_t from, std::uint32_t to,
                                       const std::vector<int>& order, int apart_ms) {
    Panel panel(config);
    panel.start(from);
    std::vector<std::string> phases{panel.at(999)};
    int at_ms = 1000;
    for (const int line : order) {
        if (((from ^ to) >> line & 1u) == 0) continue;
        for (int before = at_ms - apart_ms; before < at_ms; ++before) phases.push_back(panel.at(std::max(before, 999)));
        panel.set(at_ms, line, (to >> line & 1u) != 0);
        at_ms += apart_ms;
    }
    for (int ms = at_ms - apart_ms; ms < at_ms + 300; ++ms) phases.push_back(panel.at(ms));
    phases.erase(std::unique(phases.begin(), phases.end()), phases.end());
    return phases;
}

TEST(SwitchToPhase, a_panel_whose_supply_fails_shows_no_other_phase_in_whatever_order_its_lines_fall) {
    const SwitchConfig config = config_from(shipped_text("coded_parity.toml"));
    for (const SwitchPattern& pattern : config.patterns) {
        std::vector<int> order{0, 1, 2, 3, 4};
        do {
            const std::vector<std::string> phases = shown_between(config, pattern.high, 0, order, 2);
            ASSERT_EQ(phases.size(), 2u) << pattern.high;
            EXPECT_EQ(phases[1], phases[0] + "!");
        } while (std::next_permutation(order.begin(), order.end()));
    }
}

TEST(SwitchToPhase, between_two_positions_whose_lines_change_apart_there_is_no_third_one) {
    const SwitchConfig config = config_from(shipped_text("coded_parity.toml"));
    const std::vector<int> up{0, 1, 2, 3, 4}, down{4, 3, 2, 1, 0};
    for (const SwitchPattern& from : config.patterns)
        for (const SwitchPattern& to : config.patterns)
            for (const auto& order : {up, down})
                EXPECT_LE(shown_between(config, from.high, to.high, order, 9).size(), 2u) << from.high << " to " << to.high;
}

TEST(SwitchToPhase, lines_that_change_farther_apart_than_the_debounce_time_show_what_lies_between) {
    const SwitchConfig config = config_from(shipped_text("coded_parity.toml"));
    const std::vector<std::string> phases = shown_between(config, 0b11001, 0, {0, 3, 4, 1, 2}, 40);
    EXPECT_EQ(phases, (std::vector<std::string>{"approach", "ground", "ground!"})) << "so the test above can fail";
}

TEST(SwitchToPhase, a_line_that_bounces_and_comes_back_keeps_no_position_away) {
    Panel panel(config_from(shipped_text("coded_parity.toml")));
    panel.start(0b11001);
    for (int ms = 1000; ms < 2000; ms += 10) {
        if (ms == 1500) {
            EXPECT_EQ(panel.at(1499), "approach");
            panel.set(ms, 0, false).set(ms, 3, false);
        }
        panel.set(ms, 1, ms / 10 % 2 == 0);
    }
    EXPECT_EQ(panel.at(1999), "ground");
}

TEST(SwitchToPhase, edges_of_one_instant_are_one_pattern) {
    const SwitchConfig config = config_from(
        "debounce_ms = 0\nsettle_ms = 0\n[[line]]\nchip='p'\nname='A'\n[[line]]\nchip='p'\nname='B'\n"
        "[[pattern]]\nphase='ground'\nhigh=['A']\n[[pattern]]\nphase='cruise'\nhigh=['B']\n"
        "[[pattern]]\nphase='approach'\nhigh=[]\n");
    Panel panel(config);
    panel.start(0b01).set(1000, 0, false).set(1000, 1, true);
    EXPECT_EQ(panel.at(1000), "cruise") << "not approach, which lies between";
    EXPECT_EQ(panel.set(2000, 0, true).at(2000), "cruise!");
}

TEST(SwitchToPhase, a_pattern_of_unknown_leaves_the_phase_to_others_without_fault) {
    const SwitchConfig config = config_from(shipped_text("one_hot.toml"));
    Panel panel(config);
    panel.start(1u << 6);
    EXPECT_EQ(panel.at(1000), "-");
    panel.set(2000, 6, false).set(2000, 2, true);
    EXPECT_EQ(panel.at(2030), "cruise");
}

TEST(SwitchToPhase, edges_of_lines_that_the_config_does_not_have_are_ignored) {
    Panel panel;
    panel.start(0b001).set(500, 3, true).set(600, 200, true);
    EXPECT_EQ(panel.at(1000), "ground");
}

/// A bouncing, turning, sometimes broken panel.
std::vector<SwitchEdge> random_edges(std::mt19937_64& random) {
    std::uniform_int_distribution<int> line(0, 2), pause(0, 120), bounce(0, 9);
    std::vector<SwitchEdge> edges;
    for (int i = 0; i < 3; ++i) edges.push_back(edge(0, i, i == 0));
    for (int i = 0, ms = 0; i < 60; ++i) {
        ms += bounce(random) < 6 ? pause(random) / 20 : pause(random) * 3;
        edges.push_back(edge(ms, line(random), bounce(random) < 5));
    }
    return edges;
}

TEST(SwitchToPhase, the_status_does_not_depend_on_how_often_anybody_asks) {
    std::mt19937_64 random(2024);
    for (int run = 0; run < 200; ++run) {
        const std::vector<SwitchEdge> edges = random_edges(random);
        SwitchToPhase every_millisecond(three_lines());
        std::vector<std::string> reference;
        std::size_t added = 0;
        const std::int64_t end_ms = (edges.back().time - at_ms(0)).ns / 1'000'000 + 500;
        for (std::int64_t ms = 0; ms <= end_ms; ++ms) {
            while (added < edges.size() && edges[added].time <= at_ms(ms)) every_millisecond.add(edges[added++]);
            reference.push_back(shown(every_millisecond.status(at_ms(ms))));
        }
        for (const std::int64_t step : {7, 33, 100, 1000}) {
            SwitchToPhase seldom(three_lines());
            added = 0;
            for (std::int64_t ms = 0; ms <= end_ms; ms += step) {
                while (added < edges.size() && edges[added].time <= at_ms(ms)) seldom.add(edges[added++]);
                ASSERT_EQ(shown(seldom.status(at_ms(ms))), reference[static_cast<std::size_t>(ms)])
                    << "run " << run << " step " << step << " at " << ms;
            }
        }
    }
}

TEST(SwitchToPhase, a_saved_state_goes_on_as_if_nothing_had_happened) {
    std::mt19937_64 random(5);
    const std::vector<SwitchEdge> edges = random_edges(random);
    SwitchToPhase whole(three_lines()), resumed(three_lines());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i == edges.size() / 2) resumed.restore(whole.state());
        whole.add(edges[i]);
        if (i >= edges.size() / 2) resumed.add(edges[i]);
    }
    for (int ms = 0; ms < 1000; ms += 10) {
        const base::Time now = edges.back().time + base::Duration::milliseconds(ms);
        ASSERT_EQ(shown(whole.status(now)), shown(resumed.status(now)));
    }
}

}  // namespace
}  // namespace tedavis::bus::test_switch_to_phase
