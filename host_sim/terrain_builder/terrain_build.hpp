/// Builds a terrain database, streaming: the memory does not grow with the terrain.
#pragma once

#include <string>

#include "host_sim/terrain_builder/terrain_sources.hpp"

namespace tedavis::host_sim {

/// Work files lie in the folder `<output>.part`; the database appears whole at `output` or not at all. The same build goes on
/// where it was interrupted. Equal posts and options give equal bytes, whatever the number of threads and however often it was
/// interrupted. Throws UserError, and what options.progress throws.
void build_terrain(const TerrainSources& sources, const std::string& output, const BuildOptions& options);

}  // namespace tedavis::host_sim
