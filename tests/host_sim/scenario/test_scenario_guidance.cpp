#include "host_sim/scenario/scenario_guidance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scenario_guidance {
namespace {

using flight::NavigationSource;
using flight::Signal;

std::string shipped_text() { return read_file(test_support::source_dir() + "/configs/scenarios/default.toml"); }

const GeoidEgm96& geoid() {
    static const GeoidEgm96 grid = GeoidEgm96::installed();
    return grid;
}

const Scenario& scenario() {
    static const Scenario parsed = parse_scenario(shipped_text(), "default.toml");
    return parsed;
}

const ScenarioFlight& default_flight() {
    static const ScenarioFlight flight(scenario(), 1, geoid());
    return flight;
}

double duration_s() { return (default_flight().end() - default_flight().begin()).to_seconds(); }

SignalSample sample_at(double time_s) {
    return default_flight().at(default_flight().begin() + base::Duration::from_seconds(time_s)).value();
}

NavigationSource source_in(const SignalSample& sample) {
    return static_cast<NavigationSource>(static_cast<int>(sample[Signal::navigation_source]));
}

/// Metres from a place of the ground, along a true direction and to the right of it, by Earth-centred coordinates.
struct Seen {
    double along_m = 0, right_m = 0;
};
Seen seen_from(double latitude_rad, double longitude_rad, double direction_rad, const SignalSample& sample) {
    const earth::Ecef from = earth::to_ecef({latitude_rad, longitude_rad, {0}});
    const earth::Ecef to = earth::to_ecef({sample[Signal::latitude], sample[Signal::longitude], {0}});
    const double x = to.x - from.x, y = to.y - from.y, z = to.z - from.z;
    const double sp = std::sin(latitude_rad), cp = std::cos(latitude_rad), sl = std::sin(longitude_rad),
                 cl = std::cos(longitude_rad);
    const double east = -sl * x + cl * y, north = -sp * cl * x - sp * sl * y + cp * z;
    return {north * std::cos(direction_rad) + east * std::sin(direction_rad),
            east * std::cos(direction_rad) - north * std::sin(direction_rad)};
}

TEST(ScenarioGuidance, TheSourceThatIsSelectedStatesItsDeviations) {
    int radio = 0, gnss = 0;
    for (double t = 0; t < duration_s(); t += 0.5) {
        const SignalSample sample = sample_at(t);
        if (source_in(sample) == NavigationSource::radio1) {
            ++radio;
            EXPECT_TRUE(sample.has(Signal::ils1_localizer_deviation) && sample.has(Signal::selected_course)) << t;
            EXPECT_TRUE(sample.has(Signal::ils1_glideslope_deviation)) << t;
        } else if (source_in(sample) == NavigationSource::gnss) {
            ++gnss;
            EXPECT_TRUE(sample.has(Signal::cross_track_deviation) && sample.has(Signal::desired_track)) << t;
        }
    }
    EXPECT_GT(radio, 60);
    EXPECT_GT(gnss, 200);
}

TEST(ScenarioGuidance, TheLocalizerPointsToItsAntennaBehindTheStrip) {
    const LandingStrip& strip = scenario().strip;
    int compared = 0;
    for (double t = 0; t < duration_s(); t += 1) {
        const SignalSample sample = sample_at(t);
        if (!sample.has(Signal::ils1_localizer_deviation)) continue;
        const Seen own = seen_from(strip.latitude_rad, strip.longitude_rad, strip.heading_rad, sample);
        const double antenna_m = strip.length_m / 2 + kLocalizerBeyond_m;
        EXPECT_NEAR(sample[Signal::ils1_localizer_deviation], std::atan2(own.right_m, antenna_m - own.along_m), 2e-3) << t;
        ++compared;
    }
    EXPECT_GT(compared, 60);
}

TEST(ScenarioGuidance, OnFinalTheFlightIsOnCourseAndPath) {
    const double landing_s = default_flight().legs()[default_flight().legs().size() - 2].begin_s;
    const SignalSample sample = sample_at(landing_s - 2);
    ASSERT_EQ(source_in(sample), NavigationSource::radio1);
    EXPECT_NEAR(sample[Signal::ils1_localizer_deviation], 0, base::radians(1));
    EXPECT_NEAR(sample[Signal::ils1_glideslope_deviation], 0, base::radians(0.7));
    EXPECT_EQ(sample[Signal::selected_course], scenario().strip.heading_rad);
}

TEST(ScenarioGuidance, TheCrossTrackDeviationIsTheDistanceFromTheStraightLine) {
    for (std::size_t i = 0; i < scenario().legs.size(); ++i) {
        const Leg& leg = scenario().legs[i];
        if (leg.kind != LegKind::fly_to) continue;
        const double middle_s = (default_flight().legs()[i].begin_s + default_flight().legs()[i].end_s) / 2;
        const SignalSample sample = sample_at(middle_s);
        const Seen own = seen_from(leg.latitude_rad, leg.longitude_rad, sample[Signal::desired_track], sample);
        EXPECT_NEAR(sample[Signal::cross_track_deviation], own.right_m, 2 + 1e-3 * std::abs(own.along_m)) << i;
        const double bearing = std::atan2(-own.right_m, -own.along_m) + sample[Signal::desired_track];
        EXPECT_NEAR(std::remainder(sample[Signal::waypoint_bearing] - bearing, 2 * base::kPi), 0, 5e-3) << i;
        EXPECT_FALSE(sample.has(Signal::selected_heading)) << "the route is flown, not a heading";
    }
}

TEST(ScenarioGuidance, TheSelectedAltitudeIsReachedOnTheAltimeter) {
    for (std::size_t i = 0; i < scenario().legs.size(); ++i) {
        const Leg& leg = scenario().legs[i];
        if (leg.kind != LegKind::hold || leg.duration_s > 0) continue;
        const SignalSample sample = sample_at(default_flight().legs()[i].end_s - 0.02);
        EXPECT_NEAR(sample[Signal::baro_altitude], sample[Signal::selected_altitude], 10) << i;
    }
}

TEST(ScenarioGuidance, FlapsFollowTheirLeverAtTheirSpeed) {
    double before = sample_at(0)[Signal::flaps_position];
    int moving = 0;
    for (double t = 0.1; t < duration_s(); t += 0.1) {
        const SignalSample sample = sample_at(t);
        const double moved = sample[Signal::flaps_position] - before;
        EXPECT_LE(std::abs(moved), 0.1 / scenario().guidance->flaps_travel_s + 1e-9) << t;
        if (moved == 0 && t > 10 && sample_at(t - 8)[Signal::flaps_lever] == sample[Signal::flaps_lever]) {
            EXPECT_NEAR(sample[Signal::flaps_position], sample[Signal::flaps_lever], 1e-9) << t;
        }
        moving += moved != 0 ? 1 : 0;
        before = sample[Signal::flaps_position];
    }
    EXPECT_GT(moving, 50);
}

TEST(ScenarioGuidance, TheDirectorAsksForTheAttitudeThatFollows) {
    const double t = default_flight().legs()[4].begin_s + 1;
    const SignalSample now = sample_at(t), later = sample_at(t + kDirectorLead_s);
    EXPECT_NEAR(now[Signal::flight_director_roll], later[Signal::roll] - now[Signal::roll], 2e-3);
    EXPECT_NEAR(now[Signal::flight_director_pitch], later[Signal::pitch] - now[Signal::pitch], 2e-3);
}

TEST(ScenarioGuidance, WithoutItsSectionNothingIsStated) {
    std::string text = shipped_text();
    const std::size_t begin = text.find("[guidance]"), end = text.find("\n\n", begin);
    text.erase(begin, end - begin);
    const ScenarioFlight flight(parse_scenario(text, "plain.toml"), 1, geoid());
    const SignalSample sample = flight.at(flight.begin() + base::Duration::seconds(200)).value();
    EXPECT_FALSE(flight.states_guidance());
    for (const Signal signal : {Signal::navigation_source, Signal::selected_altitude, Signal::flaps_position,
                                Signal::selected_course, Signal::flight_director_roll})
        EXPECT_FALSE(sample.has(signal)) << to_string(signal);
    EXPECT_TRUE(sample.has(Signal::heading_rate)) << "measured, not selected";
}

TEST(ScenarioGuidance, AMinimumBelowTheStripIsAFault) {
    std::string text = shipped_text();
    const std::size_t at = text.find("minimum_msl_m = 410");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 19, "minimum_msl_m = 300");
    test_support::expect_user_error([&] { (void)parse_scenario(text, "low.toml"); }, "minimum lies below the strip");
}

TEST(AirInstruments, ShowTheFieldAtTheFieldAndLessInWarmAir) {
    const AirInstruments warm{345, 101'900, 12};
    EXPECT_EQ(warm.baro_altitude_m(345), 345);
    EXPECT_LT(warm.baro_altitude_m(1345), 1345);
    const AirInstruments standard{0, 101'325, 0};
    EXPECT_NEAR(standard.airspeed_ratio(0), 1, 1e-4);
    EXPECT_NEAR(standard.airspeed_ratio(6000), std::sqrt(0.6601 / 1.225), 1e-3) << "ICAO Doc 7488: 0.6601 kg/m3";
    EXPECT_NEAR(standard.outside_temperature_k(6000), 249.15, 0.01);
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario_guidance
