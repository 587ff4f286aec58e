/// Triangles of a chunk, from its vertices alone, for any combination of coarser neighbours.
///
/// A chunk of level k beside one of level k+1 must show on the common border only vertices of top_level >= k+1. Those
/// vertices and everything that was split because of them are left out; what remains is conforming, so there is no
/// crack and no T-junction by construction. The builder guarantees that a border vertex never depends on a vertex of
/// another border (see terrain_builder), so that neighbours decide alike without asking each other.
///
/// At unit cells the network's alternating diagonals are replaced by the true surface's fixed one.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::terrain {

/// Borders with a coarser neighbour, one bit each.
enum EdgeBit : std::uint8_t { kEdgeNorth = 1, kEdgeEast = 2, kEdgeSouth = 4, kEdgeWest = 8 };

struct ChunkMeshScratch {
    static constexpr std::uint32_t kTableSize = 16384;  // power of two, over 2.6 x kMaxChunkVertices
    std::uint16_t table[kTableSize];
    std::uint8_t effective[kMaxChunkVertices];
};

struct ChunkPlace {
    std::uint32_t level = 0, i = 0, j = 0;        ///< chunk coordinates
    std::uint32_t last_column = 0, last_row = 0;  ///< of the database, in posts
};

struct MeshCount {
    std::uint32_t indices = 0;
    bool sound = false;  ///< false: vertices contradict each other or the capacity; nothing may be drawn
};

/// Writes triangles (counter-clockwise seen from above) as indices into `vertices`, which must be in file order:
/// coarse scales first. Deterministic; bounded by the vertex count; allocates nothing.
[[nodiscard]] MeshCount build_chunk_indices(base::Span<const ChunkVertex> vertices, const ChunkPlace& place,
                                            std::uint8_t coarser_edges, ChunkMeshScratch& scratch,
                                            base::Span<std::uint16_t> indices);

}  // namespace tedavis::terrain
