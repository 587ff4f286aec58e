#include "render_core/flight/airspeed_trend.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::flight::test_airspeed_trend {
namespace {

base::Time at(double seconds) { return base::Time{1'000'000'000'000} + base::Duration::from_seconds(seconds); }

AircraftState with_airspeed(double mps, double seconds, Signal source = Signal::indicated_airspeed) {
    AircraftState state;
    state[source] = {mps, at(seconds)};
    return state;
}

TEST(AirspeedTrend, ASteadyChangeIsStatedExactlyOnceItHasSettled) {
    AirspeedTrend trend;
    for (int i = 0; i < 20; ++i) trend.step(with_airspeed(50 + 0.15 * i, 0.1 * i), at(0.1 * i));
    EXPECT_FALSE(trend.rate().received()) << "1.9 s are too short";
    for (int i = 20; i < 120; ++i) trend.step(with_airspeed(50 + 0.15 * i, 0.1 * i), at(0.1 * i));
    EXPECT_NEAR(trend.rate().value_or(0), 1.5, 1e-4);
    EXPECT_EQ(trend.rate().source_time(), at(11.9));
}

/// Steps between samples, as the tracker makes them, change nothing.
TEST(AirspeedTrend, DoesNotDependOnHowOftenItIsAsked) {
    AirspeedTrend once, often;
    for (int i = 0; i < 60; ++i) {
        const AircraftState state = with_airspeed(60 + std::sin(0.3 * i), 0.1 * i);
        once.step(state, at(0.1 * i));
        for (int n = 0; n < 5; ++n) often.step(state, at(0.1 * i + 0.02 * n));
    }
    EXPECT_EQ(once.rate().value_or(0), often.rate().value_or(1));
}

TEST(AirspeedTrend, BeginsAnewAfterAGapAndWithAnotherSource) {
    const auto settled = [] {
        AirspeedTrend trend;
        for (int i = 0; i < 40; ++i) trend.step(with_airspeed(50 + 0.5 * i, 0.1 * i), at(0.1 * i));
        return trend;
    };
    AirspeedTrend trend = settled();
    EXPECT_TRUE(trend.rate().received());
    trend.step(with_airspeed(90, 5.1), at(5.1));
    EXPECT_FALSE(trend.rate().received()) << "1.2 s without a sample";
    trend = settled();
    trend.step(with_airspeed(70, 4.0, Signal::calibrated_airspeed), at(4.0));
    EXPECT_FALSE(trend.rate().received()) << "the difference of two instruments is no change";
    trend = settled();
    trend.step(with_airspeed(87.5, 4.0), at(4.0));
    EXPECT_FALSE(trend.rate().received()) << "a leap to another sensor's value";
    trend = settled();
    trend.step({}, at(4.0));
    EXPECT_FALSE(trend.rate().received());
}

}  // namespace
}  // namespace tedavis::flight::test_airspeed_trend
