/// The scene of the default flight as `scenario build default` writes it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/scenario/scenario_scene.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::test_support {

/// A scene database.
inline std::vector<std::uint8_t> default_scene() {
    const std::string path = "configs/scenarios/default.toml";
    const host_sim::Scenario scenario = host_sim::parse_scenario(source_file(path), source_dir() + "/" + path);
    const host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();  // the flight keeps a reference
    const host_sim::ScenarioFlight flight(scenario, scenario.seed, geoid);
    return host_sim::sdb_bytes(host_sim::make_scenario_scene(scenario, flight, scenario.seed, [](auto, auto, auto) {}).draft);
}

}  // namespace tedavis::test_support
