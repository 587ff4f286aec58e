/// Reads and verifies the vertices of an exact chunk.
#pragma once

#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::raytrace {

/// Largest payload of an exact chunk, bytes: every post of its grid and no indices.
inline constexpr std::size_t kExactChunkBytes =
    (terrain::kChunkCells + 1) * (terrain::kChunkCells + 1) * sizeof(terrain::ChunkVertex);

/// Reads into a buffer of kExactChunkBytes, aligned for terrain::ChunkVertex. Returns an error where the chunk is damaged or
/// not regular (exact chunks are regular).
[[nodiscard]] terrain::TdbFailure read_exact_chunk(const terrain::TerrainDatabase& database, const terrain::ChunkEntry& entry,
                                                   base::Span<std::uint8_t> payload);

}  // namespace tedavis::raytrace
