#include "bus/switches/gpiod_source.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bus/switches/switch_log_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "tests/bus/switches/switch_fixtures.hpp"

namespace tedavis::bus::test_gpiod_source {
namespace {

/// What a GPIO chip does: levels change, the kernel keeps at most 16 edges a line and drops the newest (as the old
/// interface does). Its clock is the monotonic one: source time less kOffset.
constexpr base::Duration kOffset = base::Duration::seconds(1'000'000'000);

struct Hardware {
    struct Line {
        bool level = false;
        std::deque<SwitchEdge> edges;
    };
    std::vector<Line> lines = std::vector<Line>(3);
    bool refuses_request = false;
    bool answers = true;
    bool says_lost = false;
    int requests = 0;
    int releases = 0;
    /// Called between the reading of edges and of levels, as the world goes on meanwhile.
    std::function<void(std::size_t line)> before_level = [](std::size_t) {};

    void set(std::int64_t ms, std::size_t line, bool level) {
        lines[line].level = level;
        if (lines[line].edges.size() < 16)
            lines[line].edges.push_back({at_ms(ms) - kOffset, static_cast<std::uint8_t>(line), level});
    }
    /// Back and forth so often that the queue is full before the last one.
    void overrun(std::int64_t ms, std::size_t line) {
        for (int i = 0; i < 17; ++i) set(ms + i, line, !lines[line].level);
    }
};

class FakeLines final : public GpioLines {
public:
    explicit FakeLines(Hardware& hardware) : hardware_(hardware) {}
    bool request(const SwitchConfig&, base::Error& error) override {
        ++hardware_.requests;
        if (hardware_.refuses_request) error.message = "refused";
        return !hardware_.refuses_request;
    }
    void release() override { ++hardware_.releases; }
    bool read_level(std::size_t line, bool& level) override {
        hardware_.before_level(line);
        level = hardware_.lines[line].level;
        return hardware_.answers;
    }
    Burst read_edges(std::size_t line, base::Span<SwitchEdge> out) override {
        Burst burst{0, hardware_.says_lost && !hardware_.lines[line].edges.empty(), !hardware_.answers};
        auto& edges = hardware_.lines[line].edges;
        for (; burst.count < out.size() && !edges.empty(); edges.pop_front()) out[burst.count++] = edges.front();
        return burst;
    }

private:
    Hardware& hardware_;
};

class GpiodSourceTest : public testing::Test {
protected:
    Hardware hardware;
    GpiodSource source{std::make_unique<FakeLines>(hardware)};

    void open(std::int64_t ms = 0) { ASSERT_TRUE(source.open(three_lines(), at_ms(ms), kOffset).ok()); }
    std::vector<SwitchEdge> read(std::int64_t ms, std::size_t room = 64) {
        std::vector<SwitchEdge> out(room);
        out.resize(source.read(at_ms(ms), out));
        return out;
    }
};

void expect_edge(const SwitchEdge& found, std::int64_t ms, int line, bool level) {
    EXPECT_EQ(found.time, at_ms(ms));
    EXPECT_EQ(found.line, line);
    EXPECT_EQ(found.level, level);
}

TEST_F(GpiodSourceTest, levels_at_start_are_the_first_edges) {
    hardware.lines[1].level = true;
    open(5);
    const auto edges = read(5);
    ASSERT_EQ(edges.size(), 3u);
    for (int line = 0; line < 3; ++line) expect_edge(edges[static_cast<std::size_t>(line)], 5, line, line == 1);
    EXPECT_EQ(source.health(), SourceHealth::running);
    EXPECT_TRUE(read(6).empty());
}

TEST_F(GpiodSourceTest, edges_carry_the_kernels_stamp_in_source_time_and_come_in_order) {
    open();
    static_cast<void>(read(0));
    hardware.set(120, 2, true);
    hardware.set(100, 0, true);
    hardware.set(110, 0, false);
    const auto edges = read(150);
    ASSERT_EQ(edges.size(), 3u);
    expect_edge(edges[0], 100, 0, true);
    expect_edge(edges[1], 110, 0, false);
    expect_edge(edges[2], 120, 2, true);
    EXPECT_EQ(source.statistics().overruns, 0u);
    EXPECT_GT(source.statistics().rereads, 0u);
}

TEST_F(GpiodSourceTest, edges_after_the_time_asked_for_wait) {
    open();
    static_cast<void>(read(0));
    hardware.set(120, 0, true);
    EXPECT_TRUE(read(119).empty());
    EXPECT_EQ(read(120).size(), 1u);
}

TEST_F(GpiodSourceTest, a_small_buffer_loses_nothing) {
    open();
    static_cast<void>(read(0));
    for (int i = 0; i < 10; ++i) hardware.set(100 + i, 0, i % 2 == 0);
    std::size_t total = 0;
    for (int i = 0; i < 10; ++i) total += read(200, 1).size();
    EXPECT_EQ(total, 10u);
}

TEST_F(GpiodSourceTest, a_level_that_no_edge_explains_is_read_again_and_counted) {
    open();
    static_cast<void>(read(0));
    hardware.overrun(100, 0);
    const auto edges = read(200);
    ASSERT_EQ(edges.size(), 17u);
    EXPECT_FALSE(edges[15].level) << "the newest edge that the kernel kept";
    expect_edge(edges[16], 200, 0, true);
    EXPECT_EQ(source.statistics().overruns, 1u);
    EXPECT_TRUE(read(201).empty());
}

TEST_F(GpiodSourceTest, without_reading_again_the_overrun_would_be_missed) {
    hardware.overrun(100, 0);
    EXPECT_NE(hardware.lines[0].edges.back().level, hardware.lines[0].level);
}

TEST_F(GpiodSourceTest, an_edge_while_levels_are_read_is_no_overrun) {
    open();
    static_cast<void>(read(0));
    hardware.set(100, 0, true);
    hardware.before_level = [&, done = false](std::size_t) mutable {
        if (!std::exchange(done, true)) hardware.set(140, 0, false);
    };
    const auto edges = read(150);
    ASSERT_EQ(edges.size(), 2u);
    expect_edge(edges[1], 140, 0, false);
    EXPECT_EQ(source.statistics().overruns, 0u);
}

TEST_F(GpiodSourceTest, a_line_that_never_stops_chattering_is_read_again_at_the_next_call) {
    open();
    static_cast<void>(read(0));
    hardware.set(100, 0, true);
    int ms = 100;
    hardware.before_level = [&](std::size_t line) {
        if (line == 0) hardware.set(++ms, 0, !hardware.lines[0].level);
    };
    static_cast<void>(read(150));
    hardware.before_level = [](std::size_t) {};
    hardware.lines[0].edges.clear();
    hardware.lines[0].level = !hardware.lines[0].level;
    const auto edges = read(200);
    ASSERT_EQ(edges.size(), 1u);
    expect_edge(edges[0], 200, 0, hardware.lines[0].level);
    EXPECT_EQ(source.statistics().overruns, 0u) << "the level was not known, so no edge is known to be lost";
}

TEST_F(GpiodSourceTest, losses_that_the_kernel_reports_are_counted) {
    open();
    static_cast<void>(read(0));
    hardware.says_lost = true;
    hardware.set(100, 0, true);
    static_cast<void>(read(150));
    EXPECT_EQ(source.statistics().overruns, 1u);
}

TEST_F(GpiodSourceTest, when_nobody_reads_for_long_the_levels_still_come_right) {
    open();
    static_cast<void>(read(0));
    for (int burst = 0; burst < 40; ++burst) {
        for (int i = 0; i < 16; ++i) hardware.set(100 + 16 * burst + i, 0, i % 2 == 0);
        static_cast<void>(source.read(at_ms(50), base::Span<SwitchEdge>()));
    }
    EXPECT_GT(source.statistics().overruns, 0u) << "more edges than there is room for";
    hardware.lines[0].edges.clear();
    hardware.lines[0].level = true;
    std::vector<SwitchEdge> all;
    for (int i = 0; i < 3; ++i) {
        const auto edges = read(2000 + i, 512);
        all.insert(all.end(), edges.begin(), edges.end());
    }
    EXPECT_EQ(all.size(), kMaxWaitingEdges + 1);
    EXPECT_TRUE(all.back().level);
}

TEST_F(GpiodSourceTest, a_refused_request_says_why_and_leaves_it_failed) {
    hardware.refuses_request = true;
    const auto opened = source.open(three_lines(), at_ms(0), kOffset);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().message.view(), "refused");
    EXPECT_EQ(source.health(), SourceHealth::failed);
    EXPECT_TRUE(read(1).empty());
    hardware.refuses_request = false;
    open();
    EXPECT_EQ(read(0).size(), 3u) << "it may be opened again";
}

TEST_F(GpiodSourceTest, levels_that_cannot_be_read_at_start_are_an_error) {
    hardware.answers = false;
    const auto opened = source.open(three_lines(), at_ms(0), kOffset);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().message.view(), "phase switches: a level cannot be read; check the GPIO chip");
    EXPECT_EQ(hardware.releases, 1);
}

TEST_F(GpiodSourceTest, hardware_that_stops_answering_turns_it_failed_and_gives_the_lines_back) {
    open();
    static_cast<void>(read(0));
    hardware.answers = false;
    EXPECT_TRUE(read(100).empty());
    EXPECT_EQ(source.health(), SourceHealth::failed);
    EXPECT_EQ(hardware.releases, 1);
    EXPECT_TRUE(read(200).empty());
    hardware.answers = true;
    open(300);
    EXPECT_EQ(read(300).size(), 3u);
}

TEST_F(GpiodSourceTest, closing_gives_the_lines_back_once) {
    open();
    source.close();
    source.close();
    EXPECT_EQ(hardware.releases, 1);
    EXPECT_EQ(source.health(), SourceHealth::idle);
}

TEST(GpiodSource, without_libgpiod_it_says_so) {
    GpiodSource source(nullptr);
    const auto opened = source.open(three_lines(), at_ms(0), kOffset);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().message.view(),
              "phase switches: this program was built without libgpiod; install libgpiod-dev and build again");
    EXPECT_EQ(source.health(), SourceHealth::failed);
    std::vector<SwitchEdge> out(4);
    EXPECT_EQ(source.read(at_ms(1), out), 0u);
}

