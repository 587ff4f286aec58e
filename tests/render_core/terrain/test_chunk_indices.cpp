#include "render_core/terrain/chunk_indices.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/files/memory_bytes.hpp"
#include "tests/support/terrain/drawn_terrain.hpp"
#include "tests/support/terrain/raster_scene.hpp"

namespace tedavis::terrain::test_chunk_indices {
namespace {

TEST(ChunkIndices, AreThoseOfTheMeshBuiltAlone) {
    const test_support::RasterScene scene(test_support::make_rough_raster(129, 129));
    test_support::MemoryBytes bytes(scene.built.image);
    test_support::DrawnTerrain terrain(bytes);
    LodSettings settings;
    settings.tau_px = 1;
    ASSERT_GT(terrain.select(scene.view(64, 64, 3000, 120, -20), settings).chunks, 0u);
    std::vector<std::uint8_t> memory(1 << 20);
    base::Arena arena(memory.data(), memory.size());
    ChunkIndices indices;
    ASSERT_TRUE(indices.start(terrain.store(), arena));
    for (const SelectedChunk& chunk : terrain.selected()) {
        const IndexList list = indices.of(chunk);
        EXPECT_TRUE(list.sound);
        const std::vector<std::uint16_t>& alone = terrain.indices(chunk);
        EXPECT_EQ(std::vector<std::uint16_t>(list.indices.begin(), list.indices.end()), alone);
        EXPECT_FALSE(alone.empty());
        ChunkEntry entry = *chunk.entry;
        ++entry.vertex_count;
        SelectedChunk contradicting = chunk;
        contradicting.entry = &entry;
        const IndexList none = indices.of(contradicting);
        EXPECT_FALSE(none.sound) << "control: the payload has fewer vertices than the entry says";
        EXPECT_TRUE(none.indices.empty());
    }
}

TEST(ChunkIndices, AreRefusedWithoutRoom) {
    const test_support::RasterScene scene(test_support::make_rough_raster(33, 33));
    test_support::MemoryBytes bytes(scene.built.image);
    const test_support::DrawnTerrain terrain(bytes);
    std::vector<std::uint8_t> memory(1000);
    base::Arena arena(memory.data(), memory.size());
    ChunkIndices indices;
    EXPECT_FALSE(indices.start(terrain.store(), arena));
}

}  // namespace
}  // namespace tedavis::terrain::test_chunk_indices
