/// Terrain databases that commands build by themselves, kept for the next time.
///
/// A database lies in the folder `tedavis/terrain` of the user's cache ($XDG_CACHE_HOME, else ~/.cache). Its name holds a hash of
/// what terrain_build_identity() states, of the program's version and of the database's format; a raster that was changed, or
/// another option, has another database; so has one of which a file changed that GDAL reads beside it (files_of_raster()), such
/// as a world file or a part of a virtual raster. Where a build takes the folder beyond kKeptTerrainBytes, those that were used
/// longest ago are removed (kept_terrains.hpp).
///
/// A database appears whole or not at all, and is built by one process at a time: another one that needs it waits. A build that
/// was interrupted goes on where it was.
#pragma once

#include <string>

#include "host_sim/commands/terrain.hpp"
#include "host_sim/console.hpp"

namespace tedavis::host_sim {

/// Empty where the environment names neither an absolute $XDG_CACHE_HOME nor a home.
[[nodiscard]] std::string terrain_cache_folder();

/// The path of the database of these rasters; `build.output` is not read. Says on the console where it is and whether it was
/// there. Throws UserError for rasters that cannot be read and a folder that cannot be written; Interrupted.
[[nodiscard]] std::string cached_terrain(const TerrainBuildOptions& build, Console& console);

}  // namespace tedavis::host_sim
