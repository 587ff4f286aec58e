#include "render_core/raytrace/paged/chunk_slots.hpp"

#include <gtest/gtest.h>

#include "tests/support/raytrace/held_chunks.hpp"

namespace tedavis::raytrace::test_chunk_slots {
namespace {

using Slots = ChunkSlots<std::int16_t>;

struct StartedSlots {
    explicit StartedSlots(std::uint32_t count) : memory(Slots::bytes_needed(count, 35) / 8 + 1) {
        base::Arena arena(memory.data(), memory.size() * 8);
        EXPECT_TRUE(slots.start(count, 35, arena));
    }
    std::vector<std::uint64_t> memory;
    Slots slots;
};

TEST(ChunkSlots, TheOneUsedLongestAgoMakesRoom) {
    StartedSlots started(3);
    Slots& slots = started.slots;
    for (const std::uint32_t chunk : {10u, 11u, 12u}) EXPECT_TRUE(slots.take(chunk).must_be_filled);
    EXPECT_EQ(slots.in_use(), 3u);
    const std::uint32_t slot_of_11 = slots.take(11).slot;
    EXPECT_FALSE(slots.take(10).must_be_filled);
    EXPECT_TRUE(slots.take(20).must_be_filled) << "in place of 12";
    EXPECT_EQ(slots.take(11).slot, slot_of_11);
    EXPECT_FALSE(slots.take(10).must_be_filled);
    EXPECT_FALSE(slots.take(20).must_be_filled);
    EXPECT_TRUE(slots.take(12).must_be_filled) << "in place of 11";
    EXPECT_TRUE(slots.take(11).must_be_filled);
    EXPECT_EQ(slots.in_use(), 3u);
}

TEST(ChunkSlots, OneSlotServesAllInTurn) {
    StartedSlots started(1);
    for (std::uint32_t n = 0; n < 30; ++n) {
        EXPECT_TRUE(started.slots.take(n).must_be_filled);
        EXPECT_FALSE(started.slots.take(n).must_be_filled);
    }
}

TEST(ChunkSlots, WhatCannotBeLoadedOrIsBeyondItsBoundsHasNoSurface) {
    const test_support::ViewedHills<std::int16_t> hills(200, 150, true);
    test_support::HeldChunks<std::int16_t> chunks(hills.field(CellSurface::two_triangles).grid());
    std::vector<std::uint64_t> memory(ChunkBounds<std::int16_t>::bytes_needed(200, 150) / 8 + 1);
    base::Arena arena(memory.data(), memory.size() * 8);
    ChunkBounds<std::int16_t> bounds;
    ASSERT_EQ(bounds.start(chunks, arena), ChunkBounds<std::int16_t>::Started::yes);
    StartedSlots started(2);
    const auto highest = [&](std::uint32_t slot) { return started.slots.maxima(slot).level(5).at(0, 0); };
    const std::uint32_t slot = started.slots.take(8).slot;
    EXPECT_TRUE(started.slots.fill(slot, chunks, bounds, 0));
    EXPECT_LE(highest(slot), bounds.highest(8));
    EXPECT_GT(highest(slot), 0);
    chunks.damaged = 8;
    EXPECT_FALSE(started.slots.fill(slot, chunks, bounds, 0));
    EXPECT_EQ(highest(slot), no_surface<std::int16_t>(HeightBound::maximum));

    chunks.damaged = 99;
    chunks.slack = -10;  // now what it says of itself is too narrow
    base::Arena again(memory.data(), memory.size() * 8);
    ASSERT_EQ(bounds.start(chunks, again), ChunkBounds<std::int16_t>::Started::yes);
    EXPECT_FALSE(started.slots.fill(slot, chunks, bounds, 0));
}

TEST(ChunkSlots, RefusesASmallArena) {
    std::vector<std::uint64_t> memory(Slots::bytes_needed(4, 35) / 8 - 1000);
    base::Arena arena(memory.data(), memory.size() * 8);
    EXPECT_FALSE(Slots().start(4, 35, arena));
}

}  // namespace
}  // namespace tedavis::raytrace::test_chunk_slots
