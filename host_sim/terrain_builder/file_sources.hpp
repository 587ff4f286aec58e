/// Divides raster files into those of the whole terrain and finer insets within it.
#pragma once

#include <string>
#include <vector>

#include "host_sim/terrain_builder/post_source.hpp"
#include "host_sim/terrain_builder/terrain_sources.hpp"

namespace tedavis::host_sim {

/// Files that lie within the others and have posts at least 1.5 times as dense as the coarsest file are insets. All others form
/// one raster with the finest step of them, as do all files if the options are for single files (extent, encoding). Sentences for
/// the user are appended to `notes`. Throws UserError.
[[nodiscard]] TerrainSources sources_of_files(const std::vector<std::string>& files, const RasterOptions& options,
                                              std::vector<std::string>& notes);

}  // namespace tedavis::host_sim
