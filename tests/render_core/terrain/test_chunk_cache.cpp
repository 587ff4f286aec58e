#include "render_core/terrain/chunk_cache.hpp"

#include <gtest/gtest.h>

#include "tests/support/built_database.hpp"

namespace tedavis::terrain {
namespace {

struct Cached {
    test_support::BuiltDatabase built{test_support::make_rough_raster(200, 150)};
    std::vector<std::uint8_t> memory;
    base::Arena arena;
    ChunkCache cache;

    explicit Cached(std::uint32_t slots)
        : memory(ChunkCache::bytes_needed(slots, built.database.chunk_count())), arena(memory.data(), memory.size()) {
        EXPECT_TRUE(cache.start(built.database, slots, arena, arena));
    }
};

TEST(ChunkCache, HoldsTheVerticesOfTheFile) {
    Cached c(4);
    const SlotIndex slot = c.cache.acquire(7, 1);
    ASSERT_NE(slot, kNoSlot);
    const std::vector<ChunkVertex> expected = c.built.vertices(7);
    const auto vertices = c.cache.vertices(slot);
    ASSERT_EQ(vertices.size(), expected.size());
    EXPECT_EQ(std::memcmp(vertices.data(), expected.data(), expected.size() * sizeof(ChunkVertex)), 0);
}

TEST(ChunkCache, MakesRoomWithTheOldestThatThisFrameDoesNotNeed) {
    Cached c(3);
    const SlotIndex first = c.cache.acquire(0, 1);
    ASSERT_NE(c.cache.acquire(1, 2), kNoSlot);
    ASSERT_NE(c.cache.acquire(2, 3), kNoSlot);
    EXPECT_EQ(c.cache.acquire(3, 4), first);
    EXPECT_EQ(c.cache.slot(first).chunk, 3u);
    const std::uint64_t loads = c.cache.slot(first).loads;
    EXPECT_EQ(c.cache.acquire(3, 5), first);
    EXPECT_EQ(c.cache.slot(first).loads, loads) << "a resident chunk is not read again";
}

TEST(ChunkCache, RefusesAndCountsWhenTheFrameNeedsEverySlot) {
    Cached c(2);
    EXPECT_NE(c.cache.acquire(0, 9), kNoSlot);
    EXPECT_NE(c.cache.acquire(1, 9), kNoSlot);
    EXPECT_EQ(c.cache.acquire(2, 9), kNoSlot);
    EXPECT_EQ(c.cache.use().refused, 1u);
    EXPECT_EQ(c.cache.use().in_use, 2u);
    EXPECT_EQ(c.cache.failure().error, TdbError::none);
}

TEST(ChunkCache, ADamagedChunkTakesNoSlot) {
    Cached c(2);
    c.built.image[c.built.database.entry(5).offset + 3] ^= 0x10;
    EXPECT_EQ(c.cache.acquire(5, 1), kNoSlot);
    EXPECT_EQ(c.cache.failure().error, TdbError::chunk_damaged);
    EXPECT_EQ(c.cache.failure().offset, c.built.database.entry(5).offset);
    EXPECT_EQ(c.cache.use().in_use, 0u);
    EXPECT_NE(c.cache.acquire(4, 1), kNoSlot);
    EXPECT_NE(c.cache.acquire(6, 1), kNoSlot);
}

TEST(ChunkCache, StartRefusesWhatDoesNotFit) {
    test_support::BuiltDatabase built(test_support::make_rough_raster(70, 70));
    std::vector<std::uint8_t> memory(1000);
    base::Arena arena(memory.data(), memory.size());
    ChunkCache cache;
    EXPECT_FALSE(cache.start(built.database, 2, arena, arena));
    EXPECT_FALSE(cache.start(built.database, 0, arena, arena));
}

}  // namespace
}  // namespace tedavis::terrain
