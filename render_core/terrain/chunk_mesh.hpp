/// Triangles of a chunk for any combination of coarser neighbours.
///
/// Beside a coarser neighbour a chunk shows only those border vertices that the neighbour has too (format: "Borders"). Each of
/// the others is taken out in border order: the triangles round it are replaced by a triangulation of the polygon that they
/// leave, by cutting off ears, the one with the shortest new side first. The new surface has the neighbour's border exactly, so
/// there is no crack and no T-junction. Exact integers throughout; the builder measures what this gives for every combination.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/terrain/chunk_key.hpp"

namespace tedavis::terrain {

struct ChunkMeshScratch {
    static constexpr std::uint32_t kMaxRing = 512;  ///< vertices round one that is taken out
    std::uint16_t strip[kMaxChunkTriangles * 3];
    std::uint16_t ring[kMaxRing];
    std::uint8_t taken_out[kMaxChunkVertices];
};

struct MeshCount {
    std::uint32_t indices = 0;
    bool sound = false;  ///< false: the chunk contradicts its format; nothing of it may be drawn
};

/// Whether a vertex of the border is left out beside these coarser neighbours; `last_i` and `last_j` of the south-east corner.
[[nodiscard]] bool is_taken_out(const ChunkVertex& vertex, std::uint32_t last_i, std::uint32_t last_j,
                                std::uint8_t coarser_edges);

/// Writes triangles (counter-clockwise seen from above) as indices into `vertices`. `stored` are the payload's indices (empty
/// for a regular chunk), `coarser_edges` a set of EdgeBit. Triangles that a pole has made a line are left out.
/// Deterministic; bounded by the counts of the entry; allocates nothing.
[[nodiscard]] MeshCount build_chunk_indices(const ChunkEntry& entry, base::Span<const ChunkVertex> vertices,
                                            base::Span<const std::uint16_t> stored, std::uint8_t coarser_edges,
                                            ChunkMeshScratch& scratch, base::Span<std::uint16_t> indices);

}  // namespace tedavis::terrain
