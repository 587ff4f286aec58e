#include "render_core/terrain/part_cache.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <set>

#include "render_core/terrain/chunk_payload.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_part_cache {
namespace {

using test_support::FlakyBytes;
using test_support::TdbSpec;
using test_support::WrittenTdb;

constexpr std::uint32_t kColumns = 12, kRows = 6;  // chunks of level 0

WrittenTdb& tdb() {
    static WrittenTdb written([] {
        TdbSpec spec;
        spec.columns = kColumns * kChunkCells + 1;
        spec.rows = kRows * kChunkCells + 1;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 100.0 + i + 2 * j; };
        spec.measured = false;
        return spec;
    }());
    return written;
}

ChunkKey chunk(std::uint32_t n) { return {0, n % kColumns, n / kColumns}; }

struct Cache {
    explicit Cache(ArrivalMode mode, std::uint32_t slots) {
        settings.slots = slots;
        settings.slot_bytes = kMaxPayloadBytes;
        settings.part = &ChunkEntry::payload;
        settings.holds = &payload_holds;
        settings.mode = mode;
        settings.arrival_frames = 2;
        settings.window_frames = 5;
        settings.max_in_flight = 3;
        settings.retry_frames = 4;
        settings.late_frames = 6;
        settings.first_ticket = 7;
    }
    void start() {
        records.resize(PartCache::record_bytes(settings));
        parts.resize(PartCache::part_bytes(settings));
        base::Arena record_arena(records.data(), records.size()), part_arena(parts.data(), parts.size());
        base::Arena table_arena(table.data(), table.size());
        database = TerrainDatabase::open(bytes, table_arena).value();
        ASSERT_TRUE(cache.start(database, bytes.reader, settings, record_arena, part_arena));
    }
    void frame(const std::vector<std::uint32_t>& wanted) {
        cache.begin_frame();
        std::vector<WantedChunk> list;
        for (const std::uint32_t n : wanted) list.push_back({chunk(n), &tdb().entry(chunk(n))});
        cache.want({list.data(), list.size()});
    }
    std::set<std::uint32_t> available() const {
        std::set<std::uint32_t> found;
        for (std::uint32_t n = 0; n < kColumns * kRows; ++n)
            if (cache.slot_of(chunk(n)) != kNoSlot) found.insert(n);
        return found;
    }
    /// Every available chunk's slot holds that chunk's bytes.
    bool content_is_right() const {
        for (const std::uint32_t n : available()) {
            const SlotIndex slot = cache.slot_of(chunk(n));
            const PartPlace& place = tdb().entry(chunk(n)).payload;
            if (cache.entry(slot).payload.offset != place.offset ||
                std::memcmp(cache.bytes(slot).data(), tdb().bytes.data() + place.offset, place.bytes) != 0)
                return false;
        }
        return true;
    }
    FlakyBytes bytes{tdb().bytes};
    PartCacheSettings settings;
    std::vector<std::uint8_t> records, parts, table = std::vector<std::uint8_t>(1 << 16);
    TerrainDatabase database;
    PartCache cache;
};

using Lists = std::vector<std::vector<std::uint32_t>>;

Lists random_lists(int frames, std::uint32_t most, unsigned seed) {
    std::mt19937 random(seed);
    Lists lists;
    std::uint32_t centre = 0;
    for (int n = 0; n < frames; ++n) {
        if (random() % 6 == 0) centre = random() % (kColumns * kRows);  // a jump
        std::vector<std::uint32_t> list;
        for (std::uint32_t k = random() % (most + 1); k > 0; --k)
            list.push_back((centre + random() % 14) % (kColumns * kRows));  // twice the same, at times
        lists.push_back(list);
    }
    return lists;
}

/// The rule of the header, word by word.
std::set<std::uint32_t> model(const Lists& lists, std::size_t now, std::size_t slots, std::size_t arrival, std::size_t window) {
    std::vector<std::vector<std::uint32_t>> kept(lists.size());
    // A list counts as far as it could claim slots when it was new.
    for (std::size_t n = 0; n < lists.size(); ++n)
        for (const std::uint32_t key : lists[n])
            if (kept[n].size() < slots && std::find(kept[n].begin(), kept[n].end(), key) == kept[n].end()) kept[n].push_back(key);
    std::set<std::uint32_t> claimed, available;
    for (std::size_t age = 0; age <= window && age <= now; ++age)
        for (const std::uint32_t key : kept[now - age]) {
            if (claimed.size() < slots) claimed.insert(key);
            if (claimed.count(key) != 0 && age >= arrival) available.insert(key);
        }
    return available;
}

