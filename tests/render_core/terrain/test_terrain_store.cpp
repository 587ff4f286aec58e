#include "render_core/terrain/terrain_store.hpp"

#include <gtest/gtest.h>

#include "platform/threads/thread_reader.hpp"
#include "tests/render_core/terrain/started_store.hpp"

namespace tedavis::terrain::test_terrain_store {
namespace {

using test_support::StartedStore;
using test_support::TdbSpec;
using test_support::WrittenTdb;

const WrittenTdb& tdb() {
    static const WrittenTdb written([] {
        TdbSpec spec;
        spec.columns = 260;
        spec.rows = 200;
        spec.levels = 3;  // 3 x 2 roots
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 300.0 + i - j; };
        spec.attributes = true;
        spec.drape_level = 1;
        spec.measured = false;
        return spec;
    }());
    return written;
}

StoreSettings settings(ArrivalMode mode) {
    StoreSettings s;
    s.mode = mode;
    s.payload_slots = 20;
    s.directory_pages = 8;
    s.attribute_slots = 6;
    return s;
}
StoreSettings with_drape(ArrivalMode mode) {
    StoreSettings s = settings(mode);
    s.drape_slots = 5;
    return s;
}

std::vector<WantedChunk> wanted(const std::vector<ChunkKey>& keys) {
    std::vector<WantedChunk> list;
    for (const ChunkKey& key : keys) list.push_back({key, &tdb().entry(key)});
    return list;
}

void frame(TerrainStore& store, const std::vector<ChunkKey>& keys) {
    const std::vector<WantedChunk> list = wanted(keys);
    store.begin_frame();
    store.want({list.data(), list.size()});
}

const std::vector<ChunkKey> kPath = {{2, 0, 0}, {1, 1, 1}, {0, 2, 3}, {0, 3, 3}};

TEST(TerrainStore, RootsAreThereFromTheStart) {
    StartedStore s(tdb().bytes, settings(ArrivalMode::exact));
    ASSERT_EQ(s.failure.error, TdbError::none);
    s.store.begin_frame();
    for (std::uint32_t j = 0; j < 2; ++j)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const SlotIndex slot = s.store.available_slot({2, i, j});
            ASSERT_NE(slot, kNoSlot);
            EXPECT_EQ(key_of(s.store.entry(slot)), (ChunkKey{2, i, j}));
            EXPECT_FALSE(s.store.indices(slot).empty());
        }
    EXPECT_EQ(s.store.available_slot({1, 0, 0}), kNoSlot);
    EXPECT_EQ(s.store.find({0, 8, 6}).state, EntryState::present);
    EXPECT_EQ(s.store.find({0, 9, 6}).state, EntryState::absent);
}

TEST(TerrainStore, ChunksAndTheirAttributePagesArriveWhenReplaySaysSo) {
    StartedStore s(tdb().bytes, settings(ArrivalMode::exact));
    for (int n = 0; n < 2; ++n) {
        frame(s.store, kPath);
        EXPECT_EQ(s.store.available_slot({0, 2, 3}), kNoSlot) << "frame " << n;
        EXPECT_EQ(s.store.pending(), 3u);
    }
    frame(s.store, kPath);
    for (const ChunkKey& key : kPath) {
        const SlotIndex slot = s.store.available_slot(key);
        ASSERT_NE(slot, kNoSlot);
        const auto expected = tdb().vertices(key);
        ASSERT_EQ(s.store.vertices(slot).size(), expected.size());
        EXPECT_EQ(std::memcmp(s.store.vertices(slot).data(), expected.data(), expected.size() * sizeof(ChunkVertex)), 0);
        EXPECT_EQ(s.store.indices(slot).empty(), key.level == 0);
        const ChunkKey owner = TerrainStore::attribute_key(key);
        const SlotIndex page = s.store.attribute_slot(owner);
        ASSERT_NE(page, kNoSlot);
        EXPECT_EQ(s.store.attributes(page).form[5][1], owner.packed() % 251);
        EXPECT_GE(s.store.attribute_generation(page), 1u);
    }
    EXPECT_EQ(s.store.attribute_slot({0, 2, 3}), kNoSlot) << "level 0 has none of its own";
    EXPECT_EQ(s.store.pending(), 0u);
    EXPECT_FALSE(s.store.is_failing());
    EXPECT_FALSE(s.store.is_late());
}

