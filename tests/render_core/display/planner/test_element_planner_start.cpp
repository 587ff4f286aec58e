#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::display::test_element_planner_start {
namespace {

/// The sentence of a start with the budgets of a shipped device, but one line of this size; empty where it starts.
std::string start_with(std::string_view name, std::uint64_t bytes, bool has_instances) {
    base::BudgetTable budget = test_support::shipped_device("es3-mid").budget;
    budget.find(name)->bytes = bytes;
    std::array<std::vector<unsigned char>, 3> blocks;
    std::array<base::Arena, 3> arenas;
    const std::string_view lines[] = {effects::kSceneSolids, effects::kSceneGlyphs, effects::kSceneBillboards};
    for (std::size_t n = 0; n < arenas.size(); ++n) {
        blocks[n].resize(budget.find(lines[n])->bytes);
        arenas[n] = base::Arena(blocks[n].data(), blocks[n].size());
    }
    const auto planner = std::make_unique<ElementPlanner>();
    return std::string(planner->start(has_instances, budget, {arenas[0], arenas[1], arenas[2]}).message.view());
}

/// Each refusal names the line, and what it says is enough in a few steps.
TEST(ElementPlannerStart, ALineThatIsTooSmallIsNamedWithWhatIsEnough) {
    for (const bool has_instances : {false, true})
        for (const std::string_view name : {effects::kSceneSolids, effects::kSceneGlyphs, effects::kSceneBillboards,
                                            effects::kSceneSolidVertices, effects::kSceneBillboardVertices}) {
            std::uint64_t bytes = 64;
            std::string refused = start_with(name, bytes, has_instances);
            EXPECT_NE(refused, "") << name << ": control";
            for (int n = 0; n < 12 && !refused.empty(); ++n) {
                base::BudgetShortage shortage;
                ASSERT_TRUE(base::find_shortage(refused, shortage)) << refused;
                ASSERT_EQ(shortage.line.view(), name);
                ASSERT_GT(shortage.enough(), bytes) << refused;
                bytes = shortage.enough();
                refused = start_with(name, bytes, has_instances);
            }
            EXPECT_EQ(refused, "");
        }
}

TEST(ElementPlannerStart, BothRoomsAreWithinTheLine) {
    base::BudgetTable budget = test_support::shipped_device("es3-mid").budget;
    for (const std::uint64_t bytes : {std::uint64_t{100}, std::uint64_t{100'000}, std::uint64_t{3'333'333}}) {
        budget.find(effects::kSceneSolidVertices)->bytes = bytes;
        const SolidRooms rooms = solid_rooms(budget);
        EXPECT_LE(rooms.standing.gpu_bytes() + rooms.moving.gpu_bytes(), bytes);
        EXPECT_EQ(rooms.standing.vertices, 3 * rooms.moving.vertices);
    }
}

}  // namespace
}  // namespace tedavis::display::test_element_planner_start
