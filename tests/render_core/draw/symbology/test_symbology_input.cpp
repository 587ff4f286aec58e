#include "render_core/draw/symbology/symbology_input.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_symbology_input {
namespace {

using base::radians;
using flight::Signal;
using policy::DisplayDecisions;
using policy::Element;
using test_support::kSceneNow;

DisplayDecisions decisions_from(Signal view_heading) {
    DisplayDecisions decisions;
    decisions.view_heading = view_heading;
    return decisions;
}

TEST(SymbologyInput, TheViewsHeadingIsTrueWhateverItComesFrom) {
    flight::AircraftState state;
    state[Signal::true_heading] = {radians(40), kSceneNow};
    state[Signal::true_track] = {radians(44), kSceneNow};
    state[Signal::magnetic_heading] = {radians(359), kSceneNow};
    state[Signal::magnetic_variation] = {radians(3), kSceneNow};
    EXPECT_DOUBLE_EQ(view_heading_rad(state, decisions_from(Signal::true_heading)), radians(40));
    EXPECT_DOUBLE_EQ(view_heading_rad(state, decisions_from(Signal::true_track)), radians(44));
    EXPECT_NEAR(view_heading_rad(state, decisions_from(Signal::magnetic_heading)), radians(2), 1e-12);
    EXPECT_EQ(view_heading_rad(state, decisions_from(Signal::count_)), 0);
}

TEST(SymbologyInput, ValuesComeFromTheSignalsThatWereDecided) {
    flight::AircraftState state;
    state[Signal::baro_altitude] = {1000, kSceneNow};
    state[Signal::ellipsoid_height] = {1050, kSceneNow};
    state[Signal::indicated_airspeed] = {50, kSceneNow};
    state[Signal::true_airspeed] = {60, kSceneNow};
    const auto input_for = [&](Signal altitude, Signal airspeed) {
        DisplayDecisions decisions;
        decisions[Element::altitude].source = altitude;
        decisions[Element::airspeed].source = airspeed;
        return make_symbology_input(state, decisions, {}, design::default_design_settings(), kSceneNow, 640, 480, 1002);
    };
    EXPECT_EQ(input_for(Signal::baro_altitude, Signal::indicated_airspeed).altitude_m, 1000);
    EXPECT_EQ(input_for(Signal::ellipsoid_height, Signal::indicated_airspeed).altitude_m, 1002)
        << "above the geoid, not the ellipsoid";
    EXPECT_EQ(input_for(Signal::baro_altitude, Signal::true_airspeed).airspeed_mps, 60);
    EXPECT_EQ(input_for(Signal::baro_altitude, Signal::count_).airspeed_mps, 0);
}

TEST(SymbologyInput, TheViewIsTheOneOfTheAttitude) {
    const flight::AircraftState state = test_support::scene_state(75, 8, -20);
    const SymbologyInput input = test_support::scene_input(state, 640, 480);
    const ViewFrame expected = make_view_frame(640, 480, design::default_design_settings().view.horizontal_field_of_view_rad,
                                               radians(75), radians(8), radians(-20));
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) EXPECT_NEAR(input.view.body_axes[column][row], expected.body_axes[column][row], 1e-15);
    EXPECT_EQ(input.view.focal_px, expected.focal_px);
}

}  // namespace
}  // namespace tedavis::draw::test_symbology_input
