#include "render_core/display/record_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/support/display/hills_planner.hpp"

namespace tedavis::display::test_record_of {
namespace {

bool has_flag(const FrameRecord& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [&](const Name& flag) { return flag.view() == name; });
}

TEST(RecordOf, SaysWhatWasPlannedAndWhatWasDrawn) {
    auto hills = std::make_unique<test_support::HillsPlanner>(test_support::shipped_design("default"));
    flight::FrameInput input;
    input.state = test_support::aircraft_over_hills(1800);
    input.time = test_support::kHillsNow;
    hills->settle(input);
    const auto plan = hills->plan(input, hills->memory);
    DrawnFrame drawn;
    drawn.terrain = {1234, 56};
    drawn.uploaded_bytes = 789;
    const base::BudgetTable& table = hills->planner().budget();
    const FrameRecord record = record_of(*plan, drawn, {}, table);
    EXPECT_EQ(record.time.ns, input.time.ns);
    EXPECT_EQ(record.altitude_msl_m, plan->altitude_msl_m);
    EXPECT_EQ(record.terrain.tau_px, plan->terrain.tau_px);
    EXPECT_EQ(record.terrain.triangles, 1234u) << "drawn, not planned";
    EXPECT_EQ(record.terrain.chunks, 56u);
    EXPECT_EQ(record.bytes.uploaded, 789u);
    EXPECT_EQ(record.bytes.gpu_budget, table.total(base::MemoryKind::gpu));
    EXPECT_FALSE(has_flag(record, "ground_data.missing"));
    EXPECT_EQ(record.terrain_aspect.weight, plan->weights.of[design::kTerrainAspect]);
    drawn.ground_data_is_missing = true;
    EXPECT_TRUE(has_flag(record_of(*plan, drawn, {}, table), "ground_data.missing")) << "the device has no room for it";
}

}  // namespace
}  // namespace tedavis::display::test_record_of