/// The phases that a source leads to, asked every 20 ms; what it hands out is also written as a log.
std::vector<std::string> phases_of(SwitchSource& source, std::int64_t end_ms, const std::function<void(std::int64_t)>& world,
                                   std::string& log) {
    SwitchToPhase to_phase(three_lines());
    std::vector<std::string> phases;
    char text[kMaxSwitchLogLine];
    for (std::int64_t ms = 0; ms <= end_ms; ms += 20) {
        world(ms);
        std::vector<SwitchEdge> edges(64);
        edges.resize(source.read(at_ms(ms), edges));
        for (const SwitchEdge& found : edges) {
            to_phase.add(found);
            log.append(text, format_switch_log_line(found, three_lines(), text));
        }
        const SwitchPhase status = to_phase.status(at_ms(ms));
        phases.push_back(std::string(status.statement.stated ? flight::scenario_name(status.statement.phase) : "-") +
                         (status.fault ? "!" : ""));
    }
    return phases;
}

TEST_F(GpiodSourceTest, a_recording_of_live_switches_replays_to_the_same_phases) {
    std::mt19937 random(8);
    hardware.lines[0].level = true;
    open();
    std::int64_t last = 0;
    const auto world = [&](std::int64_t now) {
        for (; last < now; ++last)
            if (random() % 40 == 0) hardware.set(last, random() % 3, random() % 2 == 0);
        if (random() % 200 == 0) hardware.overrun(now - 18, 0);
    };
    std::string log(kSwitchLogHeader), again(kSwitchLogHeader);
    const auto live = phases_of(source, 60'000, world, log);
    SwitchLogSource recorded(log, three_lines());
    const auto replayed = phases_of(
        recorded, 60'000, [](std::int64_t) {}, again);
    EXPECT_EQ(live, replayed);
    EXPECT_EQ(log, again);
    EXPECT_EQ(recorded.statistics().malformed, 0u);
    EXPECT_GT(std::set<std::string>(live.begin(), live.end()).size(), 3u) << "something did happen";
}

}  // namespace
}  // namespace tedavis::bus::test_gpiod_source
