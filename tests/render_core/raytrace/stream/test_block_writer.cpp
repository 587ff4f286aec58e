#include "render_core/raytrace/stream/block_writer.hpp"

#include "tests/render_core/raytrace/stream/passes_by_hand.hpp"
#include "tests/render_core/raytrace/stream/stream_program.hpp"

namespace tedavis::raytrace::test_block_writer {
namespace {

using Tokens = std::vector<Token>;

struct Writing {
    std::vector<unsigned char> memory = std::vector<unsigned char>(BlockPool::bytes_needed(64, 100));
    base::Arena arena{memory.data(), memory.size()};
    BlockPool pool;

    Writing() { EXPECT_TRUE(pool.start(arena, 64, 100)); }
    Tokens tokens(std::uint32_t first, std::uint32_t blocks) const {
        Tokens all;
        test_support::append_blocks(pool, first, blocks, all);
        return all;
    }
};

/// 300 words of which every seventh is a call, as a task gives them.
void write_sevenths(BlockWriter& writer, Tokens& expected) {
    std::vector<std::uint32_t> words;
    std::vector<std::uint16_t> places;
    for (std::uint32_t n = 0; n < 300; ++n) {
        words.push_back(n % 7 == 0 ? call_word(2, 1 + n % 5) : n);
        expected.push_back({words.back(), n % 7 == 0});
        if (n % 7 == 0) places.push_back(static_cast<std::uint16_t>(1000 + n));
    }
    writer.write(words.data(), 300, places.data(), static_cast<std::uint32_t>(places.size()), 1000);
}

TEST(BlockWriter, FillsBlocksToTheirEnd) {
    Writing w;
    const std::uint32_t* ids = w.pool.take(20);
    BlockWriter writer(w.pool, {ids, 20, 0, 0});
    Tokens expected;
    write_sevenths(writer, expected);
    write_sevenths(writer, expected);
    writer.finish();
    EXPECT_EQ(writer.words(), 600u);
    EXPECT_EQ(writer.blocks(), 10u);
    EXPECT_EQ(w.tokens(ids[0], 10), expected);
    EXPECT_EQ(w.pool.block(ids[9]).next, kNoBlock);
}

TEST(BlockWriter, EndsSomeBlocksEarly) {
    Writing w;
    const std::uint32_t* ids = w.pool.take(20);
    BlockWriter writer(w.pool, {ids, 20, 3, 10});
    Tokens expected;
    write_sevenths(writer, expected);
    writer.finish();
    EXPECT_EQ(w.tokens(ids[0], writer.blocks()), expected);
    for (std::uint32_t n = 0; n < 3; ++n) {
        EXPECT_LT(w.pool.block(ids[n]).words, 64u);
        EXPECT_GE(w.pool.block(ids[n]).calls, 10u);
    }
    EXPECT_EQ(w.pool.block(ids[3]).words, 64u);
}

TEST(BlockWriter, CopiesFromAnyPlace) {
    Writing w;
    const std::uint32_t* source = w.pool.take(10);
    BlockWriter first(w.pool, {source, 10, 0, 0});
    Tokens all;
    write_sevenths(first, all);
    first.finish();
    for (const std::uint32_t early : {0u, 4u}) {
        for (const std::uint32_t from : {0u, 1u, 63u, 64u, 130u}) {
            const std::uint32_t* ids = w.pool.take(12);
            ASSERT_NE(ids, nullptr);
            BlockWriter writer(w.pool, {ids, 12, early, 9});
            BlockCursor cursor(w.pool, source[0]);
            cursor.skip(from);
            const std::uint32_t word = 77;
            writer.write(&word, 1, nullptr, 0, 0);
            writer.copy(cursor, 150);
            writer.copy(cursor, 10);
            writer.finish();
            Tokens expected = {literal(77)};
            expected.insert(expected.end(), all.begin() + from, all.begin() + from + 160);
            EXPECT_EQ(w.tokens(ids[0], writer.blocks()), expected) << from;
            for (std::uint32_t n = 0; n < 12; ++n) w.pool.give_back(ids[n]);
        }
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_block_writer
