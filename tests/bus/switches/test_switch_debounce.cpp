#include "bus/switches/switch_debounce.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_switch_debounce {
namespace {

constexpr base::Duration kStable = base::Duration::milliseconds(30);

/// The rule by brute force: the newest raw level that lasted for the stable time, else the first.
bool level_by_rule(const std::vector<SwitchEdge>& edges, base::Time now) {
    bool stable = edges.front().level;
    for (std::size_t i = 0; i < edges.size() && edges[i].time <= now; ++i) {
        std::size_t next = i + 1;
        while (next < edges.size() && edges[next].level == edges[i].level) ++next;
        const base::Time until = next < edges.size() && edges[next].time <= now ? edges[next].time : now;
        const bool changes = i == 0 || edges[i].level != edges[i - 1].level;
        if (changes && until - edges[i].time >= kStable) stable = edges[i].level;
    }
    return stable;
}

TEST(SwitchDebounce, nothing_is_known_before_the_first_level) {
    EXPECT_EQ(SwitchDebounce(kStable).levels(at_ms(0)), (SwitchLevels{0, 0}));
    EXPECT_FALSE(SwitchDebounce(kStable).next_change(at_ms(0)).waiting);
}

TEST(SwitchDebounce, the_first_level_counts_at_once) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, 2, true));
    EXPECT_EQ(debounce.levels(at_ms(0)), (SwitchLevels{0b100, 0b100}));
}

TEST(SwitchDebounce, a_new_level_counts_after_the_stable_time_exactly) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, 0, false));
    debounce.add(edge(100, 0, true));
    EXPECT_EQ(debounce.levels({at_ms(130).ns - 1}).high, 0u);
    EXPECT_EQ(debounce.levels(at_ms(130)).high, 1u);
    EXPECT_TRUE(debounce.next_change(at_ms(100)).waiting);
    EXPECT_EQ(debounce.next_change(at_ms(100)).at, at_ms(130));
    EXPECT_FALSE(debounce.next_change(at_ms(130)).waiting);
}

TEST(SwitchDebounce, bounces_shorter_than_the_stable_time_never_count) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, 0, false));
    for (int i = 0; i < 50; ++i) debounce.add(edge(100 + 7 * i, 0, i % 2 == 0));
    for (int ms = 443; ms < 600; ++ms) EXPECT_EQ(debounce.levels(at_ms(ms)).high, 0u) << ms;
    debounce.add(edge(600, 0, true));
    EXPECT_EQ(debounce.levels(at_ms(629)).high, 0u);
    EXPECT_EQ(debounce.levels(at_ms(630)).high, 1u);
}

TEST(SwitchDebounce, lines_are_settled_when_none_of_them_is_about_to_change) {
    SwitchDebounce debounce(kStable);
    EXPECT_TRUE(debounce.are_settled(0b11, at_ms(0))) << "nothing is known of them";
    debounce.add(edge(0, 0, false));
    debounce.add(edge(0, 1, false));
    EXPECT_TRUE(debounce.are_settled(0b11, at_ms(0))) << "first levels";
    debounce.add(edge(100, 1, true));
    EXPECT_TRUE(debounce.are_settled(0b01, at_ms(110)));
    EXPECT_FALSE(debounce.are_settled(0b11, at_ms(129)));
    EXPECT_TRUE(debounce.are_settled(0b11, at_ms(130)));
    debounce.add(edge(200, 1, false));
    EXPECT_FALSE(debounce.are_settled(0b10, at_ms(200)));
    debounce.add(edge(210, 1, true));
    EXPECT_TRUE(debounce.are_settled(0b10, at_ms(210))) << "it came back";
}

TEST(SwitchDebounce, restating_a_level_does_not_start_its_time_again) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, 0, false));
    debounce.add(edge(100, 0, true));
    debounce.add(edge(120, 0, true));
    EXPECT_EQ(debounce.levels(at_ms(130)).high, 1u);
}

TEST(SwitchDebounce, a_level_that_lasted_long_enough_counts_even_if_nobody_asked_in_between) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, 0, false));
    debounce.add(edge(100, 0, true));
    debounce.add(edge(150, 0, false));
    EXPECT_EQ(debounce.levels(at_ms(160)).high, 1u);
    EXPECT_EQ(debounce.levels(at_ms(180)).high, 0u);
}

TEST(SwitchDebounce, an_edge_from_the_past_counts_as_simultaneous) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, 0, false));
    debounce.add(edge(100, 0, true));
    debounce.add(edge(90, 0, false));
    EXPECT_EQ(debounce.levels(at_ms(500)).high, 0u);
}

TEST(SwitchDebounce, lines_beyond_the_last_are_ignored) {
    SwitchDebounce debounce(kStable);
    debounce.add(edge(0, kMaxSwitchLines, true));
    debounce.add(edge(0, 255, true));
    EXPECT_EQ(debounce.levels(at_ms(1)).known, 0u);
}

TEST(SwitchDebounce, random_bounces_follow_the_rule_at_every_instant) {
    std::mt19937_64 random(99);
    std::uniform_int_distribution<int> pause(0, 60), coin(0, 3);
    for (int run = 0; run < 200; ++run) {
        std::vector<SwitchEdge> edges{edge(0, 0, coin(random) == 0)};
        for (int i = 0, ms = 0; i < 40; ++i) {
            ms += pause(random);
            edges.push_back(edge(ms, 0, coin(random) == 0 ? edges.back().level : !edges.back().level));
        }
        SwitchDebounce debounce(kStable);
        std::size_t added = 0;
        for (int ms = 0; ms < 2600; ++ms) {
            while (added < edges.size() && edges[added].time <= at_ms(ms)) debounce.add(edges[added++]);
            ASSERT_EQ(debounce.levels(at_ms(ms)).high == 1u, level_by_rule(edges, at_ms(ms))) << "run " << run << " at " << ms;
        }
    }
}

}  // namespace
}  // namespace tedavis::bus::test_switch_debounce
