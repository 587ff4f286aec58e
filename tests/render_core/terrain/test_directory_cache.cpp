#include "render_core/terrain/directory_cache.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_directory_cache {
namespace {

using test_support::FlakyBytes;
using test_support::TdbSpec;
using test_support::WrittenTdb;

/// 32 x 16 chunks at level 0: eight pages, and one each of the levels above.
WrittenTdb& wide() {
    static WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = 1025;
        spec.rows = 513;
        spec.height_m = [](std::uint32_t, std::uint32_t) { return 100.0; };
        spec.measured = false;
        return spec;
    }());
    return tdb;
}

struct Directory {
    Directory(ArrivalMode mode, std::uint32_t pages) : memory(DirectoryCache::bytes_needed(pages)) {
        std::vector<std::uint8_t>& table = table_memory;
        base::Arena table_arena(table.data(), table.size());
        database = TerrainDatabase::open(bytes, table_arena).value();
        base::Arena arena(memory.data(), memory.size());
        DirectorySettings settings;
        settings.pages = pages;
        settings.mode = mode;
        settings.retry_frames = 5;
        failure = cache.start(database, &bytes.reader, settings, arena);
    }
    EntryState state(const ChunkKey& key) { return cache.find(key).state; }

    FlakyBytes bytes{wide().bytes};
    std::vector<std::uint8_t> table_memory = std::vector<std::uint8_t>(1 << 16);
    std::vector<std::uint8_t> memory;
    TerrainDatabase database;
    DirectoryCache cache;
    TdbFailure failure;
};

TEST(DirectoryCache, FindsEveryEntryAndNoOther) {
    Directory d(ArrivalMode::exact, 4);
    ASSERT_EQ(d.failure.error, TdbError::none);
    for (const ChunkKey& key : wide().keys()) {
        d.cache.begin_frame();
        const FoundEntry found = d.cache.find(key);
        ASSERT_EQ(found.state, EntryState::present);
        EXPECT_EQ(key_of(*found.entry), key);
        EXPECT_EQ(found.entry->payload.offset, wide().entry(key).payload.offset);
    }
    EXPECT_EQ(d.state({0, 32, 0}), EntryState::absent);
    EXPECT_EQ(d.state({9, 0, 0}), EntryState::absent);
    EXPECT_EQ(d.state(kNoChunk), EntryState::absent);
    EXPECT_LE(d.cache.use().high_water, 4u);
}

TEST(DirectoryCache, APageOfThisFrameStaysAndTheRestIsMissing) {
    Directory d(ArrivalMode::exact, 3);  // one is the top level's
    const FoundEntry first = d.cache.find({0, 0, 0});
    EXPECT_EQ(d.state({0, 8, 0}), EntryState::present);
    EXPECT_EQ(d.state({0, 16, 0}), EntryState::missing) << "no room in this frame";
    EXPECT_EQ(d.cache.use().refused, 1u);
    EXPECT_EQ(d.cache.find({0, 0, 0}).entry, first.entry);
    EXPECT_EQ(first.entry->i, 0u);
    EXPECT_EQ(d.state({d.database.top_level(), 0, 0}), EntryState::present);
    d.cache.begin_frame();
    EXPECT_EQ(d.state({0, 16, 0}), EntryState::present);
}

TEST(DirectoryCache, PagesAreReadOnceAsLongAsTheyAreUsed) {
    Directory d(ArrivalMode::exact, 4);
    for (int frame = 0; frame < 20; ++frame) {
        d.cache.begin_frame();
        EXPECT_EQ(d.state({0, 0, 0}), EntryState::present);
        EXPECT_EQ(d.state({0, 8, 0}), EntryState::present);
        EXPECT_EQ(d.state({0, 16 + 8 * (frame % 2u), 0}), EntryState::present);
    }
    // Table, grid, header and the top page; then the two and one a frame.
    EXPECT_EQ(d.bytes.reads, 4 + 2 + 20);
}

TEST(DirectoryCache, LivePagesAreMissingUntilTheyArrive) {
    Directory d(ArrivalMode::live, 6);
    ASSERT_EQ(d.failure.error, TdbError::none);
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing);
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing) << "the reader has not come to it";
    d.bytes.reader.arrive(1);
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::present);
    EXPECT_EQ(d.cache.failing(), 0u);
}

TEST(DirectoryCache, AFullQueueIsAskedAgain) {
    Directory d(ArrivalMode::live, 6);
    d.bytes.reader.is_full = true;
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing);
    d.bytes.reader.is_full = false;
    d.cache.begin_frame();
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing);
    d.bytes.reader.arrive(1);
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::present);
}

TEST(DirectoryCache, FailuresAreCountedAndTriedAgain) {
    for (const ArrivalMode mode : {ArrivalMode::exact, ArrivalMode::live}) {
        Directory d(mode, 6);
        d.bytes.fails = true;
        d.bytes.reader.at_once = true;
        EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing);
        EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing);
        EXPECT_EQ(d.cache.failing(), 1u);
        EXPECT_EQ(d.cache.failures(), 1u) << "not tried twice a frame";
        EXPECT_EQ(d.cache.last_failure().error, TdbError::unreadable);
        d.bytes.fails = false;
        for (int frame = 0; frame < 4; ++frame) d.cache.begin_frame();
        EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing) << "not yet";
        d.cache.begin_frame();
        (void)d.cache.find({0, 0, 0});
        EXPECT_EQ(d.state({0, 0, 0}), EntryState::present);
        EXPECT_EQ(d.cache.failing(), 0u);
    }
}

TEST(DirectoryCache, ADamagedPageIsMissingNotBelieved) {
    Directory d(ArrivalMode::exact, 6);
    d.bytes.content[d.database.page_offset(0) + 100] ^= 1;
    EXPECT_EQ(d.state({0, 0, 0}), EntryState::missing);
    EXPECT_EQ(d.cache.last_failure().error, TdbError::directory_damaged);
    EXPECT_EQ(d.state({0, 8, 0}), EntryState::present);
}

TEST(DirectoryCache, RefusesWhatDoesNotFitAndADamagedTop) {
    EXPECT_EQ(Directory(ArrivalMode::exact, 1).failure.error, TdbError::too_large);
    Directory d(ArrivalMode::exact, 4);
    d.bytes.content[d.database.page_offset(d.database.lattice().page_index({d.database.top_level(), 0, 0})) + 50] ^= 1;
    base::Arena arena(d.memory.data(), d.memory.size());
    DirectorySettings settings;
    settings.pages = 4;
    EXPECT_EQ(DirectoryCache().start(d.database, nullptr, settings, arena).error, TdbError::directory_damaged);
    base::Arena small(d.memory.data(), 1000);
    EXPECT_EQ(DirectoryCache().start(d.database, nullptr, settings, small).error, TdbError::too_large);
}

}  // namespace
}  // namespace tedavis::terrain::test_directory_cache
