/// Raster files as the sources of one terrain: which of them are its ground, and which are finer insets in it.
#pragma once

#include <string>
#include <vector>

#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/terrain_sources.hpp"

namespace tedavis::host_sim {

/// Files at least half as dense again as the coarsest one that lie within the others are insets; all others are one raster, on
/// the finest step of them. So are all files where the options speak of single ones (extent, encoding). `notes` gets sentences
/// that the user should read. Throws UserError.
[[nodiscard]] TerrainSources sources_of_files(const std::vector<std::string>& files, const RasterOptions& options,
                                              std::vector<std::string>& notes);

}  // namespace tedavis::host_sim
