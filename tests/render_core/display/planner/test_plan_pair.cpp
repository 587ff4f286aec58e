#include "render_core/display/planner/plan_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "render_core/display/planner/display_memory.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::display::test_plan_pair {
namespace {

constexpr std::uint8_t kDirty = 0xA5;

struct Room {
    std::vector<std::uint8_t> bytes;
    base::Arena arena;

    explicit Room(std::size_t size) : bytes(size, kDirty), arena(bytes.data(), bytes.size()) {}
};

TEST(PlanPair, TwoOfThemFitTheLinesOfEveryShippedDevice) {
    for (const char* const name : {"es2-small", "es3-mid", "sc2", "desktop"}) {
        const base::BudgetTable budget = test_support::shipped_device(name).budget;
        Room frames(budget.find(effects::kPlannedFrames)->bytes), memories(budget.find(effects::kPlannerMemory)->bytes);
        PlanPair one, other, third;
        EXPECT_FALSE(one.start(frames.arena, memories.arena)) << name;
        EXPECT_FALSE(other.start(frames.arena, memories.arena)) << name;
        EXPECT_NE(one.frame, other.frame);
        EXPECT_NE(one.memory, other.memory);
        EXPECT_TRUE(third.start(frames.arena, memories.arena)) << "control: a third one does not fit";
    }
}

TEST(PlanPair, IsThatOfADisplayThatHasShownNothing) {
    Room frames(2 * sizeof(PlannedFrame)), memories(2 * sizeof(PlannerMemory));
    PlanPair pair;
    ASSERT_FALSE(pair.start(frames.arena, memories.arena));
    EXPECT_EQ(pair.memory->frames, 0u);
    EXPECT_TRUE(pair.memory->transition.is_first);
    EXPECT_EQ(pair.frame->shown, nullptr);
    EXPECT_TRUE(std::all_of(frames.bytes.end() - 64, frames.bytes.end(), [](std::uint8_t byte) { return byte == kDirty; }))
        << "control: what lies behind it is not touched";
}

std::string needed(std::size_t bytes, std::size_t alignment) {
    return std::to_string(bytes + alignment) + " are needed for one of two plans; raise the line in the device file";
}

TEST(PlanPair, NamesTheLineThatIsTooSmall) {
    Room frames(sizeof(PlannedFrame) + 64), memories(sizeof(PlannerMemory) + 64), little(100);
    PlanPair pair;
    EXPECT_EQ(
        pair.start(little.arena, memories.arena).message.view(),
        "the budget line 'planned_frames' has 100 of 100 bytes left and " + needed(sizeof(PlannedFrame), alignof(PlannedFrame)));
    memories.arena.reset();
    little.arena.reset();
    EXPECT_EQ(pair.start(frames.arena, little.arena).message.view(),
              "the budget line 'planner_memory' has 100 of 100 bytes left and " +
                  needed(sizeof(PlannerMemory), alignof(PlannerMemory)));
}

}  // namespace
}  // namespace tedavis::display::test_plan_pair
