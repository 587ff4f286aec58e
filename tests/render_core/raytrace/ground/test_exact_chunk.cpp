#include "render_core/raytrace/ground/exact_chunk.hpp"

#include <gtest/gtest.h>

#include "tests/support/terrain/ground_files.hpp"

namespace tedavis::raytrace::test_exact_chunk {
namespace {

using terrain::TdbError;

TEST(ExactChunk, IsReadWholeOrNotAtAll) {
    test_support::OpenedGround ground(test_support::rough_file(100, 100));
    alignas(terrain::ChunkVertex) std::uint8_t payload[kExactChunkBytes];
    const terrain::ChunkEntry& entry = ground.tdb.entry({0, 1, 1});
    ASSERT_EQ(read_exact_chunk(ground.database, entry, payload).error, TdbError::none);
    const auto stored = ground.tdb.vertices({0, 1, 1});
    EXPECT_EQ(std::memcmp(payload, stored.data(), entry.payload.bytes), 0);

    EXPECT_EQ(read_exact_chunk(ground.database, entry, base::Span<std::uint8_t>(payload, 100)).error, TdbError::chunk_damaged);
    terrain::ChunkEntry irregular = entry;
    irregular.flags = static_cast<std::uint8_t>(irregular.flags & ~terrain::kChunkRegular);
    EXPECT_EQ(read_exact_chunk(ground.database, irregular, payload).error, TdbError::chunk_damaged);
    ground.bytes.content[entry.payload.offset + 50] ^= 4;
    EXPECT_EQ(read_exact_chunk(ground.database, entry, payload).error, TdbError::chunk_damaged);
    EXPECT_EQ(read_exact_chunk(ground.database, entry, payload).offset, entry.payload.offset);
    ground.bytes.fails = true;
    EXPECT_EQ(read_exact_chunk(ground.database, entry, payload).error, TdbError::unreadable);
}

}  // namespace
}  // namespace tedavis::raytrace::test_exact_chunk
