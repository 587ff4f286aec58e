#include "render_core/base/memory_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace tedavis::base::test_memory_budget {
namespace {

BudgetLine line(const char* name, MemoryKind kind, std::uint64_t bytes) {
    BudgetLine l;
    l.name = name;
    l.owner = "test";
    l.reason = "because";
    l.kind = kind;
    l.bytes = bytes;
    return l;
}

TEST(BudgetTable, sums_by_kind_and_finds_by_name) {
    BudgetTable table;
    EXPECT_TRUE(table.try_add(line("chunks", MemoryKind::cpu, 1000)));
    EXPECT_TRUE(table.try_add(line("staging", MemoryKind::cpu, 24)));
    EXPECT_TRUE(table.try_add(line("vertices", MemoryKind::gpu, 4096)));
    EXPECT_EQ(table.total(MemoryKind::cpu), 1024u);
    EXPECT_EQ(table.total(MemoryKind::gpu), 4096u);
    ASSERT_NE(table.find("vertices"), nullptr);
    table.find("vertices")->use.take(100);
    EXPECT_EQ(table.in_use(MemoryKind::gpu), 100u);
    EXPECT_EQ(table.in_use(MemoryKind::cpu), 0u);
    EXPECT_EQ(table.find("absent"), nullptr);
}

TEST(BudgetTable, refuses_a_taken_name_and_a_full_table) {
    BudgetTable table;
    EXPECT_TRUE(table.try_add(line("a", MemoryKind::cpu, 1)));
    EXPECT_FALSE(table.try_add(line("a", MemoryKind::gpu, 1)));
    for (std::size_t i = 1; i < kMaxBudgetLines; ++i)
        EXPECT_TRUE(table.try_add(line(std::to_string(i).c_str(), MemoryKind::cpu, 1)));
    EXPECT_FALSE(table.try_add(line("one too many", MemoryKind::cpu, 1)));
    EXPECT_EQ(table.lines().size(), kMaxBudgetLines);
}

class ArenaTest : public testing::Test {
protected:
    alignas(64) unsigned char block[256];
    Arena arena{block, sizeof block};
    void SetUp() override { std::fill(std::begin(block), std::end(block), static_cast<unsigned char>(0xAA)); }
};

TEST_F(ArenaTest, hands_out_aligned_zeroed_memory_that_does_not_overlap) {
    auto* a = static_cast<unsigned char*>(arena.allocate(3, 1));
    auto* b = static_cast<unsigned char*>(arena.allocate(16, 32));
    ASSERT_NE(a, nullptr);
    ASSERT_NE(b, nullptr);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(b) % 32, 0u);
    EXPECT_GE(b, a + 3);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(b[i], 0);
    EXPECT_EQ(arena.use().in_use, 48u) << "padding counts";
}

TEST_F(ArenaTest, fills_to_the_last_byte_then_refuses_and_counts) {
    EXPECT_NE(arena.allocate(256, 1), nullptr);
    EXPECT_EQ(arena.allocate(1, 1), nullptr);
    EXPECT_EQ(arena.use().refused, 1u);
    EXPECT_EQ(arena.use().high_water, 256u);
    arena.reset();
    EXPECT_NE(arena.allocate(256, 1), nullptr);
    EXPECT_EQ(arena.use().high_water, 256u);
}

TEST_F(ArenaTest, a_refusal_takes_nothing) {
    EXPECT_EQ(arena.allocate(257, 1), nullptr);
    EXPECT_EQ(arena.allocate(static_cast<std::size_t>(-1), 64), nullptr) << "sizes near the limit do not wrap";
    EXPECT_EQ(arena.use().in_use, 0u);
    EXPECT_EQ(arena.use().refused, 2u);
}

TEST_F(ArenaTest, arrays_refuse_counts_whose_bytes_would_wrap) {
    EXPECT_EQ(arena.allocate_array<double>(32).size(), 32u);
    arena.reset();
    EXPECT_TRUE(arena.allocate_array<double>(33).empty());
    EXPECT_TRUE(arena.allocate_array<double>(static_cast<std::size_t>(-1) / 4).empty());
    EXPECT_EQ(arena.use().refused, 2u);
}

TEST_F(ArenaTest, a_carved_child_stays_inside_its_piece) {
    Arena child = arena.carve(64);
    EXPECT_EQ(child.use().capacity, 64u);
    EXPECT_NE(child.allocate(64, 1), nullptr);
    EXPECT_EQ(child.allocate(1, 1), nullptr);
    EXPECT_EQ(arena.carve(1000).use().capacity, 0u);
    EXPECT_EQ(arena.use().refused, 1u);
    EXPECT_EQ(Arena().allocate(1, 1), nullptr) << "an empty arena refuses everything";
}

TEST(Arena, touches_only_what_it_hands_out_and_fills_that_with_zeros) {
    unsigned char block[256];
    std::fill(std::begin(block), std::end(block), static_cast<unsigned char>(7));
    Arena arena(block, sizeof block);
    Arena child = arena.carve(128);
    EXPECT_EQ(std::count(std::begin(block), std::end(block), 7), 256) << "a carved budget is not used yet";
    const Span<unsigned char> used = child.allocate_array<unsigned char>(32);
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), 32);
    EXPECT_EQ(std::count(std::begin(block), std::end(block), 7), 256 - 32);
}

TEST(ArenaDeathTest, alignment_must_be_a_power_of_two) {
    unsigned char block[8];
    Arena arena(block, sizeof block);
    EXPECT_DEATH((void)arena.allocate(1, 3), "alignment");
}

}  // namespace
}  // namespace tedavis::base::test_memory_budget
