/// The vertices of an exact chunk, read and verified.
#pragma once

#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::raytrace {

/// Bytes of an exact chunk's payload at most: every post of its grid and no index.
inline constexpr std::size_t kExactChunkBytes =
    (terrain::kChunkCells + 1) * (terrain::kChunkCells + 1) * sizeof(terrain::ChunkVertex);

/// Into kExactChunkBytes, aligned for terrain::ChunkVertex. Not TdbError::none: damaged, or not regular, as exact chunks are.
[[nodiscard]] terrain::TdbFailure read_exact_chunk(const terrain::TerrainDatabase& database, const terrain::ChunkEntry& entry,
                                                   base::Span<std::uint8_t> payload);

}  // namespace tedavis::raytrace
