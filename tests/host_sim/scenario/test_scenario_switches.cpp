#include "host_sim/scenario/scenario_switches.hpp"

#include <gtest/gtest.h>

#include <array>

#include "bus/switches/switch_log_source.hpp"
#include "bus/switches/switch_to_phase.hpp"
#include "host_sim/input_file.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scenario_switches {
namespace {

Scenario shipped() {
    return parse_scenario(read_file(test_support::source_dir() + "/configs/scenarios/default.toml"), "default.toml");
}

bus::SwitchConfig panel(const std::string& name) {
    const auto config =
        bus::load_switch_config(read_file(test_support::source_dir() + "/configs/switches/" + name + ".toml"), name);
    EXPECT_TRUE(config.ok());
    return config.value();
}

// The decoder of the bus is the oracle: in the middle of each leg it must read the phase that the leg states.
TEST(ScenarioSwitches, TheBusReadsThePhasesBack) {
    const Scenario scenario = shipped();
    const GeoidEgm96 geoid = GeoidEgm96::installed();  // the flight keeps a reference
    const ScenarioFlight flight(scenario, 1, geoid);
    const bus::SwitchConfig config = panel("one_hot");
    const std::string text = scenario_switch_log(scenario, flight, config);
    bus::SwitchLogSource source(text, config);
    bus::SwitchToPhase reader(config);
    for (std::size_t i = 0; i < scenario.legs.size(); ++i) {
        const base::Time now =
            flight.begin() + base::Duration::from_seconds((flight.legs()[i].begin_s + flight.legs()[i].end_s) / 2);
        std::array<bus::SwitchEdge, 64> edges;
        const std::size_t count = source.read(now, {edges.data(), edges.size()});
        for (std::size_t k = 0; k < count; ++k) reader.add(edges[k]);
        const bus::SwitchPhase status = reader.status(now);
        const Leg& leg = scenario.legs[i];
        EXPECT_FALSE(status.fault) << i;
        if (leg.stated_by == PhaseStatedBy::switches) {
            EXPECT_EQ(status.statement.phase.scenario, leg.phase.scenario) << i;
        } else {
            EXPECT_EQ(status.levels.high, std::uint32_t{1} << config.find_line("panel.AUTO")) << i;
        }
    }
    EXPECT_EQ(source.statistics().malformed, 0u);
}

TEST(ScenarioSwitches, RefusesAPanelThatLacksAPhase) {
    const Scenario scenario = shipped();
    const GeoidEgm96 geoid = GeoidEgm96::installed();  // the flight keeps a reference
    const ScenarioFlight flight(scenario, 1, geoid);
    bus::SwitchConfig config = panel("one_hot");
    for (bus::SwitchPattern& pattern : config.patterns) {
        if (pattern.phase.scenario == flight::Scenario::cruise) pattern.phase = flight::kTakeoffStart;
    }
    test_support::expect_user_error([&] { (void)scenario_switch_log(scenario, flight, config); }, "has no pattern for cruise");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario_switches
