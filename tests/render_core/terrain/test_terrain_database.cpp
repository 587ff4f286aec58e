#include "render_core/terrain/terrain_database.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_terrain_database {
namespace {

using base::radians;
using test_support::MemoryBytes;
using test_support::TdbSpec;
using test_support::WrittenTdb;

TdbSpec small_spec() {
    TdbSpec spec;
    spec.columns = 70;
    spec.rows = 66;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 500 + 3.0 * i + std::sin(j) * 40; };
    spec.attributes = true;
    return spec;
}

/// Opens, reads every page, every payload and every attribute page.
TdbFailure first_failure(const std::vector<std::uint8_t>& image) {
    std::vector<std::uint8_t> memory(1 << 18), part(kMaxPayloadBytes);
    MemoryBytes bytes(image);
    base::Arena arena(memory.data(), memory.size());
    auto opened = TerrainDatabase::open(bytes, arena);
    if (!opened.ok()) return opened.error();
    const TerrainDatabase& database = opened.value();
    auto page = std::make_unique<DirectoryPage>();
    for (std::uint32_t index = 0; index < database.lattice().page_count(); ++index) {
        if (!database.has_page(index)) continue;
        if (const TdbFailure failure = database.read_page(index, *page); failure.error != TdbError::none) return failure;
        for (const ChunkEntry& entry : page->entries)
            for (const PartPlace& place : {entry.payload, entry.attributes}) {
                if (entry.vertex_count == 0 || place.bytes == 0) continue;
                const TdbFailure failure = database.read_part(place, {part.data(), part.size()});
                if (failure.error != TdbError::none) return failure;
            }
    }
    return {};
}

TEST(TerrainDatabase, HoldsWhatWasWritten) {
    WrittenTdb written(small_spec());
    EXPECT_EQ(first_failure(written.bytes).error, TdbError::none);
    const TerrainDatabase& database = written.database();
    EXPECT_EQ(database.levels(), 3u);
    EXPECT_EQ(database.root_count(), 1u);
    EXPECT_EQ(database.header().columns, 70u);
    EXPECT_EQ(database.lattice().grid_columns(0), 3u);
}

TEST(TerrainDatabase, EveryFlippedBitOfAPartIsFoundWhenItIsRead) {
    const WrittenTdb written(small_spec());
    // Bytes between the parts carry nothing: pages are aligned.
    std::vector<bool> carries(written.bytes.size());
    const auto mark = [&](std::uint64_t offset, std::size_t count) {
        std::fill_n(carries.begin() + static_cast<std::ptrdiff_t>(offset), count, true);
    };
    const FileHeader& h = written.database().header();
    mark(0, sizeof h);
    mark(h.undulation_offset, std::size_t{h.undulation_columns} * h.undulation_rows * sizeof(float));
    mark(h.page_table_offset, h.page_count * sizeof(std::uint64_t));
    for (std::uint32_t index = 0; index < h.page_count; ++index)
        mark(written.database().page_offset(index), sizeof(DirectoryPage));
    for (const ChunkKey& key : written.keys())
        for (const PartPlace& place : {written.entry(key).payload, written.entry(key).attributes})
            mark(place.offset, place.bytes);
    std::vector<std::uint8_t> damaged = written.bytes;
    for (std::size_t position = 0; position < damaged.size(); position += position < sizeof h ? 5 : 1013) {
        if (!carries[position]) continue;
        const auto bit = static_cast<std::uint8_t>(1u << (position % 8));
        damaged[position] ^= bit;
        EXPECT_NE(first_failure(damaged).error, TdbError::none) << "bit at byte " << position;
        damaged[position] ^= bit;
    }
}

TEST(TerrainDatabase, TruncatedForeignAndEmptyFilesAreToldApart) {
    const WrittenTdb written(small_spec());
    std::vector<std::uint8_t> cut(written.bytes.begin(), written.bytes.end() - 1);
    EXPECT_EQ(first_failure(cut).error, TdbError::truncated);
    EXPECT_EQ(first_failure(cut).offset, cut.size());
    EXPECT_EQ(first_failure({}).error, TdbError::not_a_tdb);
    EXPECT_EQ(first_failure(std::vector<std::uint8_t>(1000, 'x')).error, TdbError::not_a_tdb);
    std::vector<std::uint8_t> newer = written.bytes;
    newer[8] = 1;
    EXPECT_EQ(first_failure(newer).error, TdbError::wrong_version);
    EXPECT_EQ(first_failure(newer).offset, 8u);
}

