/// Builds a terrain database in bounded memory for any size of the terrain.
#pragma once

#include <string>

#include "host_sim/terrain_builder/terrain_sources.hpp"

namespace tedavis::host_sim {

/// Work files are in the folder `<output>.part`; the database appears complete at `output` or not at all. An interrupted build of
/// the same sources and options is continued. Equal posts and options give equal bytes, whatever the number of threads and
/// however often it was interrupted. Throws UserError, and exceptions of options.progress.
void build_terrain(const TerrainSources& sources, const std::string& output, const BuildOptions& options);

}  // namespace tedavis::host_sim
