#include "host_sim/window/switch_recording.hpp"

#include <gtest/gtest.h>

#include "bus/switches/switch_log_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "host_sim/input_file.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_switch_recording {
namespace {

const base::Time kNow{1'700'000'000'000'000'000};

bus::SwitchConfig panel(const std::string& name) {
    const std::string path = test_support::source_dir() + "/configs/switches/" + name + ".toml";
    return bus::load_switch_config(read_file(path), path).value();
}

// The reader of the bus is the oracle: whatever was turned before, it must state the pattern's phase once it is debounced.
TEST(SwitchRecording, ThePanelReadsThePatternBack) {
    for (const char* name : {"one_hot", "coded_parity"}) {
        const bus::SwitchConfig config = panel(name);
        std::vector<bus::SwitchEdge> edges;
        bus::SwitchToPhase reader(config);
        base::Time now = kNow;
        for (std::size_t n = 0; n < 60; ++n) {
            const bus::SwitchPattern& pattern = config.patterns[(n * 7) % config.patterns.size()];
            const auto added = edges_to_pattern(config, edges, pattern.high, now);
            for (const bus::SwitchEdge& edge : added) reader.add(edge);
            edges.insert(edges.end(), added.begin(), added.end());
            now = now + base::Duration::seconds(1);
            const bus::SwitchPhase status = reader.status(now);
            EXPECT_EQ(status.levels.high, pattern.high);
            EXPECT_FALSE(status.fault);
            EXPECT_EQ(status.statement.phase, pattern.phase);
        }
    }
}

TEST(SwitchRecording, StatesEveryLineFirstAndThenOnlyChanges) {
    const bus::SwitchConfig config = panel("one_hot");
    const auto first = edges_to_pattern(config, {}, config.patterns[0].high, kNow);
    EXPECT_EQ(first.size(), config.lines.size());
    EXPECT_TRUE(edges_to_pattern(config, first, config.patterns[0].high, kNow).empty());
    EXPECT_EQ(edges_to_pattern(config, first, config.patterns[3].high, kNow).size(), 2u);
}

TEST(SwitchRecording, AKeyOfThePatternsLeavesTheLineOfTheLegend) {
    bus::SwitchConfig config = panel("one_hot");
    ASSERT_TRUE(config.lines.try_push_back({"panel", "LEGEND"}));
    config.has_legend_line = true;
    const auto legend = static_cast<std::uint8_t>(config.lines.size() - 1);
    std::vector<bus::SwitchEdge> edges = edges_to_pattern(config, {}, config.patterns[0].high, kNow);
    ASSERT_EQ(edges.size(), config.lines.size()) << "a log has the level of every line";
    EXPECT_FALSE(edges.back().level);
    edges.push_back({kNow + base::Duration{1000}, legend, true});
    for (const bus::SwitchEdge& edge : edges_to_pattern(config, edges, config.patterns[3].high, kNow + base::Duration{2000}))
        EXPECT_NE(edge.line, legend);
}

TEST(SwitchRecording, TheLogReadsBack) {
    const bus::SwitchConfig config = panel("one_hot");
    std::vector<bus::SwitchEdge> edges = edges_to_pattern(config, {}, config.patterns[2].high, kNow + base::Duration{1000});
    const auto more = edges_to_pattern(config, edges, config.patterns[4].high, kNow + base::Duration{123'456'789});
    edges.insert(edges.end(), more.begin(), more.end());
    const std::string text = switch_log_text(config, edges);
    bus::SwitchLogSource source(text, config);
    bus::SwitchEdge read[64];
    ASSERT_EQ(source.read(base::Time{INT64_MAX}, base::Span<bus::SwitchEdge>(read)), edges.size());
    for (std::size_t n = 0; n < edges.size(); ++n) {
        EXPECT_EQ(read[n].time.ns, edges[n].time.ns);
        EXPECT_EQ(read[n].line, edges[n].line);
        EXPECT_EQ(read[n].level, edges[n].level);
    }
    EXPECT_TRUE(bus::has_switch_log_header(switch_log_text(config, {})));
}

}  // namespace
}  // namespace tedavis::host_sim::test_switch_recording
