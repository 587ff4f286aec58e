#include "render_core/effects/effect_requests.hpp"

#include <gtest/gtest.h>

#include "tests/render_core/effects/requesting_frame.hpp"

namespace tedavis::effects::test_effect_requests {
namespace {

using Kind = EffectRequest::Kind;
using EffectRequests = test_support::RequestingFrame;

TEST_F(EffectRequests, WhatIsThereAndHasAPlaceIsCalledFor) {
    for (const Effect effect : {Effect::terrain, Effect::warning_colors, Effect::silhouettes, Effect::moving_sun, Effect::drape,
                                Effect::haze, Effect::surface_grid, Effect::ground_data, Effect::adjacent})
        EXPECT_EQ(call(effect).kind, Kind::applicable) << row_of(effect).name;
    facts_.asked = asked_effects([] {
        design::DesignSettings plain;
        plain.terrain.style.sketch = {};
        plain.sky.haze_distance_m = 0;
        return plain;
    }());
    for (const Effect effect : {Effect::silhouettes, Effect::moving_sun, Effect::drape, Effect::haze, Effect::ground_data,
                                Effect::adjacent, Effect::ridges, Effect::plain_color})
        EXPECT_EQ(call(effect).kind, Kind::not_asked_for) << row_of(effect).name;
}

TEST_F(EffectRequests, WithoutTerrainNothingIsCalledFor) {
    facts_.shows_terrain = false;
    for (std::size_t n = 0; n < kEffectCount; ++n) EXPECT_NE(call(static_cast<Effect>(n)).kind, Kind::applicable);
    EXPECT_EQ(call(Effect::terrain).why, "removed by the failure policy");
}

TEST_F(EffectRequests, InAnUnusualAttitudeNothingDistracts) {
    facts_.is_unusual_attitude = true;
    facts_.fade_share = 1;
    facts_.parallax_px = 9;
    for (const Effect effect : {Effect::cross_fade, Effect::stereo, Effect::depth_of_field}) {
        facts_.asked.add(effect);
        EXPECT_EQ(call(effect).why, "removed by the failure policy") << row_of(effect).name;
    }
    EXPECT_EQ(call(Effect::terrain).kind, Kind::applicable);
}

/// Whatever a row says of itself, it is not called where it is not asked for or may not be shown.
TEST_F(EffectRequests, NoRowIsCalledUnaskedOrAgainstThePolicy) {
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const auto effect = static_cast<Effect>(n);
        facts_.asked = {};
        EXPECT_EQ(call(effect).kind, Kind::not_asked_for) << row_of(effect).name;
        facts_.asked.add(effect);
        EXPECT_EQ(call(effect).kind == Kind::not_asked_for, row_of(effect).request == nullptr) << row_of(effect).name;
        facts_.shows_terrain = false;
        EXPECT_TRUE(!row_of(effect).needs_terrain || call(effect).kind != Kind::applicable) << row_of(effect).name;
        facts_.shows_terrain = true;
        facts_.is_unusual_attitude = true;
        EXPECT_TRUE(!row_of(effect).distracts || call(effect).why == kRemovedByPolicy) << row_of(effect).name;
        facts_.is_unusual_attitude = false;
    }
}

}  // namespace
}  // namespace tedavis::effects::test_effect_requests