TEST(TerrainStore, DrapePagesArriveAlongWithTheChunksThatHaveOne) {
    StartedStore s(tdb().bytes, with_drape(ArrivalMode::exact));
    for (int n = 0; n < 2; ++n) {
        frame(s.store, kPath);
        EXPECT_EQ(s.store.drape_slot({1, 1, 1}), kNoSlot) << "frame " << n;
    }
    frame(s.store, kPath);
    for (const ChunkKey& key : kPath) {
        const SlotIndex slot = s.store.drape_slot(key);
        ASSERT_EQ(slot != kNoSlot, key.level >= 1);
        if (slot == kNoSlot) continue;
        EXPECT_EQ(s.store.drape(slot).rgba[kDrapePosts * kDrapePosts - 1][3], WrittenTdb::drape_code(key));
        EXPECT_GE(s.store.drape_generation(slot), 1u);
    }
    EXPECT_FALSE(s.store.is_failing());
}

TEST(TerrainStore, WithoutDrapeSlotsNoPageIsRead) {
    StoreSettings without = with_drape(ArrivalMode::exact);
    without.drape_slots = 0;
    StartedStore s(tdb().bytes, without);
    ASSERT_EQ(s.failure.error, TdbError::none);
    EXPECT_EQ(TerrainStore::drape_bytes(without), 0u);
    for (int n = 0; n < 4; ++n) frame(s.store, kPath);
    EXPECT_EQ(s.store.drape_slot({1, 1, 1}), kNoSlot);
    EXPECT_LT(TerrainStore::reader_tickets(without), TerrainStore::reader_tickets(with_drape(ArrivalMode::exact)));
}

TEST(TerrainStore, ADamagedDrapePageIsMissedAndSaid) {
    std::vector<std::uint8_t> bytes = tdb().bytes;
    bytes[static_cast<std::size_t>(tdb().entry({1, 1, 1}).drape.offset) + 777] ^= 1;
    StartedStore s(bytes, with_drape(ArrivalMode::exact));
    for (int n = 0; n < 4; ++n) frame(s.store, kPath);
    EXPECT_EQ(s.store.drape_slot({1, 1, 1}), kNoSlot);
    EXPECT_NE(s.store.drape_slot({2, 0, 0}), kNoSlot);
    EXPECT_NE(s.store.available_slot({1, 1, 1}), kNoSlot) << "the ground is there";
    EXPECT_TRUE(s.store.is_failing());
    EXPECT_EQ(s.store.last_failure().error, TdbError::chunk_damaged);
}

TEST(TerrainStore, WithoutAttributeSlotsNonePageIsRead) {
    StoreSettings without = settings(ArrivalMode::exact);
    without.attribute_slots = 0;
    StartedStore s(tdb().bytes, without);
    ASSERT_EQ(s.failure.error, TdbError::none);
    for (int n = 0; n < 4; ++n) frame(s.store, kPath);
    EXPECT_NE(s.store.available_slot({0, 2, 3}), kNoSlot);
    EXPECT_EQ(s.store.attribute_slot({1, 1, 1}), kNoSlot);
}

TEST(TerrainStore, LiveReadsComeWhenTheyComeAndFailuresAreSaid) {
    StartedStore s(tdb().bytes, settings(ArrivalMode::live));
    ASSERT_EQ(s.failure.error, TdbError::none);
    frame(s.store, kPath);
    frame(s.store, kPath);
    EXPECT_EQ(s.store.available_slot({1, 1, 1}), kNoSlot);
    s.bytes.reader.arrive(1);
    frame(s.store, kPath);
    EXPECT_NE(s.store.available_slot({1, 1, 1}), kNoSlot) << "the most urgent";
    EXPECT_EQ(s.store.available_slot({0, 2, 3}), kNoSlot);
    for (int n = 0; n < 32; ++n) frame(s.store, kPath);
    EXPECT_TRUE(s.store.is_late());
    s.bytes.fails = true;
    s.bytes.reader.arrive(100);
    frame(s.store, kPath);
    EXPECT_FALSE(s.store.is_late());
    EXPECT_TRUE(s.store.is_failing());
    EXPECT_GE(s.store.failures(), 2u);
    EXPECT_EQ(s.store.last_failure().error, TdbError::unreadable);
    EXPECT_NE(s.store.available_slot({1, 1, 1}), kNoSlot) << "what is there stays";
    s.bytes.fails = false;
    s.bytes.reader.at_once = true;
    for (int n = 0; n < 40; ++n) frame(s.store, kPath);
    EXPECT_FALSE(s.store.is_failing());
    EXPECT_NE(s.store.available_slot({0, 3, 3}), kNoSlot);
}

TEST(TerrainStore, LivePagesOfTheDirectoryUseTheReaderToo) {
    StartedStore s(tdb().bytes, settings(ArrivalMode::live));
    s.store.begin_frame();
    EXPECT_EQ(s.store.find({0, 0, 0}).state, EntryState::missing);
    s.bytes.reader.arrive(1);
    EXPECT_EQ(s.store.find({0, 0, 0}).state, EntryState::present);
}

