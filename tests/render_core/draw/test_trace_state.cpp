#include "render_core/draw/trace_state.hpp"

#include <gtest/gtest.h>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::draw::test_trace_state {
namespace {

TEST(TraceStateOfDesigns, TracesDesignsThatCodesCanShow) {
    design::DesignSettings design = design::default_design_settings();
    design.terrain.renderer = design::TerrainRenderer::trace;
    const auto state = [&] { return trace_state_of({&design, output_of(design, true)}); };
    EXPECT_EQ(state(), TraceState::traced);
    design.terrain.style.texture = design::TerrainTexture::slope;
    constexpr DrawAbility kShades{true, true, true}, kEs2{true, false, false}, kSmall{true, true, false};
    EXPECT_EQ(trace_state_of(drawn_as(design, kShades, false)), TraceState::traced) << "shaded from a geometry picture";
    EXPECT_EQ(trace_state_of(drawn_as(design, kEs2, false)), TraceState::not_on_lane);
    EXPECT_EQ(trace_state_of(drawn_as(design, kSmall, false)), TraceState::not_on_device);
    design.effects.shadows.in_air = 0.5;
    design.terrain.style.sketch.silhouettes = 0;
    EXPECT_EQ(trace_state_of(drawn_as(design, kShades, false)), TraceState::not_by_style);
    design.view.reference = design::Reference::flat;
    EXPECT_EQ(state(), TraceState::not_flat);
    design.terrain.renderer = design::TerrainRenderer::automatic;
    EXPECT_EQ(state(), TraceState::not_flat);
    design.terrain.renderer = design::TerrainRenderer::raster;
    EXPECT_EQ(state(), TraceState::not_asked_for);
}

TEST(TraceStateOfDesigns, EveryStandInHasAReason) {
    for (int state = 2; state <= static_cast<int>(TraceState::not_by_cost); ++state)
        EXPECT_FALSE(reason_of(static_cast<TraceState>(state)).empty()) << state;
    EXPECT_TRUE(reason_of(TraceState::traced).empty());
    EXPECT_TRUE(reason_of(TraceState::not_asked_for).empty());
}

TEST(CanTrace, NotFromAboveThePole) {
    terrain::View view;
    view.eye = earth::to_ecef({0.82, 0.17, {2000}});
    EXPECT_TRUE(can_trace(test_support::hills().database, view));
    view.eye = earth::to_ecef({1.5707, 0.17, {2000}});
    EXPECT_FALSE(can_trace(test_support::hills().database, view));
}

}  // namespace
}  // namespace tedavis::draw::test_trace_state
