#include "render_core/effects/cost_model.hpp"

#include <gtest/gtest.h>

namespace tedavis::effects::test_cost_model {
namespace {

using Kind = EffectRequest::Kind;

TEST(CostModel, ALineIsFixedByPixelsAndByThings) {
    EXPECT_DOUBLE_EQ(modelled_ms({1.5, 2, 3}, 0.5, 4000), 1.5 + 1 + 12);
    EXPECT_EQ(modelled_ms({}, 10, 1e9), 0);
}

/// Every effect costs its own power of two, so that the sum tells which were counted.
CostTable powers_of_two() {
    CostTable table;
    table.is_known = true;
    for (std::size_t n = 0; n < kEffectCount; ++n) table.effects[n].fixed_ms = static_cast<double>(1u << n);
    return table;
}

TEST(CostModel, OnlyWhatRunsCostsAndAReplacementInItsPlace) {
    PlanInput input;
    DeviceCapability device;
    device.depth24_targets = false;
    input[Effect::terrain] = {Kind::applicable, ""};
    input[Effect::silhouettes] = {Kind::applicable, ""};
    input[Effect::haze] = {Kind::not_applicable, ""};
    const double sum = modelled_ms(powers_of_two(), plan_effects(input, device), {});
    const auto bit = [](Effect effect) { return static_cast<double>(1u << static_cast<unsigned>(effect)); };
    EXPECT_EQ(sum, bit(Effect::terrain) + bit(Effect::ridges));
}

TEST(CostModel, WhatIsSharedByTwoIsCountedOnce) {
    PlanInput input;
    DeviceCapability device;
    device.depth24_targets = false;
    input[Effect::silhouettes] = input[Effect::ridges] = {Kind::applicable, ""};
    EXPECT_EQ(modelled_ms(powers_of_two(), plan_effects(input, device), {}),
              static_cast<double>(1u << static_cast<unsigned>(Effect::ridges)));
}

TEST(CostModel, CountersCountWhereTheyBelong) {
    CostTable table;
    table[Effect::terrain] = {0, 0, 1};
    table[Effect::adjacent] = {0, 0, 10'000};
    table[Overhead::frame] = {0.5, 2, 0};
    table[Overhead::elements] = {3, 0, 100};
    table[Overhead::glyphs] = {7, 0, 1000};
    PlanInput input;
    FrameCounters counters;
    counters.megapixels = 2;
    const auto ms = [&] { return modelled_ms(table, plan_effects(input, {}), counters); };
    EXPECT_DOUBLE_EQ(ms(), 4.5) << "elements and glyphs that are not there cost nothing";
    counters.elements = 20;
    EXPECT_DOUBLE_EQ(ms(), 4.5 + 3 + 2);
    counters.glyphs = 5;
    EXPECT_DOUBLE_EQ(ms(), 4.5 + 5 + 7 + 5);
    counters.triangles = 6000;
    counters.maps = 2;
    EXPECT_DOUBLE_EQ(ms(), 4.5 + 5 + 12) << "neither runs";
    input[Effect::terrain] = input[Effect::adjacent] = {Kind::applicable, ""};
    EXPECT_DOUBLE_EQ(ms(), 4.5 + 5 + 12 + 6 + 20);
}

/// Of terrain by rays the cost stands in place of that of triangles, and depends on the picture alone.
TEST(CostModel, TerrainByRaysCostsWhatRaysCost) {
    CostTable table;
    table.is_known = true;
    table[Effect::terrain] = {0, 1, 2};
    table[Effect::haze] = {0.5, 0, 0};
    PlanInput input;
    input[Effect::terrain] = input[Effect::haze] = {Kind::applicable, ""};
    FrameCounters counters;
    counters.megapixels = 2;
    counters.triangles = 3000;
    const auto ms = [&] { return modelled_ms(table, plan_effects(input, {}), counters); };
    EXPECT_FALSE(table.knows_rays());
    counters.is_traced = true;
    EXPECT_DOUBLE_EQ(ms(), 0.5 + 2 + 6) << "not measured";
    table[Overhead::rays] = {0, 4, 0};
    EXPECT_TRUE(table.knows_rays());
    EXPECT_DOUBLE_EQ(ms(), 0.5 + 8);
    EXPECT_DOUBLE_EQ(terrain_ms(table, counters), 8);
    counters.triangles = 90'000;
    EXPECT_DOUBLE_EQ(ms(), 0.5 + 8);
    counters.is_traced = false;
    EXPECT_DOUBLE_EQ(ms(), 0.5 + 2 + 180) << "rays that are not traced cost nothing";
    input[Effect::terrain] = {Kind::not_applicable, ""};
    counters.is_traced = true;
    EXPECT_DOUBLE_EQ(ms(), 0.5) << "nor do rays without terrain";
}

}  // namespace
}  // namespace tedavis::effects::test_cost_model
