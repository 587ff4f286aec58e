#include "render_core/raytrace/stream/block_pool.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::raytrace::test_block_pool {
namespace {

TEST(BlockPool, GivesWhatCameLastAndRefusesWhenEmpty) {
    std::vector<unsigned char> memory(BlockPool::bytes_needed(64, 5));
    base::Arena arena(memory.data(), memory.size());
    BlockPool pool;
    ASSERT_TRUE(pool.start(arena, 64, 5));
    const std::uint32_t* ids = pool.take(5);
    ASSERT_NE(ids, nullptr);
    std::vector<bool> seen(5);
    for (std::uint32_t n = 0; n < 5; ++n) seen[ids[n]] = true;
    EXPECT_EQ(seen, std::vector<bool>(5, true));
    EXPECT_EQ(pool.take(1), nullptr);
    pool.give_back(3);
    pool.give_back(1);
    EXPECT_EQ(*pool.take(1), 1u);
    EXPECT_EQ(pool.take(2), nullptr);
    EXPECT_EQ(*pool.take(1), 3u);
}

TEST(BlockPool, MarksCalls) {
    std::vector<unsigned char> memory(BlockPool::bytes_needed(128, 2));
    base::Arena arena(memory.data(), memory.size());
    BlockPool pool;
    ASSERT_TRUE(pool.start(arena, 128, 2));
    pool.open(1);
    pool.words(1)[100] = call_word(4, 30);
    pool.words(1)[101] = call_word(4, 0);
    pool.mark_call(1, 100);
    pool.mark_call(1, 101);
    EXPECT_EQ(pool.call_bits(1)[0], 0u);
    EXPECT_EQ(pool.call_bits(1)[1], std::uint64_t{3} << 36);
    EXPECT_EQ(pool.block(1).calls, 31u);
    pool.open(1);
    EXPECT_EQ(pool.call_bits(1)[1], 0u);
    EXPECT_EQ(pool.block(1).calls, 0u);
}

TEST(BlockPool, NeedsItsBytes) {
    std::vector<unsigned char> memory(BlockPool::bytes_needed(64, 5) / 2);
    base::Arena arena(memory.data(), memory.size());
    BlockPool pool;
    EXPECT_FALSE(pool.start(arena, 64, 5));
}

}  // namespace
}  // namespace tedavis::raytrace::test_block_pool
