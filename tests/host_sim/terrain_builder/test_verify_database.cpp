#include "host_sim/terrain_builder/verify_database.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::host_sim::test_verify_database {
namespace {

using test_support::expect_user_error;

const std::string& sound_image() {
    static const Raster raster = test_support::make_rough_raster(150, 90);
    static const std::vector<std::uint8_t> bytes = test_support::build_image(raster);
    static const std::string image(bytes.begin(), bytes.end());
    return image;
}

void verify(const std::string& path) {
    verify_database(OpenDatabase(path), [](std::uint64_t, std::uint64_t) {});
}

TEST(VerifyDatabase, ASoundOneIsReadToItsEnd) {
    const test_support::TemporaryFolder folder;
    const OpenDatabase open(folder.write("t.tdb", sound_image()));
    std::uint64_t last = 0;
    verify_database(open, [&](std::uint64_t done, std::uint64_t total) {
        EXPECT_GT(done, last);
        last = done;
        EXPECT_EQ(total, open.database().header().page_count);
    });
    EXPECT_EQ(last, open.database().header().page_count);
}

TEST(VerifyDatabase, EveryFlippedBitIsFound) {
    const test_support::TemporaryFolder folder;
    for (std::size_t position = 0; position < sound_image().size(); position += 20011) {
        std::string bytes = sound_image();
        bytes[position] = static_cast<char>(bytes[position] ^ (1 << (position % 8)));
        expect_user_error([&] { verify(folder.write("t.tdb", bytes)); }, "t.tdb: ");
    }
}

TEST(VerifyDatabase, SaysWhereTheDamageIs) {
    const test_support::TemporaryFolder folder;
    std::string bytes = sound_image();
    terrain::ChunkEntry entry{};
    test_support::for_entries(bytes, [&](const terrain::ChunkEntry& e, std::uint64_t) { entry = e; });
    char& byte = bytes[static_cast<std::size_t>(entry.attributes.offset) + 77];
    byte = static_cast<char>(byte ^ 1);
    expect_user_error([&] { verify(folder.write("t.tdb", bytes)); },
                      "t.tdb: has a damaged chunk (offset " + std::to_string(entry.attributes.offset) + "); get a whole copy");
    expect_user_error([&] { verify(folder.file("none.tdb")); }, "none.tdb");
    expect_user_error([&] { verify(folder.write("t.tdb", sound_image().substr(0, 3000))); }, "is shorter than its header says");
}

TEST(VerifyDatabase, LevelsAddUp) {
    const test_support::TemporaryFolder folder;
    const OpenDatabase open(folder.write("t.tdb", sound_image()));
    const std::vector<LevelSummary> levels = summarise_levels(open);
    ASSERT_EQ(levels.size(), open.database().levels());
    EXPECT_EQ(levels[0].chunks, 15u);
    EXPECT_EQ(levels[0].triangles, 2u * 149 * 89);
    std::uint64_t chunks = 0;
    for (std::size_t level = 0; level < levels.size(); ++level) {
        chunks += levels[level].chunks;
        EXPECT_GE(levels[level].worst_bound_m, levels[level].worst_error_m);
    }
    EXPECT_EQ(chunks, open.database().header().chunk_count);
    EXPECT_LT(levels[0].worst_error_m, levels.back().worst_error_m);
}

}  // namespace
}  // namespace tedavis::host_sim::test_verify_database