TEST(TerrainStore, ReplayThroughAThreadIsTheSame) {
    StartedStore expected(tdb().bytes, settings(ArrivalMode::exact)), memory(tdb().bytes, settings(ArrivalMode::exact));
    test_support::MemoryBytes bytes(tdb().bytes);
    auto reader = platform::make_thread_reader(bytes, {64, 64, nullptr});
    ASSERT_TRUE(reader.ok());
    base::Arena table(memory.table.data(), memory.table.size()), index(memory.index.data(), memory.index.size()),
        records(memory.records.data(), memory.records.size()), payloads(memory.payloads.data(), memory.payloads.size()),
        attributes(memory.attributes.data(), memory.attributes.size());
    const TerrainDatabase database = TerrainDatabase::open(bytes, table).value();
    TerrainStore threaded;
    ASSERT_EQ(
        threaded.start(database, *reader.value(), settings(ArrivalMode::exact), {index, records, payloads, attributes}).error,
        TdbError::none);
    for (std::uint32_t n = 0; n < 60; ++n) {
        std::vector<ChunkKey> list;
        for (std::uint32_t k = 0; k < 8; ++k) list.push_back({k % 2, (n / 4 + k) % 5, (n / 7 + k / 3) % 4});
        frame(expected.store, list);
        frame(threaded, list);
        for (std::uint32_t j = 0; j < 7; ++j)
            for (std::uint32_t i = 0; i < 9; ++i) {
                const SlotIndex a = expected.store.available_slot({0, i, j}), b = threaded.available_slot({0, i, j});
                ASSERT_EQ(a == kNoSlot, b == kNoSlot) << "frame " << n;
                if (a == kNoSlot) continue;
                const auto from = expected.store.vertices(a), through = threaded.vertices(b);
                ASSERT_EQ(std::memcmp(from.data(), through.data(), from.size() * sizeof(ChunkVertex)), 0);
            }
    }
}

TEST(TerrainStore, RefusesRootsThatDoNotFitAndSmallMemory) {
    StoreSettings few = settings(ArrivalMode::exact);
    few.payload_slots = 6;
    EXPECT_EQ(StartedStore(tdb().bytes, few).failure.error, TdbError::too_many_roots);
    few.payload_slots = 7;
    EXPECT_EQ(StartedStore(tdb().bytes, few).failure.error, TdbError::none);
    StartedStore s(tdb().bytes, settings(ArrivalMode::exact));
    for (int without = 0; without < 4; ++without) {
        std::vector<std::uint8_t> none(16);
        const auto arena = [&](int which, std::vector<std::uint8_t>& memory) {
            return which == without ? base::Arena(none.data(), none.size()) : base::Arena(memory.data(), memory.size());
        };
        base::Arena index = arena(0, s.index), records = arena(1, s.records), payloads = arena(2, s.payloads),
                    attributes = arena(3, s.attributes);
        TerrainStore store;
        EXPECT_EQ(
            store.start(s.database, s.bytes.reader, settings(ArrivalMode::exact), {index, records, payloads, attributes}).error,
            TdbError::too_large)
            << without;
    }
    base::SynchronousReader few_tickets(s.bytes, 10);
    base::Arena index(s.index.data(), s.index.size()), records(s.records.data(), s.records.size()),
        payloads(s.payloads.data(), s.payloads.size()), attributes(s.attributes.data(), s.attributes.size());
    EXPECT_EQ(
        TerrainStore().start(s.database, few_tickets, settings(ArrivalMode::exact), {index, records, payloads, attributes}).error,
        TdbError::too_large);
}

TEST(TerrainStore, PagesFillWhatTheIndexArenaHas) {
    StoreSettings any = settings(ArrivalMode::exact);
    any.directory_pages = 0;
    StartedStore s(tdb().bytes, any);
    EXPECT_EQ(s.failure.error, TdbError::none);
    EXPECT_EQ(s.store.directory().use().capacity, kMaxDirectoryPages);
    base::Arena index(s.index.data(), DirectoryCache::bytes_needed(5) + 100), records(s.records.data(), s.records.size()),
        payloads(s.payloads.data(), s.payloads.size()), attributes(s.attributes.data(), s.attributes.size());
    TerrainStore store;
    EXPECT_EQ(store.start(s.database, s.bytes.reader, any, {index, records, payloads, attributes}).error, TdbError::none);
    EXPECT_EQ(store.directory().use().capacity, 5u);
}

TEST(TerrainStore, ADamagedRootEndsTheStart) {
    std::vector<std::uint8_t> damaged = tdb().bytes;
    damaged[tdb().entry({2, 1, 1}).payload.offset + 5] ^= 8;
    const StartedStore s(damaged, settings(ArrivalMode::exact));
    EXPECT_EQ(s.failure.error, TdbError::chunk_damaged);
    EXPECT_EQ(s.failure.offset, tdb().entry({2, 1, 1}).payload.offset);
}

}  // namespace
}  // namespace tedavis::terrain::test_terrain_store