TEST(TerrainDatabase, HeadersThatCannotBeAreRefusedUnderARightChecksum) {
    WrittenTdb written(small_spec());
    const std::vector<std::uint8_t> sound = written.bytes;
    const auto error = [&](const std::function<void(FileHeader&)>& change) {
        written.bytes = sound;
        change(written.header());
        written.sign_header();
        return first_failure(written.bytes).error;
    };
    const float nan = std::nanf("");
    const std::function<void(FileHeader&)> changes[] = {
        [&](FileHeader& h) { h.undulation_west_deg = nan; },
        [&](FileHeader& h) { h.tolerance_m[1] = nan; },
        [&](FileHeader& h) { h.north_deg = nan; },
        [&](FileHeader& h) { h.step_lon_deg = nan; },
        [](FileHeader& h) { h.step_lon_deg = 0; },
        [](FileHeader& h) { h.north_deg = -89.99; },
        [](FileHeader& h) { h.columns = 1u << 31; },
        [](FileHeader& h) { h.rows = 1; },
        [](FileHeader& h) { h.levels = 0; },
        [](FileHeader& h) { h.levels = kMaxLevels + 1; },
        [](FileHeader& h) { h.lattice_flags = kLatticeClosed; },
        [](FileHeader& h) { h.lattice_flags = 8; },
        [](FileHeader& h) { h.page_count += 1; },
        [](FileHeader& h) { h.chunk_count = 1000; },
        [](FileHeader& h) { h.undulation_offset = h.file_bytes - 8; },
        [](FileHeader& h) { h.page_table_offset = ~0ull; },
        [](FileHeader& h) { h.max_height_m = -1; },
        [](FileHeader& h) { std::memset(h.source, 'x', sizeof h.source); },
        [](FileHeader& h) { h.drape_posts = 128; },
        [](FileHeader& h) {
            h.drape_posts = kDrapePosts;
            h.drape_level = static_cast<std::uint16_t>(h.levels);
        },
    };
    EXPECT_EQ(error([](FileHeader&) {}), TdbError::none);
    int n = 0;
    for (const auto& change : changes) {
        EXPECT_EQ(error(change), TdbError::header_damaged) << "change " << n;
        ++n;
    }
}

TEST(TerrainDatabase, PolarAndClosedHeadersMustFitTheEarth) {
    TdbSpec spec = test_support::whole_earth(65, 33);
    spec.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
    WrittenTdb written(spec);
    EXPECT_EQ(first_failure(written.bytes).error, TdbError::none);
    const std::vector<std::uint8_t> sound = written.bytes;
    const auto error = [&](const std::function<void(FileHeader&)>& change) {
        written.bytes = sound;
        change(written.header());
        written.sign_header();
        return first_failure(written.bytes).error;
    };
    EXPECT_EQ(error([](FileHeader& h) { h.step_lon_deg *= 0.9; }), TdbError::header_damaged);
    EXPECT_EQ(error([](FileHeader& h) { h.north_deg = 90; }), TdbError::header_damaged);
    EXPECT_EQ(error([](FileHeader& h) { h.step_lat_deg *= 1.1; }), TdbError::header_damaged);
}

