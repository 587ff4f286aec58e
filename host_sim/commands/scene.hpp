/// `tedavis scene build | info`.
#pragma once

#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct SceneBuildOptions {
    std::string scene;   ///< file or shipped name
    std::string output;  ///< .sdb
};

struct SceneInfoOptions {
    std::string database;
};

/// Each returns the exit code and throws UserError for bad input.
[[nodiscard]] int run_scene_build(const SceneBuildOptions& options, Console& console);
[[nodiscard]] int run_scene_info(const SceneInfoOptions& options, Console& console);

}  // namespace tedavis::host_sim
