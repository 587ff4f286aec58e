/// Triangles of a chunk for any combination of coarser neighbours.
///
/// Beside a coarser neighbour a chunk keeps only those border vertices that the neighbour has too (tdb_format.hpp, "Borders").
/// The others are removed in border order: the triangles round each are replaced by an ear-clipping triangulation of the
/// polygon that they leave, shortest new side first. The new surface has exactly the neighbour's border, so there is no crack
/// and no T-junction. All arithmetic is in exact integers; the terrain builder measures the resulting error for every
/// combination.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/terrain/chunk_key.hpp"

namespace tedavis::terrain {

struct ChunkMeshScratch {
    static constexpr std::uint32_t kMaxRing = 512;  ///< vertices round a removed one
    std::uint16_t strip[kMaxChunkTriangles * 3];
    std::uint16_t ring[kMaxRing];
    std::uint8_t taken_out[kMaxChunkVertices];
};

struct MeshCount {
    std::uint32_t indices = 0;
    bool sound = false;  ///< false: the chunk contradicts its format and must not be drawn
};

/// True where a border vertex is removed beside these coarser neighbours; `last_i` and `last_j` are those of the south-east
/// corner.
[[nodiscard]] bool is_taken_out(const ChunkVertex& vertex, std::uint32_t last_i, std::uint32_t last_j,
                                std::uint8_t coarser_edges);

/// Writes triangles (counter-clockwise seen from above) as indices into `vertices`. `stored` are the payload's indices (empty
/// for a regular chunk), `coarser_edges` a set of EdgeBit. Triangles that degenerate to a line at a pole are left out.
/// Deterministic; bounded by the counts of the entry; allocates nothing.
[[nodiscard]] MeshCount build_chunk_indices(const ChunkEntry& entry, base::Span<const ChunkVertex> vertices,
                                            base::Span<const std::uint16_t> stored, std::uint8_t coarser_edges,
                                            ChunkMeshScratch& scratch, base::Span<std::uint16_t> indices);

}  // namespace tedavis::terrain
