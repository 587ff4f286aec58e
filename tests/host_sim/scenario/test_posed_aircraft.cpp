#include "host_sim/scenario/posed_aircraft.hpp"

#include <gtest/gtest.h>

#include "host_sim/replay/display_session.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_posed_aircraft {
namespace {

using flight::Signal;

double degrees_of(const flight::AircraftState& state, Signal signal) { return base::degrees(state[signal].value_or(-999)); }

TEST(PosedAircraft, StandsWhereItIsPutAndKnowsTheGround) {
    const test_support::FlownFiles files;
    DisplaySession session(files.options("unused").picture, false);
    const flight::AircraftState state = posed_aircraft({47.03, 369.68, 2500, -40, -6, 12}, session.display());
    EXPECT_NEAR(degrees_of(state, Signal::latitude), 47.03, 1e-12);
    EXPECT_NEAR(degrees_of(state, Signal::longitude), 9.68, 1e-9) << "turned into one circle";
    EXPECT_NEAR(degrees_of(state, Signal::true_heading), 320, 1e-9) << "likewise";
    EXPECT_NEAR(degrees_of(state, Signal::pitch), -6, 1e-12);
    EXPECT_NEAR(degrees_of(state, Signal::roll), 12, 1e-12);
    EXPECT_EQ(state[Signal::true_altitude].value_or(0), 2500);
    EXPECT_NEAR(state[Signal::ellipsoid_height].value_or(0), 2548, 2) << "EGM96 over the Alps";
    EXPECT_EQ(state.own_ship.state, base::SignalState::valid);
    EXPECT_TRUE(state.own_ship.height_is_geometric);
    const double above_ground = state[Signal::height_above_terrain].value_or(0);
    EXPECT_GT(above_ground, 0);
    const flight::AircraftState higher = posed_aircraft({47.03, 9.68, 2600, -40, -6, 12}, session.display());
    EXPECT_NEAR(higher[Signal::height_above_terrain].value_or(0), above_ground + 100, 1e-3);
}

TEST(PosedAircraft, WithoutTerrainTheGroundIsNotKnown) {
    PictureOptions options;
    options.size = PictureSize{64, 48};
    DisplaySession session(options, false);
    const flight::AircraftState state = posed_aircraft({47.03, 9.68, 2500, 0, 0, 0}, session.display());
    EXPECT_FALSE(state[Signal::height_above_terrain].received());
    EXPECT_NEAR(state[Signal::ellipsoid_height].value_or(0), 2548, 2) << "from the installed grid";
}

}  // namespace
}  // namespace tedavis::host_sim::test_posed_aircraft
