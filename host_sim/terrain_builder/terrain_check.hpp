/// Proof of a database against its rasters: every chunk is recomputed from the rasters and compared.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/tdb_image.hpp"

namespace tedavis::host_sim {

struct ChunkViolation {
    std::string chunk;  ///< "level/i/j", or the part of the file outside its chunks
    std::string reason;
    /// Error found minus error stated, or the largest difference of a height or a position from the rasters.
    double excess_m = 0;
};

struct TerrainCheck {
    std::uint64_t chunks = 0;
    double worst_excess_m = 0;
    std::vector<ChunkViolation> violations;
};

/// `image` is the whole file. Finds damaged checksums, posts or vertices that differ from the rasters (also where the
/// checksums were rewritten to match) and meshes whose exhaustive error exceeds what the database states.
/// Throws UserError when the file is no database or was not built from a raster of this lattice.
[[nodiscard]] TerrainCheck check_tdb(const std::vector<std::uint8_t>& image, const std::string& name, const TerrainModel& model,
                                     const BuildOptions& options);

}  // namespace tedavis::host_sim
