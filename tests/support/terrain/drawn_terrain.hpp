/// The triangles that a display would draw for a view, without a display: database, store, selection and index lists.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/terrain_store.hpp"

namespace tedavis::test_support {

class DrawnTerrain {
public:
    /// `source` must outlive it. Without attribute or drape slots no such pages are read.
    explicit DrawnTerrain(base::ByteSource& source, std::uint32_t slots = 512, std::uint32_t attribute_slots = 0,
                          std::uint32_t drape_slots = 0)
        : attributes_(attribute_slots * (sizeof(terrain::AttributePage) + 64) + 64),
          drape_(drape_slots * (sizeof(terrain::DrapePage) + 4096) + 64),
          reader_(source, base::kMaxReadTickets) {
        terrain::StoreSettings settings;
        settings.payload_slots = slots;
        settings.attribute_slots = attribute_slots;
        settings.drape_slots = drape_slots;
        settings.directory_pages = 512;
        settings.arrival_frames = 1;
        auto opened = terrain::TerrainDatabase::open(source, index_.arena);
        EXPECT_TRUE(opened.ok());
        if (!opened.ok()) return;
        database_ = opened.value();
        const terrain::TdbFailure failure = store_.start(
            database_, reader_, settings, {index_.arena, records_.arena, payloads_.arena, attributes_.arena, &drape_.arena});
        EXPECT_EQ(failure.error, terrain::TdbError::none) << to_string(failure.error);
        EXPECT_TRUE(selector_.start(records_.arena, 8 * slots));
        selected_.resize(slots);
        wanted_.resize(slots);
    }
    DrawnTerrain(const DrawnTerrain&) = delete;
    DrawnTerrain& operator=(const DrawnTerrain&) = delete;

    /// With everything arrived that the view needs.
    terrain::LodResult select(const terrain::View& view, const terrain::LodSettings& settings) {
        for (int frame = 0; frame < 3; ++frame) {
            store_.begin_frame();
            static_cast<void>(selector_.select(store_, view, settings, terrain::SelectionKind::ideal, span()));
            store_.want({wanted_.data(), selector_.wanted({wanted_.data(), wanted_.size()})});
            result_ = selector_.select(store_, view, settings, terrain::SelectionKind::drawn, span());
        }
        return result_;
    }
    [[nodiscard]] base::Span<const terrain::SelectedChunk> selected() const { return {selected_.data(), result_.chunks}; }
    [[nodiscard]] base::Span<const terrain::ChunkVertex> vertices(const terrain::SelectedChunk& chunk) const {
        return store_.vertices(chunk.slot);
    }
    /// Kept for every combination of coarser sides that was asked for.
    const std::vector<std::uint16_t>& indices(const terrain::SelectedChunk& chunk) {
        auto& kept = indices_[{chunk.key.packed(), chunk.coarser_edges}];
        if (!kept.empty()) return kept;
        kept.resize(3 * terrain::kMaxChunkTriangles);
        const terrain::MeshCount count = terrain::build_chunk_indices(*chunk.entry, vertices(chunk), store_.indices(chunk.slot),
                                                                      chunk.coarser_edges, *scratch_, {kept.data(), kept.size()});
        EXPECT_TRUE(count.sound);
        kept.resize(count.indices);
        return kept;
    }
    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    [[nodiscard]] const terrain::TerrainStore& store() const { return store_; }

private:
    struct Block {
        explicit Block(std::size_t bytes) : memory(bytes), arena(memory.data(), memory.size()) {}
        std::vector<std::uint8_t> memory;
        base::Arena arena;
    };
    base::Span<terrain::SelectedChunk> span() { return {selected_.data(), selected_.size()}; }

    Block index_{16u << 20}, records_{32u << 20}, payloads_{96u << 20}, attributes_, drape_;
    base::SynchronousReader reader_;
    terrain::TerrainDatabase database_;
    terrain::TerrainStore store_;
    terrain::LodSelector selector_;
    terrain::LodResult result_;
    std::vector<terrain::SelectedChunk> selected_;
    std::vector<terrain::WantedChunk> wanted_;
    std::map<std::pair<std::uint64_t, std::uint8_t>, std::vector<std::uint16_t>> indices_;
    std::unique_ptr<terrain::ChunkMeshScratch> scratch_ = std::make_unique<terrain::ChunkMeshScratch>();
};

}  // namespace tedavis::test_support
