#include "render_core/display/planner/approach_frame.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::display::test_approach_frame {
namespace {

using base::radians;
using test_support::LoadedScene;
using test_support::scene_point;

/// An own ship over 46.8 N 9.8 E at 700 m, in a view whose pixels are 1/400 of their distance wide.
class ApproachFrame : public testing::Test {
protected:
    ApproachFrame() {
        view_.focal_px = 400;
        view_.forward = {0, 1, 0};
        aircraft_.own_ship.state = base::SignalState::valid;
        aircraft_.own_ship.position = {radians(46.8), radians(9.8), {700}};
        aircraft_.own_ship.height_is_geometric = true;
    }
    [[nodiscard]] draw::ApproachFrame frame(const scene::Scene* scene) {
        return approach_frame({ground_, view_, {}, {}, {nullptr, &aircraft_, {}}}, scene);
    }

    test_support::LevelGround ground_;
    terrain::View view_;
    flight::AircraftState aircraft_;
};

/// A planned flight that ends at 46.8 N 9.9 E.
host_sim::LayerDraft planned() {
    host_sim::LayerDraft layer;
    layer.name = "plan";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.points = {scene_point(46.8, 9.79, 700), scene_point(46.8, 9.85, 650), scene_point(46.8, 9.9, 600)};
    layer.starts = {0, 3};
    return layer;
}

TEST_F(ApproachFrame, HasTheViewTheOwnShipAndTheEndOfThePlan) {
    const LoadedScene scene(planned());
    const draw::ApproachFrame approach = frame(&scene.scene());
    EXPECT_EQ(approach.forward, view_.forward);
    EXPECT_DOUBLE_EQ(approach.metres_per_px_m, 1.0 / 400);
    ASSERT_TRUE(approach.has_own_ship);
    EXPECT_EQ(approach.own_ship.height.m, 700);
    ASSERT_TRUE(approach.has_destination);
    EXPECT_NEAR(approach.destination_longitude_rad, radians(9.9), 1e-9);
    EXPECT_NEAR(approach.destination_latitude_rad, radians(46.8), 1e-9);
}

TEST_F(ApproachFrame, AHeightAboveTheGeoidIsRaisedByTheUndulation) {
    aircraft_.own_ship.height_is_geometric = false;
    EXPECT_EQ(frame(nullptr).own_ship.height.m, 700 + ground_.undulation);
}

TEST_F(ApproachFrame, WithoutASceneOrNearPlanThereIsNoDestination) {
    EXPECT_TRUE(frame(nullptr).has_own_ship);
    EXPECT_FALSE(frame(nullptr).has_destination);
    const LoadedScene scene(planned());
    aircraft_.own_ship.position.latitude_rad = radians(47.1);  // 33 km away
    EXPECT_FALSE(frame(&scene.scene()).has_destination);
}

TEST_F(ApproachFrame, NothingIsStatedOfAPositionThatIsNotValid) {
    const LoadedScene scene(planned());
    for (const base::SignalState state : {base::SignalState::stale, base::SignalState::lost}) {
        aircraft_.own_ship.state = state;
        EXPECT_FALSE(frame(&scene.scene()).has_own_ship);
        EXPECT_FALSE(frame(&scene.scene()).has_destination);
        EXPECT_DOUBLE_EQ(frame(&scene.scene()).metres_per_px_m, 1.0 / 400) << "the view is still known";
    }
}

}  // namespace
}  // namespace tedavis::display::test_approach_frame