TEST(TerrainDatabase, EntriesThatCannotBeAreRefusedUnderARightChecksum) {
    WrittenTdb written(small_spec());
    const std::vector<std::uint8_t> sound = written.bytes;
    const auto error = [&](const ChunkKey& key, const std::function<void(ChunkEntry&)>& change) {
        written.bytes = sound;
        change(written.entry_in_file(key));
        written.sign_page(key);
        return first_failure(written.bytes).error;
    };
    const float nan = std::nanf("");
    const std::function<void(ChunkEntry&)> changes[] = {
        [&](ChunkEntry& e) { e.above_m = nan; },
        [&](ChunkEntry& e) { e.strip_below_m = nan; },
        [&](ChunkEntry& e) { e.centre_m[2] = std::nan(""); },
        [&](ChunkEntry& e) { e.axes[4] = nan; },
        [](ChunkEntry& e) { e.half_extent_m[0] = -1; },
        [](ChunkEntry& e) { e.bound_m = 0.5f * e.above_m; },
        [](ChunkEntry& e) { e.max_height_m = e.min_height_m - 1; },
        [](ChunkEntry& e) { e.level = 9; },
        [](ChunkEntry& e) { ++e.i; },
        [](ChunkEntry& e) { e.vertex_count = kMaxChunkVertices + 1; },
        [](ChunkEntry& e) { ++e.vertex_count; },
        [](ChunkEntry& e) { e.border_count = static_cast<std::uint16_t>(e.vertex_count + 1); },
        [](ChunkEntry& e) { ++e.triangle_count; },
        [](ChunkEntry& e) { e.strip_count = static_cast<std::uint16_t>(e.triangle_count + 1); },
        [](ChunkEntry& e) { e.payload.bytes -= 2; },
        [](ChunkEntry& e) { e.payload.offset = ~0ull - 10; },
        [](ChunkEntry& e) { e.payload.offset = 0; },
        [](ChunkEntry& e) { e.attributes.bytes = 12; },
        [](ChunkEntry& e) {
            e.drape = {1000, 300, 0};
        },
        [](ChunkEntry& e) { e.flags |= 0x80; },
        [](ChunkEntry& e) { e.flags ^= kChunkRegular; },
        [](ChunkEntry& e) { e.children ^= 1; },
    };
    const ChunkKey fine{0, 0, 0}, coarse{1, 0, 0};
    EXPECT_EQ(error(fine, [](ChunkEntry&) {}), TdbError::none);
    for (const ChunkKey& key : {fine, coarse}) {
        int n = 0;
        for (const auto& change : changes) {
            EXPECT_EQ(error(key, change), TdbError::directory_damaged) << "level " << key.level << ", change " << n;
            ++n;
        }
    }
    EXPECT_EQ(error({1, 1, 1}, [](ChunkEntry& e) { e.children = 15; }), TdbError::directory_damaged)
        << "children beyond the lattice";
}

TEST(TerrainDatabase, APageAtAnotherPagesPlaceIsRefused) {
    TdbSpec spec = small_spec();
    spec.columns = 300;
    spec.rows = 40;
    WrittenTdb written(spec);
    std::swap(written.page({0, 0, 0}), written.page({0, 8, 0}));
    EXPECT_EQ(first_failure(written.bytes).error, TdbError::directory_damaged);
}

TEST(TerrainDatabase, ASmallArenaIsRefusedNotOverrun) {
    WrittenTdb written(small_spec());
    std::vector<std::uint8_t> memory(500);
    base::Arena arena(memory.data(), memory.size());
    const auto opened = TerrainDatabase::open(written.source(), arena);
    ASSERT_FALSE(opened.ok());
    EXPECT_EQ(opened.error().error, TdbError::too_large);
}

TEST(TerrainDatabase, UndulationIsBilinearAndClampedAtThePoles) {
    WrittenTdb written(small_spec());
    for (double latitude = -90; latitude <= 90; latitude += 7.3)
        for (double longitude : {-180.0, -3.2, 179.99})
            EXPECT_NEAR(written.database().undulation(radians(latitude), radians(longitude)).m,
                        WrittenTdb::undulation_m(radians(latitude)), 1e-5);
}

TEST(TerrainDatabase, EveryErrorHasWords) {
    for (int n = 0; n <= static_cast<int>(TdbError::too_many_roots); ++n)
        EXPECT_STRNE(to_string(static_cast<TdbError>(n)), "is unknown");
}

TEST(TerrainDatabase, EveryFailureSaysWhatWhereAndWhatToDo) {
    EXPECT_STREQ(describe({TdbError::not_a_tdb, 0}).c_str(),
                 "is not a terrain database (offset 0); name a file that 'tedavis terrain build' wrote");
    for (int n = 1; n <= static_cast<int>(TdbError::too_many_roots); ++n) {
        const auto error = static_cast<TdbError>(n);
        const auto text = describe({error, 18'446'744'073'709'551'615u});
        EXPECT_EQ(text.view().find(std::string(to_string(error)) + " (offset 18446744073709551615); "), 0u);
        EXPECT_FALSE(text.cut());
    }
}

}  // namespace
}  // namespace tedavis::terrain::test_terrain_database
