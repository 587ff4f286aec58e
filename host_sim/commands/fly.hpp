/// `tedavis fly FLIGHT -o DIR`: from a recorded flight to its report by the steps of convert, terrain build, scene build and
/// replay, in one command.
#pragma once

#include <string>
#include <vector>

#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"

namespace tedavis::host_sim {

inline constexpr std::uint64_t kFlyFrames = 300;  ///< number of frames unless the options state another

struct FlyOptions {
    ConvertOptions flight;             ///< without its output; the flight may also be a bus log, which is replayed as it is
    TerrainBuildOptions terrain;       ///< without its output; one .tdb, rasters, or none
    std::vector<std::string> weather;  ///< files of grids from which a scene is made (weather_scene.hpp)
    std::string scene;                 ///< scene file, shipped name or .sdb, instead of weather; empty: none
    ReplayOptions replay;  ///< without log, terrain, scene, and what of the flight is drawn; `output` and `spread` are given
};

/// Converts the flight to `<output>/flight.log`, builds the terrain unless it is in the cache (terrain_cache.hpp), builds the
/// scene as `<output>/scene.sdb`, for weather also its file `scene.toml`, and draws frames while the flight is over the terrain.
/// An error or an interruption before the first frame leaves only the terrain in the cache; a later interruption leaves a shorter
/// run. Returns the exit code of replay; throws UserError and Interrupted.
[[nodiscard]] int run_fly(const FlyOptions& options, Console& console);

}  // namespace tedavis::host_sim
