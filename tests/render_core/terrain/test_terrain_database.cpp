#include "render_core/terrain/terrain_database.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/built_database.hpp"

namespace tedavis::terrain {
namespace {

using base::radians;
using test_support::BuiltDatabase;

TdbFailure first_failure(const std::vector<std::uint8_t>& image) {
    std::vector<std::uint8_t> memory(1 << 22), payload(1 << 20);
    test_support::MemoryBytes bytes(image);
    base::Arena arena(memory.data(), memory.size());
    auto opened = TerrainDatabase::open(bytes, arena);
    if (!opened.ok()) return opened.error();
    for (ChunkIndex chunk = 0; chunk < opened.value().chunk_count(); ++chunk) {
        const TdbFailure failure = opened.value().read_chunk(chunk, {payload.data(), payload.size()});
        if (failure.error != TdbError::none) return failure;
    }
    return {};
}

TEST(TerrainDatabase, EveryFlippedBitIsFound) {
    const BuiltDatabase built(test_support::make_rough_raster(70, 66));
    ASSERT_EQ(first_failure(built.image).error, TdbError::none);
    for (std::size_t position = 0; position < built.image.size(); position += 97) {
        std::vector<std::uint8_t> damaged = built.image;
        damaged[position] ^= static_cast<std::uint8_t>(1u << (position % 8));
        EXPECT_NE(first_failure(damaged).error, TdbError::none) << "bit at byte " << position;
    }
}

TEST(TerrainDatabase, TruncatedForeignAndEmptyFilesAreToldApart) {
    const BuiltDatabase built(test_support::make_rough_raster(70, 66));
    std::vector<std::uint8_t> cut(built.image.begin(), built.image.end() - 1);
    EXPECT_EQ(first_failure(cut).error, TdbError::truncated);
    EXPECT_EQ(first_failure({}).error, TdbError::not_a_tdb);
    EXPECT_EQ(first_failure(std::vector<std::uint8_t>(1000, 'x')).error, TdbError::not_a_tdb);
    std::vector<std::uint8_t> newer = built.image;
    newer[8] = 99;
    EXPECT_EQ(first_failure(newer).error, TdbError::wrong_version);
}

/// The image with a changed header and first entry, signed anew so that no checksum tells.
template <class Change>
std::vector<std::uint8_t> forged(std::vector<std::uint8_t> image, Change change) {
    FileHeader h;
    std::memcpy(&h, image.data(), sizeof h);
    std::vector<ChunkEntry> entries(h.chunk_count);
    std::memcpy(entries.data(), image.data() + sizeof h, entries.size() * sizeof(ChunkEntry));
    change(h, entries.front());
    h.directory_crc = base::crc32(entries.data(), entries.size() * sizeof(ChunkEntry));
    h.header_crc = base::crc32(&h, offsetof(FileHeader, header_crc));
    std::memcpy(image.data(), &h, sizeof h);
    std::memcpy(image.data() + sizeof h, entries.data(), entries.size() * sizeof(ChunkEntry));
    return image;
}

TEST(TerrainDatabase, ValuesThatCannotBeAreRefusedUnderARightChecksum) {
    const BuiltDatabase built(test_support::make_rough_raster(70, 66));
    const auto failure = [&](auto change) { return first_failure(forged(built.image, change)).error; };
    const float nan = std::nanf("");
    EXPECT_EQ(failure([](FileHeader&, ChunkEntry&) {}), TdbError::none);
    EXPECT_EQ(failure([&](FileHeader& h, ChunkEntry&) { h.undulation_west_deg = nan; }), TdbError::header_damaged);
    EXPECT_EQ(failure([&](FileHeader& h, ChunkEntry&) { h.tolerance_m[1] = nan; }), TdbError::header_damaged);
    EXPECT_EQ(failure([&](FileHeader& h, ChunkEntry&) { std::memset(h.source, 'x', sizeof h.source); }),
              TdbError::header_damaged);
    EXPECT_EQ(failure([&](FileHeader&, ChunkEntry& e) { e.above_m = nan; }), TdbError::directory_damaged);
    EXPECT_EQ(failure([&](FileHeader&, ChunkEntry& e) { e.centre_m[2] = nan; }), TdbError::directory_damaged);
    EXPECT_EQ(failure([&](FileHeader&, ChunkEntry& e) { e.half_extent_m[0] = -1; }), TdbError::directory_damaged);
    EXPECT_EQ(failure([&](FileHeader&, ChunkEntry& e) { e.level = 9; }), TdbError::directory_damaged);
    EXPECT_EQ(failure([&](FileHeader&, ChunkEntry& e) { ++e.i; }), TdbError::directory_damaged) << "another chunk's place";
}

TEST(TerrainDatabase, ASmallArenaIsRefusedNotOverrun) {
    const BuiltDatabase built(test_support::make_rough_raster(70, 66));
    std::vector<std::uint8_t> memory(500);
    test_support::MemoryBytes bytes(built.image);
    base::Arena arena(memory.data(), memory.size());
    const auto opened = TerrainDatabase::open(bytes, arena);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().error, TdbError::too_large);
}

TEST(TerrainDatabase, ParentsAndChildrenAgree) {
    const BuiltDatabase built(test_support::make_rough_raster(200, 150));
    const TerrainDatabase& db = built.database;
    for (ChunkIndex chunk = 0; chunk < db.chunk_count(); ++chunk) {
        EXPECT_EQ(db.at(db.entry(chunk).level, db.entry(chunk).i, db.entry(chunk).j), chunk);
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            const ChunkIndex child = db.child(chunk, quadrant);
            if (child != kNoChunk) {
                EXPECT_EQ(db.parent(child), chunk);
            }
        }
    }
    EXPECT_EQ(db.at(0, -1, 0), kNoChunk);
    EXPECT_EQ(db.at(db.levels(), 0, 0), kNoChunk);
}

TEST(TerrainDatabase, UndulationIsThatOfTheWorldGrid) {
    const BuiltDatabase built(test_support::make_rough_raster(600, 500));
    const host_sim::GeoidEgm96 world = host_sim::GeoidEgm96::installed();
    for (double latitude = 46.72; latitude < 47.1; latitude += 0.07)
        for (double longitude = 9.61; longitude < 10.09; longitude += 0.06)
            EXPECT_NEAR(built.database.undulation(radians(latitude), radians(longitude)).m,
                        world.undulation(radians(latitude), radians(longitude)).m, 1e-4);
}

TEST(TerrainDatabase, LatticePointsAcrossTheAntimeridian) {
    const BuiltDatabase built(test_support::make_raster(
        101, 81, [](std::uint32_t, std::uint32_t) { return 10.0f; }, 179.96, 20.0));
    const auto west = built.database.lattice_point(radians(19.99), radians(179.97));
    const auto east = built.database.lattice_point(radians(19.99), radians(-179.97));
    EXPECT_TRUE(west.inside);
    EXPECT_TRUE(east.inside);
    EXPECT_NEAR(east.i - west.i, 0.06 * 1200, 1e-6);
    EXPECT_FALSE(built.database.lattice_point(radians(19.99), radians(-179.8)).inside);
}

}  // namespace
}  // namespace tedavis::terrain
