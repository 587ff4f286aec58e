#include "render_core/flight/posed_state.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"

namespace tedavis::flight::test_posed_state {
namespace {

TEST(PosedState, HasThePoseAndNothingElse) {
    const base::Time time{5'000'000'000};
    const AircraftState state = posed_state({0.8, base::radians(370), 2100, base::radians(-90), 0.1, -0.2}, {48}, time);
    EXPECT_TRUE(state.is_posed);
    EXPECT_EQ(state.own_ship.state, base::SignalState::valid);
    EXPECT_NEAR(state.own_ship.position.longitude_rad, base::radians(10), 1e-12);
    EXPECT_EQ(state.own_ship.position.height.m, 2148) << "above the ellipsoid";
    EXPECT_NEAR(state[Signal::true_heading].value_or(0), base::radians(270), 1e-12);
    EXPECT_EQ(state[Signal::true_altitude].value_or(0), 2100);
    EXPECT_EQ(state[Signal::roll].value_or(0), -0.2);
    std::size_t stated = 0;
    for (const auto& signal : state.signals) stated += signal.state(time, {}) == base::SignalState::missing ? 0 : 1;
    EXPECT_EQ(stated, 7u);
}

}  // namespace
}  // namespace tedavis::flight::test_posed_state
