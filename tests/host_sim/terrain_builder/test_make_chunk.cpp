#include "host_sim/terrain_builder/make_chunk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "render_core/base/hash.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::ChunkVertex;
using terrain::kChunkPosts;
using terrain::kLeafPostBytes;

class MakeChunk : public ::testing::Test {
protected:
    MadeChunk make(std::uint32_t level, std::uint32_t i, std::uint32_t j) { return make_chunk(model_, level, i, j, *scratch_); }
    static std::vector<ChunkVertex> vertices(const MadeChunk& chunk) {
        std::vector<ChunkVertex> result(chunk.entry.vertex_count);
        std::memcpy(result.data(), chunk.payload.data(), result.size() * sizeof(ChunkVertex));
        return result;
    }

    Raster raster_ = test_support::make_rough_raster(100, 80);
    TerrainModel model_ = make_model(raster_, {});
    std::unique_ptr<terrain::ChunkMeshScratch> scratch_ = std::make_unique<terrain::ChunkMeshScratch>();
};

TEST_F(MakeChunk, TheEntryDescribesThePayload) {
    const MadeChunk leaf = make(0, 1, 1), top = make(model_.lattice.levels - 1, 0, 0);
    for (const MadeChunk* chunk : {&leaf, &top}) {
        EXPECT_EQ(chunk->entry.bytes, chunk->payload.size());
        EXPECT_EQ(chunk->entry.crc, base::crc32(chunk->payload.data(), chunk->payload.size()));
        EXPECT_EQ(chunk->payload.size(), chunk->entry.vertex_count * sizeof(ChunkVertex) + (chunk == &leaf ? kLeafPostBytes : 0));
        EXPECT_GT(chunk->entry.triangle_count, 0u);
    }
    EXPECT_EQ(leaf.entry.i, 1u);
    EXPECT_EQ(leaf.entry.level, 0);
}

TEST_F(MakeChunk, ALeafHoldsItsPosts) {
    const MadeChunk leaf = make(0, 1, 1);
    const std::uint8_t* posts = leaf.payload.data() + leaf.payload.size() - kLeafPostBytes;
    for (std::uint32_t j = 0; j < kChunkPosts; ++j) {
        for (std::uint32_t i = 0; i < kChunkPosts; ++i) {
            float height;
            std::memcpy(&height, posts + (j * kChunkPosts + i) * sizeof height, sizeof height);
            ASSERT_EQ(height, raster_.height_m[raster_.at(32 + i, 32 + j)]);
        }
    }
}

TEST_F(MakeChunk, TheBoxHoldsEveryVertexAndTheHeightsEveryPost) {
    for (std::uint32_t level = 0; level < model_.lattice.levels; ++level) {
        const MadeChunk chunk = make(level, 0, 0);
        const terrain::ChunkEntry& e = chunk.entry;
        for (const ChunkVertex& v : vertices(chunk)) {
            for (int a = 0; a < 3; ++a) {
                const double along =
                    glm::dot(glm::dvec3(v.x, v.y, v.z), glm::dvec3(e.axes[3 * a], e.axes[3 * a + 1], e.axes[3 * a + 2]));
                ASSERT_LE(std::abs(along), e.half_extent_m[a]);
            }
        }
        float lowest = 1e9f, highest = -1e9f;
        const std::uint32_t side = terrain::kChunkCells << level;
        for (std::uint32_t j = 0; j <= std::min(side, raster_.rows - 1); ++j)
            for (std::uint32_t i = 0; i <= std::min(side, raster_.columns - 1); ++i) {
                lowest = std::min(lowest, raster_.height_m[raster_.at(i, j)]);
                highest = std::max(highest, raster_.height_m[raster_.at(i, j)]);
            }
        EXPECT_EQ(e.min_height_m, lowest);
        EXPECT_EQ(e.max_height_m, highest);
    }
}

TEST_F(MakeChunk, NormalsAreUnitVectorsThatPointUp) {
    const MadeChunk chunk = make(0, 1, 0);
    const terrain::ChunkEntry& e = chunk.entry;
    for (const ChunkVertex& v : vertices(chunk)) {
        const glm::dvec3 normal(v.normal[0] / 127.0, v.normal[1] / 127.0, v.normal[2] / 127.0);
        EXPECT_NEAR(glm::length(normal), 1, 0.02);
        EXPECT_LT(glm::dot(normal, glm::dvec3(e.axes[6], e.axes[7], e.axes[8])), 0) << "the third axis points down";
    }
}

TEST_F(MakeChunk, ChunksAtTheBorderSayThatTheyReachBeyond) {
    EXPECT_EQ(make(0, 0, 0).entry.flags & terrain::kChunkHasOutside, 0u);
    EXPECT_NE(make(0, 3, 0).entry.flags & terrain::kChunkHasOutside, 0u);
    EXPECT_NE(make(0, 0, 2).entry.flags & terrain::kChunkHasOutside, 0u);
}

TEST_F(MakeChunk, MakesTheSameBytesAgain) {
    const MadeChunk first = make(1, 0, 0);
    (void)make(0, 2, 1);
    EXPECT_EQ(make(1, 0, 0).payload, first.payload) << "the scratch carries nothing over";
}

}  // namespace
}  // namespace tedavis::host_sim
