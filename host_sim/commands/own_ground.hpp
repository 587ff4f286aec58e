/// Terrain and spatial data that a command makes for itself when it is given none: built as `terrain build`, `scenario build` and
/// `scene build` do, into a folder that must outlive their use.
#pragma once

#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct OwnTerrain {
    std::string raster;
    bool generated_image = false;  ///< with an invented drape
};

/// Each returns the database's path; throws UserError and Interrupted.
[[nodiscard]] std::string build_own_terrain(const OwnTerrain& terrain, const std::string& folder, Console& console);
[[nodiscard]] std::string build_own_scenario(const std::string& scenario, const std::string& folder, Console& console);
[[nodiscard]] std::string build_own_scene(const std::string& scene, const std::string& folder, Console& console);

}  // namespace tedavis::host_sim
