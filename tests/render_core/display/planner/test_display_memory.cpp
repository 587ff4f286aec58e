#include "render_core/display/planner/display_memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/files/device_files.hpp"

namespace tedavis::display::test_display_memory {
namespace {

/// Budgets of a few kilobytes that are all different.
base::BudgetTable small_budget() {
    base::BudgetTable budget = test_support::shipped_device("es2-small").budget;
    std::uint64_t bytes = 1000;
    for (const base::BudgetLine& line : budget.lines()) budget.find(line.name.view())->bytes = bytes += 104;
    return budget;
}

struct Cut {
    base::BudgetTable budget = small_budget();
    std::vector<std::uint8_t> block;
    base::Arena reservation;
    DisplayMemory memory;
    std::string message;

    explicit Cut(std::uint64_t bytes) : block(bytes), reservation(block.data(), block.size()) {
        message = std::string(memory.cut(budget, reservation).message.view());
    }
    [[nodiscard]] std::uint64_t line(std::string_view name) const { return budget.find(name)->bytes; }
};

TEST(DisplayMemory, EveryArenaIsAsLargeAsItsLine) {
    Cut cut(DisplayMemory::bytes_needed(small_budget()));
    ASSERT_EQ(cut.message, "");
    const TerrainMemory terrain = cut.memory.terrain();
    const std::pair<const base::Arena*, const char*> arenas[] = {{&terrain.index, "terrain_index"},
                                                                 {&terrain.records, "terrain_chunk_slots"},
                                                                 {&terrain.payloads, "terrain_heights"},
                                                                 {&terrain.attributes, "terrain_attributes"},
                                                                 {&terrain.drape, "terrain_drape"},
                                                                 {&terrain.lod, "lod_scratch"},
                                                                 {&terrain.staging, "staging"},
                                                                 {&cut.memory.symbology(), "symbology"},
                                                                 {&cut.memory.picture_edges(), "picture_edges"}};
    for (const auto& [arena, line] : arenas) EXPECT_EQ(arena->use().capacity, cut.line(line)) << line;
}

TEST(DisplayMemory, HasRoomForTracedTerrainWhereTheDeviceHas) {
    Cut without(DisplayMemory::bytes_needed(small_budget()));
    EXPECT_EQ(without.memory.traced_terrain().use().capacity, 0u);
    base::BudgetTable budget = test_support::shipped_device("es3-mid").budget;
    for (const base::BudgetLine& line : budget.lines()) budget.find(line.name.view())->bytes = 64;
    budget.find(effects::kTracedTerrain)->bytes = 4096;
    std::vector<std::uint8_t> block(DisplayMemory::bytes_needed(budget));
    base::Arena reservation(block.data(), block.size());
    DisplayMemory memory;
    ASSERT_EQ(memory.cut(budget, reservation).message.view(), "");
    EXPECT_EQ(memory.traced_terrain().use().capacity, 4096u);
    static_cast<void>(memory.traced_terrain().allocate(300, 4));
    memory.record_use(budget);
    EXPECT_EQ(budget.find(effects::kTracedTerrain)->use.in_use, 300u);
}

TEST(DisplayMemory, TheTableSaysWhatWasTakenOfEachLine) {
    Cut cut(DisplayMemory::bytes_needed(small_budget()));
    static_cast<void>(cut.memory.terrain().lod.allocate(300, 4));
    static_cast<void>(cut.memory.symbology().allocate(2'000'000, 4));
    cut.memory.record_use(cut.budget);
    EXPECT_EQ(cut.budget.find("lod_scratch")->use.in_use, 300u);
    EXPECT_EQ(cut.budget.find("symbology")->use.in_use, 0u);
    EXPECT_EQ(cut.budget.find("symbology")->use.refused, 1u);
    EXPECT_EQ(cut.budget.find("staging")->use.capacity, cut.line("staging"));
    EXPECT_EQ(cut.budget.in_use(base::MemoryKind::cpu), 300u);
    EXPECT_EQ(cut.budget.in_use(base::MemoryKind::gpu), 0u) << "not of this memory";
}

TEST(DisplayMemory, AReservationThatIsTooSmallNamesTheFirstLineThatDoesNotFit) {
    const base::BudgetTable budget = small_budget();
    std::uint64_t processor_bytes = 0;
    for (const base::BudgetLine& line : budget.lines()) processor_bytes += line.kind == base::MemoryKind::cpu ? line.bytes : 0;
    const auto taken = [&](const char* line) { return std::to_string(budget.find(line)->bytes); };
    EXPECT_NE(Cut(processor_bytes - 1)
                  .message.find(" bytes left and the budget line 'picture_edges' takes " + taken("picture_edges") + "; lower"),
              std::string::npos);
    EXPECT_EQ(Cut(10).message, "the reservation has 10 bytes left and the budget line 'terrain_heights' takes " +
                                   taken("terrain_heights") + "; lower the budgets in the device file");
    EXPECT_GE(DisplayMemory::bytes_needed(budget), processor_bytes);
}

}  // namespace
}  // namespace tedavis::display::test_display_memory
