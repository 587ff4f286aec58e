#include "host_sim/importers/resampled_flight.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/flight_log/pressure_altitude.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_resampled_flight {
namespace {

using flight::Signal;

const GeoidEgm96& geoid() {
    static const GeoidEgm96 grid = GeoidEgm96::installed();
    return grid;
}

constexpr double kLatitude = 46.5, kLongitude = 9.75, kSpeed = 60.0, kTurnRate = 0.05;

base::Time second(double s) { return base::Time{} + base::Duration::from_seconds(1.6e9 + s); }

/// A level circle flown at kSpeed: the positions are known exactly at every instant.
struct Circle {
    double radius = kSpeed / kTurnRate;
    [[nodiscard]] double north(double s) const { return radius * std::sin(kTurnRate * s); }
    [[nodiscard]] double east(double s) const { return radius * (1 - std::cos(kTurnRate * s)); }
    [[nodiscard]] double latitude(double s) const {
        return base::radians(kLatitude) + north(s) / earth::meridian_radius_m(base::radians(kLatitude));
    }
    [[nodiscard]] double longitude(double s) const {
        return base::radians(kLongitude) +
               east(s) / (earth::prime_vertical_radius_m(base::radians(kLatitude)) * std::cos(base::radians(kLatitude)));
    }
};

RecordedFlight circle_flight(double interval_s, int count) {
    RecordedFlight flight;
    for (int i = 0; i < count; ++i) {
        RecordedFix fix;
        fix.time = second(i * interval_s);
        fix.latitude_rad = Circle().latitude(i * interval_s);
        fix.longitude_rad = Circle().longitude(i * interval_s);
        fix.gnss_height_m = 2000.0;
        flight.fixes.push_back(fix);
    }
    return flight;
}

double off_circle_m(const SignalSample& sample, double s) {
    return earth::surface_distance_m({sample[Signal::latitude], sample[Signal::longitude], {}},
                                     {Circle().latitude(s), Circle().longitude(s), {}});
}

TEST(ResampledFlight, FollowsACoordinatedTurn) {
    const ResampledFlight resampled(circle_flight(1.0, 126), {}, geoid(), "circle");
    const double bank = std::atan(kSpeed * kTurnRate / base::kStandardGravity);
    for (double s = 5; s < 120; s += 0.137) {
        const SignalSample sample = resampled.at(second(s)).value();
        EXPECT_LT(off_circle_m(sample, s), 0.05) << s;
        EXPECT_NEAR(sample[Signal::ground_speed], kSpeed, 0.4) << s;
        EXPECT_NEAR(earth::angle_difference(sample[Signal::true_track], kTurnRate * s), 0, 0.01) << s;
        EXPECT_EQ(sample[Signal::true_heading], sample[Signal::true_track]);
        EXPECT_NEAR(sample[Signal::roll], bank, base::radians(0.5)) << s;
        EXPECT_NEAR(sample[Signal::pitch], 0, base::radians(0.1)) << s;
        EXPECT_NEAR(sample[Signal::ellipsoid_height], 2000, 1e-6);
    }
}

TEST(ResampledFlight, PassesThroughItsFixes) {
    const RecordedFlight flight = circle_flight(5.0, 20);
    const ResampledFlight resampled(flight, {}, geoid(), "circle");
    for (const RecordedFix& fix : flight.fixes) {
        const SignalSample sample = resampled.at(fix.time).value();
        EXPECT_NEAR(sample[Signal::latitude], fix.latitude_rad, 1e-13);
        EXPECT_NEAR(sample[Signal::longitude], fix.longitude_rad, 1e-13);
    }
}

TEST(ResampledFlight, HeadingIsContinuousThroughNorth) {
    const ResampledFlight resampled(circle_flight(1.0, 140), {}, geoid(), "circle");
    double last = resampled.at(second(100)).value()[Signal::true_heading];
    for (double s = 100; s < 138; s += 0.02) {  // passes north at 125.7 s
        const double heading = resampled.at(second(s)).value()[Signal::true_heading];
        EXPECT_LT(std::abs(earth::angle_difference(heading, last)), 0.01) << s;
        EXPECT_GE(heading, 0);
        EXPECT_LT(heading, 2 * base::kPi);
        last = heading;
    }
}

TEST(ResampledFlight, StandsStillWhereTheFixesDo) {
    RecordedFlight flight = circle_flight(1.0, 30);
    for (std::size_t i = 10; i < 20; ++i) {
        flight.fixes[i].latitude_rad = flight.fixes[10].latitude_rad;
        flight.fixes[i].longitude_rad = flight.fixes[10].longitude_rad;
    }
    const ResampledFlight resampled(flight, {}, geoid(), "stop");
    for (double s = 10; s <= 19; s += 0.1) {
        const SignalSample sample = resampled.at(second(s)).value();
        EXPECT_NEAR(sample[Signal::latitude], flight.fixes[10].latitude_rad, 1e-15) << s;
    }
}

TEST(ResampledFlight, SaysNothingInAGap) {
    RecordedFlight flight = circle_flight(1.0, 60);
    for (std::size_t i = 30; i < 60; ++i) flight.fixes[i].time = flight.fixes[i].time + base::Duration::seconds(300);
    const ResampledFlight resampled(flight, {}, geoid(), "gap");
    EXPECT_TRUE(resampled.at(second(29)));
    EXPECT_FALSE(resampled.at(second(29.01)));
    EXPECT_FALSE(resampled.at(second(329.99)));
    EXPECT_TRUE(resampled.at(second(330.01)));
    EXPECT_FALSE(resampled.at(second(-0.01)));
    EXPECT_FALSE(resampled.at(resampled.end() + base::Duration{1'000}));
    EXPECT_EQ(resampled.derivation().segments, 2u);
    EXPECT_NEAR(resampled.derivation().longest_gap_s, 301, 1e-6);
}

TEST(ResampledFlight, JoinsNothingAcrossMoreThanTenMinutes) {
    RecordedFlight sparse = circle_flight(1.0, 12);
    for (std::size_t i = 0; i < 12; ++i) sparse.fixes[i].time = second(300.0 * static_cast<double>(i));
    EXPECT_EQ(gap_limit_s(sparse), 600);
    sparse.fixes.resize(2);
    sparse.fixes[1].time = second(7200);
    EXPECT_EQ(gap_limit_s(sparse), 600) << "two fixes are no measure of what is usual";
    test_support::expect_user_error([&] { ResampledFlight(sparse, {}, geoid(), "two"); }, "two: no two fixes");
    EXPECT_EQ(gap_limit_s(circle_flight(1.0, 12)), 20);
    EXPECT_EQ(gap_limit_s(circle_flight(10.0, 12)), 40);
}

TEST(ResampledFlight, CrossesTheAntimeridian) {
    RecordedFlight flight;
    for (int i = 0; i < 20; ++i) {
        RecordedFix fix;
        fix.time = second(i);
        fix.longitude_rad = earth::wrap_longitude(base::radians(179.995 + 0.0005 * i));
        flight.fixes.push_back(fix);
    }
    const ResampledFlight resampled(flight, {}, geoid(), "antimeridian");
    for (double s = 2; s < 17; s += 0.05) {
        const SignalSample sample = resampled.at(second(s)).value();
        EXPECT_NEAR(sample[Signal::ground_speed], 55.66, 0.1) << s;
        EXPECT_NEAR(sample[Signal::true_track], base::kPi / 2, 1e-6) << s;
        EXPECT_GE(sample[Signal::longitude], -base::kPi);
        EXPECT_LT(sample[Signal::longitude], base::kPi);
    }
}

TEST(ResampledFlight, ConvertsSeaLevelHeightsWithTheGeoid) {
    RecordedFlight flight = circle_flight(1.0, 30);
    flight.gnss_datum = HeightDatum::msl_egm96;
    const double undulation = geoid().undulation(flight.fixes[15].latitude_rad, flight.fixes[15].longitude_rad).m;
    const SignalSample sample = ResampledFlight(flight, {}, geoid(), "msl").at(second(15)).value();
    EXPECT_NEAR(sample[Signal::ellipsoid_height], 2000 + undulation, 0.01);
    EXPECT_NEAR(sample[Signal::true_altitude], 2000, 0.01);
    for (RecordedFix& fix : flight.fixes) fix.geoid_separation_m = 40;
    EXPECT_NEAR(ResampledFlight(flight, {}, geoid(), "own").at(second(15)).value()[Signal::ellipsoid_height], 2040, 1e-6);
}

RecordedFlight barometric_flight() {
    RecordedFlight flight = circle_flight(1.0, 30);
    for (RecordedFix& fix : flight.fixes) {
        fix.gnss_height_m.reset();
        fix.pressure_altitude_m = 1500;
    }
    return flight;
}

TEST(ResampledFlight, WithoutAGnssHeightStatesNoGeometricOne) {
    const ResampledFlight resampled(barometric_flight(), {}, geoid(), "baro");
    const SignalSample sample = resampled.at(second(10)).value();
    EXPECT_FALSE(sample.has(Signal::ellipsoid_height));
    EXPECT_FALSE(sample.has(Signal::baro_altitude));
    EXPECT_EQ(sample[Signal::standard_altitude], 1500);
    EXPECT_FALSE(resampled.derivation().height_is_geometric);
}

TEST(ResampledFlight, TurnsPressureAltitudeIntoAltitudeOnQnh) {
    ResampleSettings settings;
    settings.qnh_pa = 103000;
    const SignalSample sample = ResampledFlight(barometric_flight(), settings, geoid(), "qnh").at(second(10)).value();
    EXPECT_EQ(sample[Signal::baro_setting], 103000);
    EXPECT_EQ(sample[Signal::baro_altitude], altitude_on_qnh(1500, 103000));
    EXPECT_FALSE(sample.has(Signal::ellipsoid_height));
}

TEST(ResampledFlight, AssumesGeometricOnlyWhenAsked) {
    ResampleSettings settings;
    settings.assume_geometric = true;
    const ResampledFlight resampled(barometric_flight(), settings, geoid(), "assumed");
    const SignalSample sample = resampled.at(second(10)).value();
    EXPECT_EQ(sample[Signal::true_altitude], 1500);
    EXPECT_NEAR(sample[Signal::ellipsoid_height] - 1500,
                geoid().undulation(sample[Signal::latitude], sample[Signal::longitude]).m, 0.01);
    EXPECT_TRUE(resampled.derivation().height_is_geometric);
}

TEST(ResampledFlight, KeepsRecordedAttitude) {
    RecordedFlight flight = circle_flight(1.0, 30);
    for (RecordedFix& fix : flight.fixes) {
        fix.roll_rad = 0.3;
        fix.pitch_rad = -0.1;
        fix.true_heading_rad = 6.2;
    }
    const SignalSample sample = ResampledFlight(flight, {}, geoid(), "attitude").at(second(10.5)).value();
    EXPECT_EQ(sample[Signal::roll], 0.3);
    EXPECT_EQ(sample[Signal::pitch], -0.1);
    EXPECT_NEAR(sample[Signal::true_heading], 6.2, 1e-12);
}

/// What the positions do, by their difference over a tenth of a second.
struct FlownVelocity {
    double north_mps, east_mps;
};
FlownVelocity flown(const ResampledFlight& resampled, double s) {
    const SignalSample before = resampled.at(second(s - 0.05)).value(), after = resampled.at(second(s + 0.05)).value();
    const double latitude = 0.5 * (before[Signal::latitude] + after[Signal::latitude]);
    return {(after[Signal::latitude] - before[Signal::latitude]) * earth::meridian_radius_m(latitude) / 0.1,
            (after[Signal::longitude] - before[Signal::longitude]) * earth::prime_vertical_radius_m(latitude) *
                std::cos(latitude) / 0.1};
}

/// Straight north, from the fifth fix on north-east along a straight line, while the recorded track still turns slowly.
RecordedFlight bent_flight(double interval_s) {
    RecordedFlight flight = circle_flight(interval_s, 12);
    for (std::size_t i = 0; i < flight.fixes.size(); ++i) {
        const double along = static_cast<double>(i) * interval_s * 87, beyond = i < 5 ? 0 : along - 5 * interval_s * 87;
        RecordedFix& fix = flight.fixes[i];
        fix.latitude_rad = base::radians(kLatitude) + along / earth::meridian_radius_m(base::radians(kLatitude));
        fix.longitude_rad = base::radians(kLongitude) + 0.28 * beyond / 4.4e6;
        fix.ground_speed_mps = 88;
        fix.true_track_rad = i < 5 ? 0 : 0.03 * static_cast<double>(i - 5);
    }
    return flight;
}

TEST(ResampledFlight, FarApartFixesHaveTheVelocityOfTheirPositions) {
    const ResampledFlight bent(bent_flight(10), {}, geoid(), "bent"), circle(circle_flight(10, 12), {}, geoid(), "circle");
    for (double s = 1.03; s < 109; s += 0.31) {
        for (const ResampledFlight* resampled : {&bent, &circle}) {
            const FlownVelocity positions = flown(*resampled, s);
            const SignalSample sample = resampled->at(second(s)).value();
            const double speed = sample[Signal::ground_speed], track = sample[Signal::true_track];
            EXPECT_NEAR(speed * std::cos(track), positions.north_mps, 0.25) << s;
            EXPECT_NEAR(speed * std::sin(track), positions.east_mps, 0.25) << s;
            EXPECT_EQ(sample[Signal::true_heading], track);
        }
        EXPECT_NEAR(circle.at(second(s)).value()[Signal::ground_speed], kSpeed, 4) << s;
    }
    const SignalSample from = bent.at(second(50)).value(), to = bent.at(second(60)).value();
    const auto east = [](const SignalSample& sample) {
        return sample[Signal::ground_speed] * std::sin(sample[Signal::true_track]);
    };
    EXPECT_GT(flown(bent, 55).east_mps - 0.5 * (east(from) + east(to)), 8) << "control: halfway between those of its fixes";
}

/// Positions of each second jitter, and their own velocities do so more: the recorded one is stated.
TEST(ResampledFlight, NearFixesKeepTheirRecordedVelocity) {
    RecordedFlight flight = bent_flight(1);
    flight.fixes.resize(5);
    flight.fixes[2].latitude_rad += 3 / earth::meridian_radius_m(base::radians(kLatitude));
    const ResampledFlight resampled(flight, {}, geoid(), "near");
    EXPECT_EQ(resampled.at(second(1.5)).value()[Signal::ground_speed], 88);
    EXPECT_GT(flown(resampled, 1.5).north_mps, 89) << "control";
}

TEST(ResampledFlight, DoesNotBelieveASpeedThatThePositionsContradict) {
    RecordedFlight flight = circle_flight(1.0, 60);
    for (std::size_t i = 0; i < flight.fixes.size(); ++i) {
        flight.fixes[i].ground_speed_mps = kSpeed;
        flight.fixes[i].true_track_rad = earth::wrap_heading(kTurnRate * static_cast<double>(i));
    }
    flight.fixes[30].true_track_rad = 0;  // a stale message: the track half a minute ago
    const ResampledFlight resampled(flight, {}, geoid(), "ghost");
    EXPECT_EQ(resampled.derivation().velocities_not_believed, 1u);
    EXPECT_NEAR(resampled.at(second(30)).value()[Signal::true_track], kTurnRate * 30, 0.02);
}

TEST(ResampledFlight, HeightsOnlyWhereTheyWereRecorded) {
    RecordedFlight flight = circle_flight(1.0, 120);
    for (std::size_t i = 0; i < 60; ++i) flight.fixes[i].gnss_height_m.reset();
    const ResampledFlight resampled(flight, {}, geoid(), "late");
    EXPECT_FALSE(resampled.at(second(30)).value().has(Signal::ellipsoid_height));
    EXPECT_TRUE(resampled.at(second(61)).value().has(Signal::ellipsoid_height));
}

TEST(ResampledFlight, RefusesFlightsOfMoreThanAWeek) {
    RecordedFlight flight = circle_flight(1.0, 60);
    for (std::size_t i = 30; i < 60; ++i) flight.fixes[i].time = flight.fixes[i].time + base::Duration::seconds(9 * 86400);
    test_support::expect_user_error([&] { ResampledFlight(flight, {}, geoid(), "years.csv"); },
                                    "years.csv: its fixes span 9 days");
}

TEST(ResampledFlight, RefusesTooSparseFlights) {
    RecordedFlight one = circle_flight(1.0, 1);
    test_support::expect_user_error([&] { ResampledFlight(one, {}, geoid(), "one.igc"); }, "one.igc: no two fixes");
}

}  // namespace
}  // namespace tedavis::host_sim::test_resampled_flight
