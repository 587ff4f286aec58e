/// `tedavis scenario build S.toml -o DIR`: a seeded flight as flight.log and flight.switches, the spatial data round it as
/// scene.sdb, and scenario.json, which describes them. Equal seeds give equal bytes: the database's revision is always 1.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct ScenarioBuildOptions {
    std::string scenario = "default";   ///< file or shipped name
    std::string output;                 ///< folder
    std::optional<std::uint64_t> seed;  ///< nothing: the file's
};

/// Returns the exit code; throws UserError.
[[nodiscard]] int run_scenario_build(const ScenarioBuildOptions& options, Console& console);

}  // namespace tedavis::host_sim
