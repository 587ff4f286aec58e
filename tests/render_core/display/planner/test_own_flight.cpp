#include "render_core/display/planner/own_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::display::test_own_flight {
namespace {

using base::Duration;
using base::SignalState;
using flight::Signal;

constexpr base::Time kStart{50'000'000'000};
constexpr base::Time kDate{1'780'315'200'000'000'000};

base::Time at(double seconds) { return kStart + Duration::from_seconds(seconds); }

/// Eastward along 46.8 N, wind 10 m/s from the west, a degree colder each 10 s.
flight::AircraftState aircraft(double seconds) {
    flight::AircraftState state;
    state.own_ship.position = {base::radians(46.8), base::radians(9.8 + 0.001 * seconds), {2500}};
    state.own_ship.state = SignalState::valid;
    state.own_ship.height_is_geometric = true;
    const auto set = [&](Signal signal, double value) {
        state[signal] = {value, at(seconds)};
        state.limits[static_cast<std::size_t>(signal)] = {Duration::seconds(10), Duration::seconds(30)};
    };
    set(Signal::wind_speed, 10);
    set(Signal::wind_direction, base::radians(270));
    set(Signal::outside_temperature, 280 - 0.1 * seconds);
    set(Signal::horizontal_accuracy, 7);
    return state;
}

class OwnFlightTest : public ::testing::Test {
protected:
    OwnFlightTest() : block_(8192) {
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(own_.start(arena));
    }
    void fly(double from, double to) {
        for (double second = from; second < to - 1e-6; second += 0.5) way_.step(aircraft(second), at(second));
    }
    void take(const flight::AircraftState& state, double now) {
        const flight::FlightTime time{kDate + Duration::from_seconds(now), true, true};
        own_.take({&way_, &state, at(now)}, time, ground_);
    }
    void take(double now) { take(aircraft(now), now); }
    [[nodiscard]] double value(const char* attribute, std::size_t n) const {
        return static_cast<double>(own_.trail().find(attribute)->values[n]);
    }

    std::vector<unsigned char> block_;
    test_support::LevelGround ground_;
    flight::FlightTrail way_;
    OwnFlight own_;
};

TEST_F(OwnFlightTest, TheTrailLeadsToTheOwnShip) {
    fly(0, 21);
    take(21);
    const scene::Layer& trail = own_.trail();
    ASSERT_EQ(trail.entry->feature_count, 1u);
    ASSERT_EQ(trail.entry->point_count, 12u) << "eleven and the own ship";
    EXPECT_EQ(trail.points_of(0).count, 12u);
    EXPECT_DOUBLE_EQ(trail.points[11].longitude_rad, base::radians(9.821));
    EXPECT_EQ(trail.points[5].time_ns, (kDate + Duration::seconds(10)).ns) << "by the flight's time";
    EXPECT_EQ(trail.entry->data_time_ns, (kDate + Duration::seconds(21)).ns);
    EXPECT_NEAR(value("temperature", 5), 279, 1e-3);
    EXPECT_EQ(value("wind_speed", 5), 10);
    EXPECT_EQ(value("position_accuracy", 5), 7);
    EXPECT_TRUE(std::isnan(value("height_accuracy", 5)));
    EXPECT_EQ(trail.entry->position_accuracy_m, OwnFlight::kUnstatedAccuracy_m);
    EXPECT_NEAR(static_cast<double>(trail.find("temperature")->entry->minimum), 277.9, 1e-3);
    EXPECT_NEAR(static_cast<double>(trail.find("temperature")->entry->maximum), 280, 1e-3);
}

TEST_F(OwnFlightTest, AGapPartsTheTrailAndTheOwnShipIsLeftOut) {
    fly(0, 10);
    fly(20, 30);
    take(30);
    EXPECT_EQ(own_.trail().entry->feature_count, 2u);
    EXPECT_EQ(own_.trail().points_of(0).count, 5u);
    EXPECT_EQ(own_.trail().points_of(1).count, 6u);
    flight::AircraftState lost = aircraft(30);
    lost.own_ship.state = SignalState::lost;
    take(lost, 30);
    EXPECT_EQ(own_.trail().points_of(1).count, 5u) << "nobody knows where it is";
    take(aircraft(39), 39);
    EXPECT_EQ(own_.trail().points_of(1).count, 5u) << "there has been no step for too long";
}

TEST_F(OwnFlightTest, HoldsAWholeWayOfShortParts) {
    for (int n = 0; n < 200; ++n) way_.step(aircraft(6 * n), at(6 * n));
    take(6 * 199);
    EXPECT_EQ(own_.trail().entry->feature_count, flight::FlightTrail::kMax);
    EXPECT_EQ(own_.trail().entry->point_count, OwnFlight::kMaxPoints);
}

TEST_F(OwnFlightTest, HeightsByPressureStandOnTheGeoid) {
    flight::AircraftState state = aircraft(0);
    state.own_ship.height_is_geometric = false;
    way_.step(state, at(0));
    take(state, 0);
    EXPECT_EQ(own_.trail().points[0].height_m, 2550);
}

TEST_F(OwnFlightTest, WindsStandWhereTheyWereMeasured) {
    fly(0, 100);
    take(100);
    EXPECT_EQ(own_.winds().entry->feature_count, 5u) << "every 30 s from 0 on, and here";
    const glm::dvec3 eye = earth::to_ecef({base::radians(46.8), base::radians(9.8), {9000}});
    const auto glyphs = own_.wind_glyphs(eye);
    ASSERT_EQ(glyphs.size(), 5u);
    const glm::dvec3 second = earth::to_ecef({base::radians(46.8), base::radians(9.83), {2500}}) - eye;
    EXPECT_LT(glm::distance(glm::dvec3(glyphs[1].summary.place), second), 0.1);
    const scene::Wind wind = scene::wind_of(glyphs[1].summary);
    EXPECT_EQ(wind.state, scene::WindState::steady);
    EXPECT_NEAR(base::degrees(wind.from_rad), 270, 1e-3);
    EXPECT_NEAR(wind.speed_mps, 10, 1e-5);
    EXPECT_EQ(own_.winds().entry->data_time_ns, (kDate + Duration::seconds(100)).ns);
    const glm::dvec3 first = glm::dvec3(glyphs[0].summary.place);
    fly(100, 130);
    take(130);
    EXPECT_EQ(glm::dvec3(own_.wind_glyphs(eye)[0].summary.place), first) << "they do not wander";
}

TEST_F(OwnFlightTest, WithoutAValidWindThereAreNone) {
    fly(0, 100);
    for (const Signal signal : {Signal::wind_speed, Signal::wind_direction}) {
        flight::AircraftState state = aircraft(100);
        state[signal] = {0.0, at(89)};  // stale
        take(state, 100);
        EXPECT_EQ(own_.winds().entry->feature_count, 0u);
        EXPECT_TRUE(own_.wind_glyphs({}).empty());
        EXPECT_EQ(own_.winds().entry->data_time_ns, scene::kNoTime);
        EXPECT_GT(own_.trail().entry->point_count, 0u);
    }
    flight::AircraftState nan = aircraft(100);
    nan[Signal::wind_speed] = {NAN, at(100)};
    take(nan, 100);
    EXPECT_EQ(own_.winds().entry->feature_count, 0u);
}

TEST_F(OwnFlightTest, WithoutAWayThereIsNothing) {
    const flight::AircraftState state = aircraft(0);
    own_.take({nullptr, &state, at(0)}, {}, ground_);
    EXPECT_EQ(own_.trail().entry->feature_count, 0u);
    EXPECT_EQ(own_.winds().entry->feature_count, 0u);
    own_.take({&way_, &state, at(0)}, {}, ground_);
    EXPECT_EQ(own_.trail().entry->point_count, 0u);
}

TEST(OwnFlight, TooSmallAnArenaIsRefused) {
    std::vector<unsigned char> block(4096);
    base::Arena arena(block.data(), block.size());
    OwnFlight own;
    EXPECT_FALSE(own.start(arena));
}

}  // namespace
}  // namespace tedavis::display::test_own_flight
