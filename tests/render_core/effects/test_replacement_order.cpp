#include "render_core/effects/replacement_order.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects::test_replacement_order {
namespace {

design::InsteadOf instead(std::string_view effect, std::initializer_list<std::string_view> names) {
    design::InsteadOf one;
    one.effect = base::FixedString<31>(effect);
    for (std::string_view name : names) EXPECT_TRUE(one.instead.try_push_back(base::FixedString<31>(name)));
    return one;
}

std::string refusal(const design::InsteadOf& one) {
    const auto order = replacement_order({&one, 1});
    return order.ok() ? "" : std::string(order.error().view());
}

TEST(ReplacementOrder, IsTheTablesWhereNothingIsStated) {
    const auto order = replacement_order({});
    ASSERT_TRUE(order.ok());
    for (std::size_t n = 0; n < kEffectCount; ++n)
        EXPECT_EQ(order.value().of(static_cast<Effect>(n)), row_of(static_cast<Effect>(n)).replacements);
}

TEST(ReplacementOrder, ADesignMayWantNothingInAnEffectsPlace) {
    const design::InsteadOf nothing = instead("silhouettes", {});
    PlanInput input;
    input[Effect::silhouettes] = {EffectRequest::Kind::applicable, ""};
    DeviceCapability device;
    device.depth24_targets = false;
    EXPECT_EQ(plan_effects(input, device)[Effect::silhouettes].replaced_by, Effect::ridges);
    input.order = replacement_order({&nothing, 1}).value();
    const PlannedEffect planned = plan_effects(input, device)[Effect::silhouettes];
    EXPECT_EQ(planned.state, PlanState::skipped);
    EXPECT_EQ(planned.reason, "the device has no 24-bit depth off screen");
    EXPECT_EQ(possible_effect(Effect::silhouettes, {}, device, input.order), Effect::count_);
    EXPECT_EQ(possible_effect(Effect::silhouettes, {}, device, {}), Effect::ridges);
    input.too_costly.add(Effect::silhouettes);
    input.in_reserve.add(Effect::ridges);
    device.depth24_targets = true;
    EXPECT_EQ(plan_effects(input, device)[Effect::silhouettes].state, PlanState::skipped) << "nor for want of time";
}

TEST(ReplacementOrder, TakesOnlyWhatCanTakeThePlace) {
    EXPECT_EQ(refusal(instead("silhouettes", {"ridges"})), "");
    EXPECT_NE(refusal(instead("silhouette", {})).find("silhouette: no effect has this name"), std::string::npos);
    EXPECT_NE(refusal(instead("silhouettes", {"haze"})).find("'haze' cannot take its place"), std::string::npos);
    EXPECT_NE(refusal(instead("silhouettes", {"count_"})), "");
}

}  // namespace
}  // namespace tedavis::effects::test_replacement_order
