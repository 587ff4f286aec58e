#include "render_core/terrain/verify_page.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "platform/files/memory_byte_source.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::terrain::test_verify_page {
namespace {

const std::vector<std::uint8_t>& sound_image() {
    static const std::vector<std::uint8_t> bytes = test_support::build_image(test_support::make_rough_raster(150, 90));
    return bytes;
}

struct Verified {
    TdbFailure failure;
    std::uint64_t chunks = 0, expected = 0;
};
Verified verify(const std::vector<std::uint8_t>& image) {
    platform::MemoryByteSource source({image.data(), image.size()});
    std::vector<std::uint8_t> memory(std::size_t{1} << 20);
    base::Arena arena(memory.data(), memory.size());
    const auto database = TerrainDatabase::open(source, arena);
    EXPECT_TRUE(database.ok());
    Verified found;
    found.expected = database.value().header().chunk_count;
    const auto room = std::make_unique<VerifyRoom>();
    for (std::uint32_t page = 0; page < database.value().lattice().page_count() && found.failure.error == TdbError::none; ++page)
        found.failure = verify_page(database.value(), page, *room, found.chunks);
    return found;
}

TEST(VerifyPage, ReadsEveryChunkOfASoundDatabase) {
    const Verified found = verify(sound_image());
    EXPECT_EQ(found.failure.error, TdbError::none);
    EXPECT_EQ(found.chunks, found.expected);
    EXPECT_GT(found.chunks, 15u);
}

TEST(VerifyPage, FindsOneFlippedBitOfEveryPartOfAChunk) {
    ChunkEntry coarse{};
    std::vector<std::uint8_t> image = sound_image();
    test_support::for_entries(image, [&](const ChunkEntry& entry, std::uint64_t) {
        if (entry.attributes.bytes != 0) coarse = entry;
    });
    ASSERT_NE(coarse.attributes.bytes, 0u);
    for (const PartPlace& part : {coarse.payload, coarse.attributes}) {
        image = sound_image();
        image[static_cast<std::size_t>(part.offset) + part.bytes / 2] ^= 4;
        const Verified found = verify(image);
        EXPECT_EQ(found.failure.error, TdbError::chunk_damaged);
        EXPECT_EQ(found.failure.offset, part.offset);
    }
}

/// A right checksum over a vertex that lies nowhere.
TEST(VerifyPage, FindsContentThatCannotBeDrawn) {
    std::vector<std::uint8_t> image = sound_image();
    test_support::for_entries(image, [&](const ChunkEntry& entry, std::uint64_t) {
        for (std::size_t byte = 0; byte < 4; ++byte) image[static_cast<std::size_t>(entry.payload.offset) + byte] = 0xFF;  // NaN
    });
    test_support::sign_chunks(image);
    EXPECT_EQ(verify(image).failure.error, TdbError::chunk_damaged);
}

}  // namespace
}  // namespace tedavis::terrain::test_verify_page
