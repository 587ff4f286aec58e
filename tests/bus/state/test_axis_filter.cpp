#include "bus/state/axis_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::bus::test_axis_filter {
namespace {

using base::Duration;

constexpr Duration kLimit = Duration::milliseconds(250);

base::Time at(double seconds) { return base::Time{1'000'000'000'000} + Duration::from_seconds(seconds); }
AxisMeasurement position(double seconds, double value, double sigma = 1) { return {at(seconds), value, sigma, 1, false}; }
AxisMeasurement velocity(double seconds, double value) { return {at(seconds), value, 0.1, 1, true}; }

TEST(AxisFilter, NothingBeforeTheFirstPosition) {
    AxisFilter filter;
    EXPECT_FALSE(filter.estimate(at(0), kLimit).started);
    (void)filter.add(velocity(0, 10));
    EXPECT_FALSE(filter.estimate(at(0), kLimit).started);
    (void)filter.add(position(0.1, 500));
    EXPECT_EQ(filter.estimate(at(0.1), kLimit).position, 500);
}

TEST(AxisFilter, SteadyMotionIsFollowedAndExtrapolated) {
    AxisFilter filter;
    for (int i = 0; i <= 40; ++i) {
        (void)filter.add(position(0.1 * i, 10 + 5.0 * i));
        (void)filter.add(velocity(0.1 * i, 50));
    }
    EXPECT_NEAR(filter.estimate(at(4.0), kLimit).position, 210, 0.01);
    EXPECT_NEAR(filter.estimate(at(4.2), kLimit).position, 220, 0.02);
    EXPECT_NEAR(filter.estimate(at(4.0), kLimit).velocity_mps, 50, 0.05);
}

TEST(AxisFilter, StandsStillBeyondTheLimitInBothDirections) {
    AxisFilter filter;
    for (int i = 0; i <= 20; ++i) (void)filter.add(position(0.1 * i, 5.0 * i));
    EXPECT_EQ(filter.estimate(at(2.25), kLimit).position, filter.estimate(at(99), kLimit).position);
    EXPECT_EQ(filter.estimate(at(99), kLimit).age, Duration::seconds(97));
    EXPECT_EQ(filter.estimate(at(1.75), kLimit).position, filter.estimate(at(-99), kLimit).position);
    for (int i = 0; i < 100; ++i) (void)filter.add(velocity(2.0 + 0.02 * i, 50));
    EXPECT_GT(filter.estimate(at(4), kLimit).age, Duration::milliseconds(1900)) << "velocities do not make a position fresh";
}

TEST(AxisFilter, OrderOfArrivalWithinTheRingDoesNotMatter) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 1);
    std::vector<AxisMeasurement> measurements;
    for (int i = 0; i < 200; ++i) {
        measurements.push_back(position(0.05 * i, 6.4 * i + noise(random)));
        measurements.push_back(velocity(0.05 * i + 0.01, 128 + noise(random)));
    }
    AxisFilter sorted;
    for (const AxisMeasurement& measurement : measurements) ASSERT_TRUE(sorted.add(measurement));
    for (std::size_t i = 0; i + 4 <= measurements.size(); i += 4)
        std::shuffle(measurements.begin() + static_cast<std::ptrdiff_t>(i),
                     measurements.begin() + static_cast<std::ptrdiff_t>(i + 4), random);
    AxisFilter shuffled;
    for (const AxisMeasurement& measurement : measurements) ASSERT_TRUE(shuffled.add(measurement));
    for (const double t : {9.9, 10.0, 10.2}) {
        EXPECT_EQ(sorted.estimate(at(t), kLimit).position, shuffled.estimate(at(t), kLimit).position) << "bit for bit";
        EXPECT_EQ(sorted.estimate(at(t), kLimit).velocity_mps, shuffled.estimate(at(t), kLimit).velocity_mps);
    }
}

TEST(AxisFilter, DuplicatesLateAndBrokenMeasurementsAreDropped) {
    AxisFilter filter;
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(filter.add(position(0.1 * i, i)));
    EXPECT_FALSE(filter.add(position(1.9002, 19)));
    EXPECT_FALSE(filter.add(position(0.5, 5)));
    EXPECT_FALSE(filter.add(position(2.0, NAN)));
    EXPECT_FALSE(filter.add(position(2.0, 20, 0)));
    EXPECT_FALSE(filter.add(position(2.0, 20, NAN)));
    EXPECT_EQ(filter.dropped(), 5u);
    EXPECT_TRUE(filter.add(position(2.0, 20)));
}

TEST(AxisFilter, OneWildPositionIsNotBelievedAMovedTrackIs) {
    AxisFilter filter;
    for (int i = 0; i < 20; ++i) (void)filter.add(position(0.1 * i, 5.0 * i));
    const double before = filter.estimate(at(2.0), kLimit).position;
    (void)filter.add(position(2.0, 9000));
    EXPECT_EQ(filter.estimate(at(2.0), kLimit).position, before);
    for (int i = 1; i <= 4; ++i) (void)filter.add(position(2.0 + 0.1 * i, 9000 + 5.0 * i));
    EXPECT_NEAR(filter.estimate(at(2.4), kLimit).position, 9020, 10);
}

TEST(AxisFilter, AfterAGapItStartsAnew) {
    AxisFilter filter;
    for (int i = 0; i < 20; ++i) (void)filter.add(position(0.1 * i, 5.0 * i));
    (void)filter.add(position(10, 100));
    EXPECT_EQ(filter.estimate(at(10), kLimit).position, 100);
    EXPECT_EQ(filter.estimate(at(10), kLimit).velocity_mps, 0);
}

TEST(AxisFilter, LongitudesCrossTheAntimeridianAsAnyOtherMeridian) {
    constexpr double kMetres = 6.4e6;
    const auto run = [&](double from) {
        AxisFilter filter({4, Duration::seconds(2), true});
        for (int i = 0; i <= 60; ++i) {
            const double longitude = earth::wrap_longitude(from + 1e-6 * i);
            (void)filter.add({at(0.05 * i), longitude, 1, kMetres, false});
        }
        const AxisEstimate estimate = filter.estimate(at(3.1), kLimit);
        EXPECT_GE(estimate.position, -base::kPi);
        EXPECT_LT(estimate.position, base::kPi);
        return earth::angle_difference(estimate.position, from);
    };
    EXPECT_NEAR(run(base::kPi - 30e-6), run(0.5), 1e-12);
}

TEST(AxisFilter, AnyMeasurementsGiveFiniteContinuousEstimates) {
    std::mt19937_64 random(11);
    AxisFilter filter;
    double now = 0;
    double before = 0;
    bool started = false;
    for (int i = 0; i < 300000; ++i) {
        now += static_cast<double>(random() % 100) * 1e-3;
        double stamp = now;
        if (random() % 10 == 0) stamp -= static_cast<double>(random() % 2000) * 1e-3;
        AxisMeasurement measurement =
            random() % 2 == 0 ? position(stamp, 100 * std::sin(stamp * 0.1)) : velocity(stamp, 10 * std::cos(stamp * 0.1));
        if (random() % 5 != 0) (void)filter.add(measurement);
        const AxisEstimate estimate = filter.estimate(at(now), kLimit);
        ASSERT_TRUE(std::isfinite(estimate.position) && std::isfinite(estimate.velocity_mps));
        const bool fresh = started && estimate.age < Duration::seconds(1);
        ASSERT_TRUE(!fresh || std::fabs(estimate.position - before) < 10 + 5) << i;
        before = estimate.position;
        started = estimate.started;
    }
}

}  // namespace
}  // namespace tedavis::bus::test_axis_filter
