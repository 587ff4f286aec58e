/// Verifies a database against its rasters: every part is built again from the rasters and compared.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/terrain_sources.hpp"

namespace tedavis::host_sim {

struct ChunkViolation {
    std::string chunk;  ///< "level/i/j", or the part of the file outside its chunks
    std::string reason;
    /// Error found minus error stated, or the largest difference of a height or a position from the rasters at the same post.
    double excess_m = 0;
};

struct TerrainCheck {
    std::uint64_t chunks = 0;
    std::uint64_t violations = 0;
    double worst_excess_m = 0;
    std::vector<ChunkViolation> first;  ///< in the file's order, kMaxReported at most
};
inline constexpr std::size_t kMaxReported = 1000;

/// Checks a database. A drape is compared with its image if `sources` has it; without it only the drape's checksums are verified.
/// Finds damaged checksums, vertices, classes, triangles and attributes that differ from the rasters (also where checksums were
/// rewritten to match), and errors that are larger than stated. Needs bounded memory; work files are in the folder
/// `<database>.check`, are as large as a build's, and are removed. Throws UserError when the file is no database or was not built
/// from posts of this lattice.
[[nodiscard]] TerrainCheck check_terrain(const std::string& database, const TerrainSources& sources, const BuildOptions& options);

}  // namespace tedavis::host_sim
