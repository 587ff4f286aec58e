#include "host_sim/accuracy/knobs/own_ship_knob.hpp"

#include <gtest/gtest.h>

#include "bus/canaerospace/bus_settings.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"

namespace tedavis::host_sim::test_own_ship_knob {
namespace {

/// NUMERICS A16 has 7.0 m for holding and 0.17 m for the filter at 20 messages a second with 1 m of noise.
TEST(OwnShipKnob, TheFilterIsNearerToTheTruthThanWhatItReplaces) {
    const test_support::MadeKnobGround made;
    const auto knob = make_own_ship_filter_knob(made.quick());
    const double hold = test_support::errors_of(*knob, 0).mean, trusted = test_support::errors_of(*knob, 1).mean,
                 filtered = test_support::errors_of(*knob, 2).mean;
    EXPECT_GT(hold, 2) << "control: an aircraft moves 6 m between two messages";
    EXPECT_LT(trusted, hold);
    EXPECT_LT(filtered, 0.7 * trusted);
    EXPECT_LT(filtered, 1) << "less than the noise of a single position";
    EXPECT_GT(filtered, 10 * knob->facts().reference.error_bound());
}

TEST(OwnShipKnob, ALevelIsWhatTheShippedBusStates) {
    const bus::OwnShipSettings shipped;
    EXPECT_EQ(shipped.acceleration_mps2, 8);
    EXPECT_EQ(shipped.position_noise_m, 1);
    EXPECT_EQ(shipped.extrapolation_limit, base::Duration::milliseconds(250));
}

}  // namespace
}  // namespace tedavis::host_sim::test_own_ship_knob
