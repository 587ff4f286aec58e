/// The meshes of a written database, for whoever looks at what is drawn.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "render_core/terrain/drawn_surface.hpp"
#include "tests/support/terrain/resident_tdb.hpp"

namespace tedavis::test_support {

class MeshesOfTest final : public terrain::DrawnMeshes {
public:
    explicit MeshesOfTest(const WrittenTdb& tdb) : tdb_(tdb) {}
    [[nodiscard]] const WrittenTdb& tdb() const { return tdb_; }

    base::Span<const terrain::ChunkVertex> vertices(const terrain::SelectedChunk& chunk) override {
        auto& kept = vertices_[chunk.key.packed()];
        if (kept.empty()) kept = tdb_.vertices(chunk.key);
        return {kept.data(), kept.size()};
    }
    base::Span<const std::uint16_t> stored_indices(const terrain::SelectedChunk& chunk) override {
        if ((chunk.entry->flags & terrain::kChunkRegular) != 0) return {};
        return indices(chunk, 0);
    }
    base::Span<const std::uint16_t> drawn_indices(const terrain::SelectedChunk& chunk) override {
        return indices(chunk, chunk.coarser_edges);
    }

private:
    base::Span<const std::uint16_t> indices(const terrain::SelectedChunk& chunk, std::uint8_t coarser_edges) {
        auto& kept = indices_[{chunk.key.packed(), coarser_edges}];
        if (kept.empty()) kept = tdb_.indices(chunk.key, coarser_edges);
        return {kept.data(), kept.size()};
    }

    const WrittenTdb& tdb_;
    std::map<std::uint64_t, std::vector<terrain::ChunkVertex>> vertices_;
    std::map<std::pair<std::uint64_t, std::uint8_t>, std::vector<std::uint16_t>> indices_;
};

}  // namespace tedavis::test_support
