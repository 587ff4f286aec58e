/// A view that plates may shade, without a display round it.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "render_core/display/planner/shadow_plan.hpp"
#include "render_core/display/shadow_casters.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/effects/effect_requests.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::test_support {

/// An eye that looks north, and plates between it and the ground.
class ShadedView : public ::testing::Test {
protected:
    ShadedView() : block_(1u << 22) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(solids_
                        .start(session_.gl, *session_.device.budget.find(effects::kSceneSolidVertices), arena, {64, 192, 8},
                               gl::BufferUse::streamed)
                        .message.empty());
        EXPECT_EQ(casters_.start(session_.gl, *session_.device.budget.find(effects::kRenderTargets), 1024).message.view(), "");
        EXPECT_TRUE(mesh_.start(arena));
        session_.gl.seal();
        const glm::dmat3 axes = earth::body_axes(kLatitude, kLongitude, 0, -0.2, 0);
        view_ = free_view(earth::to_ecef({kLatitude, kLongitude, {1000}}), axes, 640, 480, 10);
        settings_.on_ground = 0.6;
        light_.azimuth_rad = 2;
        light_.elevation_rad = 0.7;
    }
    ~ShadedView() override {
        session_.gl.retire();
        solids_.destroy(session_.gl);
        casters_.destroy(session_.gl);
    }
    void add_plate(double north_m, double half_m) {
        const glm::dmat3 down = earth::north_east_down(kLatitude, kLongitude);
        const auto corner = [&](double n, double e) { return view_.eye + down * glm::dvec3(north_m + n, e, 500); };
        mesh_.begin(corner(0, 0));
        mesh_.set_color({1, 2, 3});
        mesh_.quad(corner(-half_m, -half_m), corner(-half_m, half_m), corner(half_m, half_m), corner(half_m, -half_m));
        EXPECT_TRUE(mesh_.add_to(solids_.batch()));
    }
    [[nodiscard]] display::CasterSet set() const {
        display::CasterSet set;
        set.solids[0] = set.solids[1] = &solids_.batch();
        set.groups.all = groups_;
        return set;
    }
    [[nodiscard]] display::ShadowPlan plan() const {
        return display::plan_shadows({settings_, light_, view_, 1000, 0, 0, nearest_m_, 1024, has_values_}, set());
    }
    /// Of shadows on the ground, or in the air where it changes colours by `air` at most.
    [[nodiscard]] effects::EffectRequest call(effects::Effect effect = effects::Effect::soft_shadows, double air = 0,
                                              bool is_near = true) const {
        const display::ShadowPlan planned = plan();
        effects::EffectFacts facts;
        facts.asked.add(effect);
        facts.shows_terrain = true;
        facts.is_near = is_near;
        facts.has_haze = air > 0;
        facts.haze_bound = air;
        facts.shadows = planned.state;
        facts.widest_shadow_px = planned.widest_px;
        facts.shadow_in_air = planned.in_air;
        return effects::effect_requests(facts)[effect];
    }

    static constexpr double kLatitude = 0.8203, kLongitude = 0.1745;
    GlSession session_{"egl", "es3-mid"};
    std::vector<unsigned char> block_;
    FilledSolids solids_;
    display::ShadowCasters casters_;
    draw::SolidMesh mesh_;
    terrain::View view_;
    design::ShadowSettings settings_;
    policy::TerrainLight light_;
    std::uint32_t groups_ = ~0u;
    double nearest_m_ = 500;
    bool has_values_ = false;
};

}  // namespace tedavis::test_support
