/// Loads rasters of any kind that GDAL reads as one geographic lattice of posts in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/post_grid.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// A grid with its posts, row by row. Heights are above MSL (EGM96); void posts hold NaN.
struct Raster : PostGrid {
    std::vector<float> height_m;
    std::vector<terrain::PostClass> post_class;
    bool resampled = false;  ///< posts were interpolated from another grid
    std::uint64_t void_posts = 0;
    std::vector<std::string> notes;  ///< sentences that the user should read

    [[nodiscard]] std::size_t at(std::uint32_t i, std::uint32_t j) const { return std::size_t{j} * columns + i; }
};

/// Loads all posts of a PostSource. Throws UserError, also where there are more than 2^30 posts or only voids.
[[nodiscard]] Raster load_rasters(const std::vector<std::string>& files, const RasterOptions& options);

}  // namespace tedavis::host_sim