TEST(PartCache, WhatIsAvailableInReplayFollowsTheRule) {
    for (const std::uint32_t slots : {5u, 9u, 40u}) {
        Cache c(ArrivalMode::exact, slots);
        c.start();
        const Lists lists = random_lists(150, 16, slots);
        for (std::size_t n = 0; n < lists.size(); ++n) {
            c.frame(lists[n]);
            ASSERT_EQ(c.available(), model(lists, n, slots, 2, 5)) << "frame " << n << ", " << slots << " slots";
            ASSERT_TRUE(c.content_is_right());
            ASSERT_LE(c.cache.use().in_use, slots);
        }
        EXPECT_EQ(c.cache.failures(), 0u);
    }
}

TEST(PartCache, AReplayThatStartsAWindowEarlierHasTheSame) {
    const Lists lists = random_lists(60, 14, 3);
    Cache whole(ArrivalMode::exact, 9);
    whole.start();
    for (std::size_t n = 0; n < lists.size(); ++n) {
        whole.frame(lists[n]);
        if (n < 5 || n % 7 != 0) continue;
        Cache late(ArrivalMode::exact, 9);
        late.start();
        for (std::size_t k = n - 5; k <= n; ++k) late.frame(lists[k]);
        EXPECT_EQ(late.available(), whole.available()) << "frame " << n;
    }
}

TEST(PartCache, ReplayDoesNotDependOnWhenReadsHappen) {
    const Lists lists = random_lists(60, 14, 4);
    Cache lazy(ArrivalMode::exact, 12), eager(ArrivalMode::exact, 12), refused(ArrivalMode::exact, 12);
    eager.bytes.reader.at_once = true;
    refused.bytes.reader.is_full = true;
    for (Cache* c : {&lazy, &eager, &refused}) c->start();
    for (const auto& list : lists) {
        for (Cache* c : {&lazy, &eager, &refused}) c->frame(list);
        ASSERT_EQ(lazy.available(), eager.available());
        ASSERT_EQ(lazy.available(), refused.available());
    }
}

TEST(PartCache, LiveSlotsGoToTheMostUrgentAndKeepWhatIsWanted) {
    Cache c(ArrivalMode::live, 5);
    c.bytes.reader.at_once = true;
    c.start();
    c.frame({1, 2, 3, 4, 5, 6, 7});
    EXPECT_TRUE(c.available().empty()) << "read, but not looked at before the next frame";
    EXPECT_EQ(c.cache.pending(), 7u);
    c.frame({1, 2, 3, 4, 5, 6, 7});
    EXPECT_EQ(c.available(), (std::set<std::uint32_t>{1, 2, 3})) << "three at once, most urgent first";
    c.frame({1, 2, 3, 4, 5, 6, 7});
    c.frame({1, 2, 3, 4, 5, 6, 7});
    EXPECT_EQ(c.available(), (std::set<std::uint32_t>{1, 2, 3, 4, 5})) << "the rest finds no slot";
    EXPECT_EQ(c.cache.pending(), 2u);
    for (int n = 0; n < 3; ++n) c.frame({9, 2, 5});
    EXPECT_EQ(c.available().count(9), 1u);
    EXPECT_EQ(c.available().count(2), 1u);
    EXPECT_EQ(c.available().count(5), 1u);
    EXPECT_EQ(c.cache.pending(), 0u);
    EXPECT_TRUE(c.content_is_right());
}

TEST(PartCache, ALiveSlotBeingReadIsNotGivenAway) {
    Cache c(ArrivalMode::live, 3);
    c.start();
    c.frame({1, 2});
    c.frame({3, 4});
    EXPECT_EQ(c.bytes.reader.waiting(), 3u) << "one slot was left";
    c.bytes.reader.arrive(3);
    c.frame({3, 4});
    c.bytes.reader.arrive(3);
    c.frame({3, 4});
    EXPECT_EQ(c.available().count(3), 1u);
    EXPECT_EQ(c.available().count(4), 1u);
    EXPECT_TRUE(c.content_is_right());
}

