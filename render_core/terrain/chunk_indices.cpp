#include "render_core/terrain/chunk_indices.hpp"

namespace tedavis::terrain {

bool ChunkIndices::start(const TerrainStore& store, base::Arena& memory) {
    store_ = &store;
    indices_ = memory.allocate_array<std::uint16_t>(kMaxIndices);
    scratch_ = static_cast<ChunkMeshScratch*>(memory.allocate(sizeof *scratch_, alignof(ChunkMeshScratch)));
    return !indices_.empty() && scratch_ != nullptr;
}

IndexList ChunkIndices::of(const SelectedChunk& chunk) {
    const MeshCount mesh = build_chunk_indices(*chunk.entry, store_->vertices(chunk.slot), store_->indices(chunk.slot),
                                               chunk.coarser_edges, *scratch_, indices_);
    return {{indices_.data(), mesh.sound ? mesh.indices : 0}, mesh.sound};
}

}  // namespace tedavis::terrain
