/// Builds the index lists that selected chunks are drawn with, one at a time. Drawing, lines of sight and objects on the ground
/// use the same lists.
///
/// Memory  one list and the scratch to build it, from an arena at start(). Thread  the store's. Failure  start() returns false.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/terrain_store.hpp"

namespace tedavis::terrain {

struct IndexList {
    base::Span<const std::uint16_t> indices;  ///< three a triangle, counter-clockwise seen from above
    bool sound = false;                       ///< false: the chunk contradicts its format, and the list is empty
};

class ChunkIndices {
public:
    /// Number of indices of the largest chunk.
    static constexpr std::uint64_t kMaxIndices = std::uint64_t{kMaxChunkTriangles} * 3;

    /// The store must outlive the object.
    [[nodiscard]] bool start(const TerrainStore& store, base::Arena& memory);
    /// Returns the list of a chunk whose payload is available; valid until the next call.
    [[nodiscard]] IndexList of(const SelectedChunk& chunk);

private:
    const TerrainStore* store_ = nullptr;
    base::Span<std::uint16_t> indices_;
    ChunkMeshScratch* scratch_ = nullptr;
};

}  // namespace tedavis::terrain
