/// A cache of the terrain databases that commands build.
///
/// A database lies in the folder `tedavis/terrain` of the user's cache ($XDG_CACHE_HOME, else ~/.cache). Its name contains a hash
/// of terrain_build_identity(), of the program's version and of the database's format. A changed raster or another option thus
/// gives another database, and so does a change of a file that GDAL reads beside the raster (files_of_raster()), such as a world
/// file or a part of a virtual raster. If the folder is larger than kKeptTerrainBytes after a build, the databases that were used
/// longest ago are removed (kept_terrains.hpp).
///
/// A database appears whole or not at all. Only one process at a time builds it; others that need it wait. An interrupted build
/// continues where it stopped.
#pragma once

#include <string>

#include "host_sim/commands/terrain.hpp"
#include "host_sim/console.hpp"

namespace tedavis::host_sim {

/// Empty where the environment names neither an absolute $XDG_CACHE_HOME nor a home.
[[nodiscard]] std::string terrain_cache_folder();

/// The path of the database of these rasters; `build.output` is not read. Prints where it is and whether it was built before.
/// Throws UserError for rasters that cannot be read and a folder that cannot be written; Interrupted.
[[nodiscard]] std::string cached_terrain(const TerrainBuildOptions& build, Console& console);

}  // namespace tedavis::host_sim
