#include "host_sim/terrain_builder/chunk_summary.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_chunk_summary {
namespace {

using namespace terrain;
using test_support::BuildGround;

Raster mixed_raster() {
    Raster raster = test_support::make_raster(80, 70, [](auto i, auto j) { return 100.0f + i + 2.0f * j; });
    for (std::uint32_t j = 0; j < 33; ++j)
        for (std::uint32_t i = 0; i < 33; ++i) raster.post_class[raster.at(i, j)] = PostClass::void_;
    raster.height_m[raster.at(50, 40)] = 0;
    raster.post_class[raster.at(50, 40)] = PostClass::sea;
    return raster;
}

ChunkEntry entry_of(const BuildGround& ground, std::uint32_t i, std::uint32_t j) {
    ChunkEntry entry{};
    entry.i = i;
    entry.j = j;
    summarise_posts(ground.plan.lattice, ground.all(), entry);
    return entry;
}

TEST(ChunkSummary, SaysHeightsAndClasses) {
    const BuildGround ground(mixed_raster());
    const ChunkEntry voids = entry_of(ground, 0, 0), land = entry_of(ground, 2, 2), coast = entry_of(ground, 1, 1);
    EXPECT_EQ(voids.flags, kChunkHasVoid);
    EXPECT_EQ(voids.min_height_m, 0);
    EXPECT_EQ(voids.max_height_m, 0);
    EXPECT_EQ(land.flags, kChunkHasLand);
    EXPECT_EQ(land.min_height_m, 100 + 64 + 2 * 64);
    EXPECT_EQ(land.max_height_m, 100 + 79 + 2 * 69);
    EXPECT_EQ(coast.flags, kChunkHasVoid | kChunkHasLand | kChunkHasSea) << "its corner post is void";
    EXPECT_EQ(coast.min_height_m, 0);
    EXPECT_EQ(coast.max_height_m, 100 + 64 + 2 * 64);
}

TEST(ChunkSummary, ParentsAddTheirChildrenUp) {
    const BuildGround ground(mixed_raster());
    ChunkEntry parent{};
    parent.level = 1;
    for (const auto& [i, j] : {std::pair{0u, 0u}, {1u, 0u}, {1u, 1u}}) summarise_child(entry_of(ground, i, j), parent);
    EXPECT_EQ(parent.children, 0b1011);
    EXPECT_EQ(parent.flags, kChunkHasVoid | kChunkHasLand | kChunkHasSea);
    EXPECT_EQ(parent.min_height_m, 0);
    EXPECT_EQ(parent.max_height_m, 100 + 64 + 2 * 64);
    ChunkEntry unknown{};
    summarise_child(entry_of(ground, 0, 0), unknown);
    EXPECT_EQ(unknown.min_height_m, 0);
    ChunkEntry high{};
    summarise_child(entry_of(ground, 0, 0), high);
    summarise_child(entry_of(ground, 2, 2), high);
    EXPECT_EQ(high.min_height_m, 100 + 64 + 2 * 64) << "a chunk without heights adds none";
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_summary
