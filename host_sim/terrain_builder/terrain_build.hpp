/// Builds a terrain database, streaming: the memory does not grow with the terrain.
#pragma once

#include <string>

#include "host_sim/terrain_builder/build_plan.hpp"

namespace tedavis::host_sim {

/// Work files lie in the folder `<output>.part`; the database appears whole at `output` or not at all. Equal posts and
/// options give equal bytes, whatever the number of threads. Throws UserError.
void build_terrain(const PostReaderFactory& open, const std::string& output, const BuildOptions& options);

}  // namespace tedavis::host_sim
