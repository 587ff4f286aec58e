/// A whole database in memory as a catalogue in which everything is at hand, for selections from many threads.
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "render_core/terrain/chunk_catalogue.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/chunk_payload.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "tests/support/files/memory_bytes.hpp"

namespace tedavis::test_support {

/// The triangles of a chunk as they are drawn.
struct ChunkTriangles {
    terrain::PostRange posts;
    glm::dvec3 centre;
    base::Span<const terrain::ChunkVertex> vertices;
    std::vector<std::uint16_t> indices;
};

class MemoryTerrain final : public terrain::ChunkCatalogue {
public:
    explicit MemoryTerrain(std::vector<std::uint8_t> image)
        : image_(std::move(image)), bytes_(image_), memory_(16u << 20), arena_(memory_.data(), memory_.size()) {
        auto opened = terrain::TerrainDatabase::open(bytes_, arena_);
        EXPECT_TRUE(opened.ok());
        if (!opened.ok()) return;
        database_ = opened.value();
        pages_.resize(database_.lattice().page_count());
        for (std::uint32_t n = 0; n < pages_.size(); ++n) {
            if (!database_.has_page(n)) continue;
            EXPECT_EQ(database_.read_page(n, pages_[n]).error, terrain::TdbError::none);
        }
    }
    MemoryTerrain(const MemoryTerrain&) = delete;
    MemoryTerrain& operator=(const MemoryTerrain&) = delete;

    [[nodiscard]] const terrain::Lattice& lattice() const override { return database_.lattice(); }
    [[nodiscard]] terrain::FoundEntry find(const terrain::ChunkKey& key) override {
        const std::uint32_t page = lattice().page_index(key);
        const terrain::ChunkEntry& entry = pages_[page].entries[terrain::Lattice::index_in_page(key)];
        if (!database_.has_page(page) || entry.vertex_count == 0) return {};
        return {&entry, terrain::EntryState::present};
    }
    [[nodiscard]] terrain::SlotIndex available_slot(const terrain::ChunkKey&) const override { return 0; }

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    [[nodiscard]] ChunkTriangles triangles(const terrain::ChunkKey& key, const terrain::ChunkEntry& entry,
                                           std::uint8_t coarser_edges, terrain::ChunkMeshScratch& scratch) const {
        const base::Span<const std::uint8_t> payload{image_.data() + entry.payload.offset, entry.payload.bytes};
        ChunkTriangles mesh{lattice().posts_of(key),
                            {entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]},
                            terrain::payload_vertices(entry, payload),
                            std::vector<std::uint16_t>(3 * terrain::kMaxChunkTriangles)};
        const terrain::MeshCount count =
            terrain::build_chunk_indices(entry, mesh.vertices, terrain::payload_indices(entry, payload), coarser_edges, scratch,
                                         {mesh.indices.data(), mesh.indices.size()});
        EXPECT_TRUE(count.sound);
        mesh.indices.resize(count.indices);
        return mesh;
    }

private:
    std::vector<std::uint8_t> image_;
    MemoryBytes bytes_;
    std::vector<std::uint8_t> memory_;
    base::Arena arena_;
    terrain::TerrainDatabase database_;
    std::vector<terrain::DirectoryPage> pages_;
};

}  // namespace tedavis::test_support