TEST(PartCache, ASlowDiskIsLateAndAFailingOneIsTriedAgain) {
    Cache c(ArrivalMode::live, 4);
    c.start();
    for (int n = 0; n < 7; ++n) c.frame({1});
    EXPECT_EQ(c.cache.late(), 0u);
    c.frame({1});
    EXPECT_EQ(c.cache.late(), 1u);
    c.bytes.fails = true;
    c.bytes.reader.arrive(1);
    c.frame({1});
    EXPECT_EQ(c.cache.late(), 0u);
    EXPECT_EQ(c.cache.failing(), 1u);
    EXPECT_EQ(c.cache.failures(), 1u);
    EXPECT_EQ(c.cache.last_failure().error, TdbError::unreadable);
    EXPECT_EQ(c.cache.last_failure().offset, tdb().entry(chunk(1)).payload.offset);
    c.bytes.fails = false;
    c.bytes.reader.at_once = true;
    for (int n = 0; n < 6; ++n) c.frame({1});
    EXPECT_EQ(c.available().count(1), 1u);
    EXPECT_EQ(c.cache.failing(), 0u);
    EXPECT_EQ(c.cache.failures(), 1u) << "not tried before its time";
}

TEST(PartCache, DamagedAndImpossibleContentIsNeverAvailable) {
    for (const ArrivalMode mode : {ArrivalMode::exact, ArrivalMode::live}) {
        Cache c(mode, 6);
        c.bytes.reader.at_once = true;
        c.start();
        const PartPlace first = tdb().entry(chunk(1)).payload;
        c.bytes.content[first.offset + 20] ^= 1;
        for (int n = 0; n < 4; ++n) c.frame({1, 2});
        EXPECT_EQ(c.available(), (std::set<std::uint32_t>{2}));
        EXPECT_EQ(c.cache.last_failure().error, TdbError::chunk_damaged);
    }
    Cache c(ArrivalMode::exact, 6);
    c.settings.holds = [](const Lattice&, const ChunkEntry&, base::Span<const std::uint8_t>) { return false; };
    c.start();
    for (int n = 0; n < 4; ++n) c.frame({1});
    EXPECT_TRUE(c.available().empty());
}

TEST(PartCache, GenerationsTellWhenASlotHasOtherContent) {
    Cache c(ArrivalMode::live, 2);
    c.bytes.reader.at_once = true;
    c.start();
    c.frame({1});
    c.frame({1});
    const SlotIndex slot = c.cache.slot_of(chunk(1));
    const std::uint32_t first = c.cache.generation(slot);
    for (int n = 0; n < 3; ++n) c.frame({1});
    EXPECT_EQ(c.cache.generation(slot), first);
    for (int n = 0; n < 4; ++n) c.frame({2, 3});
    EXPECT_NE(c.cache.generation(slot), first);
}

TEST(PartCache, PinnedPartsStay) {
    Cache c(ArrivalMode::exact, 4);
    c.start();
    ASSERT_EQ(c.cache.pin({chunk(20), &tdb().entry(chunk(20))}).error, TdbError::none);
    const Lists lists = random_lists(40, 12, 9);
    for (const auto& list : lists) {
        c.frame(list);
        ASSERT_EQ(c.available().count(20), 1u);
        ASSERT_LE(c.cache.use().in_use, 4u);
    }
    EXPECT_TRUE(c.content_is_right());
    Cache full(ArrivalMode::exact, 2);
    full.start();
    ASSERT_EQ(full.cache.pin({chunk(1), &tdb().entry(chunk(1))}).error, TdbError::none);
    EXPECT_EQ(full.cache.pin({chunk(2), &tdb().entry(chunk(2))}).error, TdbError::too_many_roots);
}

TEST(PartCache, RefusesSmallArenasAndFewTickets) {
    Cache c(ArrivalMode::exact, 4);
    c.start();
    std::vector<std::uint8_t> memory(1000);
    base::Arena small(memory.data(), memory.size()), records(c.records.data(), c.records.size()),
        parts(c.parts.data(), c.parts.size());
    EXPECT_FALSE(PartCache().start(c.database, c.bytes.reader, c.settings, small, parts));
    EXPECT_FALSE(PartCache().start(c.database, c.bytes.reader, c.settings, records, small));
    base::SynchronousReader few(c.bytes, 10);
    base::Arena again(c.records.data(), c.records.size()), parts_again(c.parts.data(), c.parts.size());
    EXPECT_FALSE(PartCache().start(c.database, few, c.settings, again, parts_again)) << "7 + 4 tickets";
}

}  // namespace
}  // namespace tedavis::terrain::test_part_cache
