#include "render_core/flight/flight_trail.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "render_core/base/units.hpp"

namespace tedavis::flight::test_flight_trail {
namespace {

using base::Duration;
using base::SignalState;

constexpr double kMetresPerRad = 6.37e6;
constexpr base::Time kStart{7'000'000'000};

base::Time at(double seconds) { return kStart + Duration::from_seconds(seconds); }

/// Northward at 100 m/s, with wind, temperature and figures of merit.
AircraftState aircraft(double seconds) {
    AircraftState state;
    state.own_ship.position = {base::radians(46.0) + 100 * seconds / kMetresPerRad, base::radians(9.0), {2000 + seconds}};
    state.own_ship.state = SignalState::valid;
    state.own_ship.height_is_geometric = true;
    const auto set = [&](Signal signal, double value) {
        state[signal] = {value, at(seconds)};
        state.limits[static_cast<std::size_t>(signal)] = {Duration::seconds(10), Duration::seconds(30)};
    };
    set(Signal::wind_speed, 12);
    set(Signal::wind_direction, 1.5);
    set(Signal::outside_temperature, 271);
    set(Signal::horizontal_accuracy, 3);
    set(Signal::vertical_accuracy, 5);
    return state;
}

struct Flight {
    /// Steps of 20 ms, `from` included, `to` not.
    void fly(double from, double to) {
        for (int n = static_cast<int>(std::lround(from * 50)); n < static_cast<int>(std::lround(to * 50)); ++n)
            way.step(aircraft(0.02 * n), at(0.02 * n));
    }
    [[nodiscard]] std::size_t parts() const {
        std::size_t count = 0;
        for (std::size_t n = 0; n < way.size(); ++n) count += way[n].begins ? 1 : 0;
        return count;
    }
    FlightTrail way;
};

TEST(FlightTrail, HasAPointEveryTwoSeconds) {
    Flight flight;
    flight.fly(0, 60);
    ASSERT_EQ(flight.way.size(), 30u);
    EXPECT_EQ(flight.parts(), 1u);
    EXPECT_TRUE(flight.way[0].begins);
    for (std::size_t n = 0; n < 30; ++n) {
        EXPECT_EQ((flight.way[n].at - kStart).ns, Duration::seconds(2 * static_cast<std::int64_t>(n)).ns);
        EXPECT_NEAR(static_cast<double>(flight.way[n].height_m), 2000.0 + 2 * static_cast<double>(n), 1e-3);
    }
    const FlownPoint& point = flight.way[7];
    EXPECT_EQ(point.wind_speed_mps, 12);
    EXPECT_EQ(point.wind_from_rad, 1.5f);
    EXPECT_EQ(point.temperature_k, 271);
    EXPECT_EQ(point.position_accuracy_m, 3);
    EXPECT_EQ(point.height_accuracy_m, 5);
}

TEST(FlightTrail, KeepsTheLatestAndTheirNumbers) {
    Flight flight;
    flight.fly(0, 600);
    ASSERT_EQ(flight.way.size(), FlightTrail::kMax);
    EXPECT_EQ(flight.way.number_of_oldest(), 300 - FlightTrail::kMax);
    EXPECT_EQ((flight.way[FlightTrail::kMax - 1].at - kStart).ns, Duration::seconds(598).ns);
    EXPECT_EQ((flight.way[0].at - kStart).ns, Duration::seconds(2 * (300 - FlightTrail::kMax)).ns);
}

TEST(FlightTrail, AGapEndsAPart) {
    Flight flight;
    flight.fly(0, 20);
    AircraftState stale = aircraft(20);
    stale.own_ship.state = SignalState::stale;
    flight.way.step(stale, at(20));  // one step without a place
    EXPECT_FALSE(flight.way.goes_on_to(flown_point(aircraft(20.02), at(20.02))));
    flight.fly(20.02, 30);
    EXPECT_EQ(flight.parts(), 2u);
    flight.fly(36, 40);  // no step for six seconds
    EXPECT_EQ(flight.parts(), 3u);
    flight.fly(44, 50);  // for four
    EXPECT_EQ(flight.parts(), 3u) << "control";
    AircraftState by_pressure = aircraft(50);
    by_pressure.own_ship.height_is_geometric = false;
    EXPECT_FALSE(flight.way.goes_on_to(flown_point(by_pressure, at(50)))) << "heights of two kinds are not joined";
}

TEST(FlightTrail, LeapsAndTimeThatRunsBackClearIt) {
    Flight flight;
    flight.fly(0, 20);
    AircraftState elsewhere = aircraft(20);
    elsewhere.own_ship.position.longitude_rad += base::radians(0.5);
    EXPECT_FALSE(flight.way.goes_on_to(flown_point(elsewhere, at(20))));
    flight.way.step(elsewhere, at(20));
    ASSERT_EQ(flight.way.size(), 1u);
    EXPECT_TRUE(flight.way[0].begins);
    EXPECT_EQ(flight.way.number_of_oldest(), 10u);
    flight.fly(15, 16);
    EXPECT_EQ(flight.way.size(), 1u);
    EXPECT_EQ((flight.way[0].at - kStart).ns, Duration::seconds(15).ns);
    AircraftState nowhere = aircraft(16);
    nowhere.own_ship.position.latitude_rad = NAN;
    flight.way.step(nowhere, at(18));
    EXPECT_EQ(flight.way.size(), 1u);
    EXPECT_FALSE(flight.way.goes_on_to(flown_point(aircraft(18.02), at(18.02))));
}

TEST(FlightTrail, WhatIsNotValidIsNotMeasured) {
    AircraftState state = aircraft(0);
    state[Signal::wind_direction] = {1.5, at(0), base::Quality::bad};
    state[Signal::outside_temperature] = {271, at(-11)};
    state[Signal::vertical_accuracy] = {};
    const FlownPoint point = flown_point(state, at(0));
    EXPECT_TRUE(std::isnan(point.wind_speed_mps)) << "a wind of no direction";
    EXPECT_TRUE(std::isnan(point.wind_from_rad));
    EXPECT_TRUE(std::isnan(point.temperature_k)) << "stale";
    EXPECT_TRUE(std::isnan(point.height_accuracy_m));
    EXPECT_EQ(point.position_accuracy_m, 3);
    state[Signal::wind_direction] = {NAN, at(0)};
    EXPECT_TRUE(std::isnan(flown_point(state, at(0)).wind_from_rad));
}

TEST(FlightTrail, ACopyGoesOnBitForBit) {
    Flight whole, first;
    whole.fly(0, 90);
    first.fly(0, 41);
    Flight rest;
    std::memcpy(static_cast<void*>(&rest.way), &first.way, sizeof rest.way);
    rest.fly(41, 90);
    ASSERT_EQ(rest.way.size(), whole.way.size());
    for (std::size_t n = 0; n < whole.way.size(); ++n) {
        EXPECT_EQ(rest.way[n].latitude_rad, whole.way[n].latitude_rad);
        EXPECT_EQ(rest.way[n].at, whole.way[n].at);
    }
}

}  // namespace
}  // namespace tedavis::flight::test_flight_trail
