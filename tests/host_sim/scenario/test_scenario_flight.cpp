#include "host_sim/scenario/scenario_flight.hpp"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <vector>

#include "host_sim/flight_log/pressure_altitude.hpp"
#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scenario_flight {
namespace {

using flight::Signal;

const GeoidEgm96& geoid() {
    static const GeoidEgm96 grid = GeoidEgm96::installed();
    return grid;
}

Scenario shipped() {
    return parse_scenario(read_file(test_support::source_dir() + "/configs/scenarios/default.toml"), "default.toml");
}

const ScenarioFlight& default_flight() {
    static const ScenarioFlight flight(shipped(), 1, geoid());
    return flight;
}

base::Time at_second(double s) { return default_flight().begin() + base::Duration::from_seconds(s); }

/// The shipped elevation raster, read directly.
class Elevations {
public:
    Elevations() {
        GDALAllRegister();
        data_.reset(static_cast<GDALDataset*>(
            GDALOpen((test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif").c_str(), GA_ReadOnly)));
        if (data_ == nullptr || data_->GetGeoTransform(transform_) != CE_None) return;
        columns_ = data_->GetRasterXSize();
        rows_ = data_->GetRasterYSize();
        heights_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
        ok_ = data_->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, columns_, rows_, heights_.data(), columns_, rows_, GDT_Float64, 0,
                                                0) == CE_None;
    }
    [[nodiscard]] bool ok() const { return ok_; }
    /// The highest of the four posts around a place; NaN outside.
    [[nodiscard]] double highest_at(double latitude_rad, double longitude_rad) const {
        const double x = (base::degrees(longitude_rad) - transform_[0]) / transform_[1] - 0.5,
                     y = (base::degrees(latitude_rad) - transform_[3]) / transform_[5] - 0.5;
        const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
        if (i < 0 || j < 0 || i + 1 >= columns_ || j + 1 >= rows_) return NAN;
        const auto post = [&](int u, int v) {
            return heights_[static_cast<std::size_t>(v) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(u)];
        };
        return std::max({post(i, j), post(i + 1, j), post(i, j + 1), post(i + 1, j + 1)});
    }

private:
    std::unique_ptr<GDALDataset> data_;
    double transform_[6] = {};
    int columns_ = 0, rows_ = 0;
    std::vector<double> heights_;
    bool ok_ = false;
};

TEST(ScenarioFlight, TheDefaultFlightTakesAboutSevenMinutes) {
    const double duration = (default_flight().end() - default_flight().begin()).to_seconds();
    EXPECT_GT(duration, 390);
    EXPECT_LE(duration, 420);
}

TEST(ScenarioFlight, TheDefaultFlightKeepsClearOfTheTerrain) {
    const Elevations terrain;
    ASSERT_TRUE(terrain.ok());
    const Scenario scenario = shipped();
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const ScenarioFlight flight(scenario, seed, geoid());
        double lowest = 1e9, lowest_near = 1e9;
        for (std::size_t i = 0; i < flight.states().size(); i += 10) {
            const auto& state = flight.states()[i];
            const double ground = terrain.highest_at(state.latitude_rad, state.longitude_rad);
            ASSERT_FALSE(std::isnan(ground)) << "leaves the raster";
            const double from_strip = earth::surface_distance_m({state.latitude_rad, state.longitude_rad, {}},
                                                                {scenario.strip.latitude_rad, scenario.strip.longitude_rad, {}});
            const double clearance = state.altitude_msl_m - ground;
            (from_strip > 2500 ? lowest : lowest_near) = std::min(from_strip > 2500 ? lowest : lowest_near, clearance);
        }
        EXPECT_GE(lowest, 130) << "beyond 2.5 km of the strip, seed " << seed;
        EXPECT_GT(lowest_near, 0) << "seed " << seed;
    }
}

/// Descents of at most 1500 ft/min, and turns of at most 25 degrees but for turbulence.
TEST(ScenarioFlight, TheDefaultFlightIsFlownGently) {
    for (const auto& state : default_flight().states()) {
        ASSERT_GT(state.up_mps, -1500 * base::kMetresPerFoot / 60);
        ASSERT_LT(std::abs(state.roll_rad), base::radians(26));
    }
}

/// 600 to 1000 ft above the crest, which is the highest ground within 1500 m.
TEST(ScenarioFlight, TheDefaultFlightFollowsARidge) {
    const Elevations terrain;
    ASSERT_TRUE(terrain.ok());
    const auto& legs = default_flight().legs();
    double along_s = 0;
    for (double s = legs[5].begin_s; s < legs[6].end_s; s += 1) {
        const ScenarioFlight::State& state = default_flight().states()[static_cast<std::size_t>(100 * s)];
        double crest_m = 0;
        for (int north = -15; north <= 15; ++north)
            for (int east = -15; east <= 15; ++east)
                if (std::hypot(north, east) <= 15)
                    crest_m = std::max(crest_m, terrain.highest_at(state.latitude_rad + 100.0 * north / 6.36e6,
                                                                   state.longitude_rad + 100.0 * east / 5.12e6));
        const double above_ft = (state.altitude_msl_m - crest_m) / base::kMetresPerFoot;
        EXPECT_GT(above_ft, 600) << s;
        if (above_ft < 1000) along_s += 1;
    }
    EXPECT_GE(along_s, 50);
}

/// One that stands there until the approach has been broken off, and has gone before the second one.
TEST(ScenarioFlight, AnotherAircraftIsTheReasonForTheGoAround) {
    const Scenario scenario = shipped();
    const auto from_centre_line_m = [&](double s) {
        for (const ReceivedAircraft& aircraft : default_flight().traffic(at_second(s))) {
            if (aircraft.report.callsign.view() != "N35TDV") continue;
            const auto& place = aircraft.report.place;
            const double north = (place.latitude_rad - scenario.strip.latitude_rad) * 6.36e6;
            const double east = (place.longitude_rad - scenario.strip.longitude_rad) * 5.12e6;
            EXPECT_LT(std::hypot(north, east), scenario.strip.length_m / 2 + 400) << s;
            EXPECT_NEAR(double{place.height_m} - geoid().undulation(place.latitude_rad, place.longitude_rad).m,
                        scenario.strip.elevation_msl_m, 3)
                << "it stands on the runway";
            return std::abs(east * std::cos(scenario.strip.heading_rad) - north * std::sin(scenario.strip.heading_rad));
        }
        return -1.0;
    };
    const auto& legs = default_flight().legs();
    EXPECT_LT(from_centre_line_m(legs[9].begin_s), scenario.strip.width_m / 2);
    EXPECT_GE(from_centre_line_m(legs[9].begin_s), 0);
    EXPECT_LT(from_centre_line_m(legs[9].end_s), scenario.strip.width_m / 2);
    EXPECT_GT(from_centre_line_m(legs[13].begin_s), 150);
    EXPECT_EQ(from_centre_line_m(20), -1) << "it does not stand in the way of the take-off";
}

TEST(ScenarioFlight, VisitsEveryScenarioOfAFlight) {
    std::set<flight::Scenario> seen;
    const Scenario scenario = shipped();
    for (const Leg& leg : scenario.legs) seen.insert(leg.phase.scenario);
    EXPECT_EQ(seen.size(), 5u);
    EXPECT_EQ(default_flight().legs().size(), scenario.legs.size());
    bool can = false, switches = false, nobody = false;
    for (const Leg& leg : scenario.legs) {
        can = can || leg.stated_by == PhaseStatedBy::can;
        switches = switches || leg.stated_by == PhaseStatedBy::switches;
        nobody = nobody || leg.stated_by == PhaseStatedBy::nobody;
    }
    EXPECT_TRUE(can && switches && nobody);
}

TEST(ScenarioFlight, PositionAndVelocityAreOneMotion) {
    const double h = 0.05;
    for (double s = 1; s < 413; s += 0.73) {
        const SignalSample a = default_flight().at(at_second(s - h)).value(), b = default_flight().at(at_second(s + h)).value();
        const SignalSample mid = default_flight().at(at_second(s)).value();
        const earth::Geodetic from{a[Signal::latitude], a[Signal::longitude], {a[Signal::ellipsoid_height]}},
            to{b[Signal::latitude], b[Signal::longitude], {b[Signal::ellipsoid_height]}};
        const glm::dvec3 step = (earth::to_ecef(to) - earth::to_ecef(from)) / (2 * h);
        const glm::dmat3 axes = earth::north_east_down(mid[Signal::latitude], mid[Signal::longitude]);
        const double v = mid[Signal::ground_speed];
        EXPECT_NEAR(glm::dot(step, axes[0]), v * std::cos(mid[Signal::true_track]), 0.1) << s;
        EXPECT_NEAR(glm::dot(step, axes[1]), v * std::sin(mid[Signal::true_track]), 0.1) << s;
        EXPECT_NEAR(-glm::dot(step, axes[2]), mid[Signal::vertical_speed], 0.15) << s;
    }
}

TEST(ScenarioFlight, NothingJumps) {
    SignalSample last = default_flight().at(default_flight().begin()).value();
    for (double s = 0.02; s < 417; s += 0.02) {
        const SignalSample next = default_flight().at(at_second(s)).value();
        EXPECT_LT(std::abs(next[Signal::roll] - last[Signal::roll]), base::radians(1)) << s;
        EXPECT_LT(std::abs(next[Signal::pitch] - last[Signal::pitch]), base::radians(0.5)) << s;
        EXPECT_LT(std::abs(earth::angle_difference(next[Signal::true_heading], last[Signal::true_heading])), base::radians(0.5))
            << s;
        EXPECT_LT(std::abs(next[Signal::ground_speed] - last[Signal::ground_speed]), 0.2) << s;
        EXPECT_LT(std::abs(next[Signal::ellipsoid_height] - last[Signal::ellipsoid_height]), 0.5) << s;
        last = next;
    }
}

TEST(ScenarioFlight, AccelerometersFeelOneGAtRestAndTheTurn) {
    const SignalSample rest = default_flight().at(at_second(1)).value();
    EXPECT_NEAR(rest[Signal::normal_acceleration], base::kStandardGravity, 1e-6);
    EXPECT_NEAR(rest[Signal::longitudinal_acceleration], 0, 1e-6);
    const SignalSample roll = default_flight().at(at_second(12)).value();
    EXPECT_NEAR(roll[Signal::longitudinal_acceleration], 3.2, 0.1);
    for (double s = 78; s < 100; s += 0.5) {  // the long level turn to the ridge
        const SignalSample turn = default_flight().at(at_second(s)).value();
        EXPECT_LT(std::abs(turn[Signal::lateral_acceleration]), 0.6) << "coordinated but for turbulence";
        EXPECT_GT(turn[Signal::normal_acceleration], base::kStandardGravity) << s;
    }
}

TEST(ScenarioFlight, AltimeterShowsTheFieldOnTheGround) {
    const SignalSample sample = default_flight().at(default_flight().begin()).value();
    EXPECT_NEAR(sample[Signal::baro_altitude], sample[Signal::true_altitude], 0.1);
    EXPECT_NEAR(altitude_on_qnh(sample[Signal::standard_altitude], sample[Signal::baro_setting]), sample[Signal::baro_altitude],
                1e-6);
    EXPECT_NEAR(sample[Signal::ellipsoid_height] - sample[Signal::true_altitude],
                geoid().undulation(sample[Signal::latitude], sample[Signal::longitude]).m, 1e-9);
}

TEST(ScenarioFlight, EqualSeedsAreEqualOthersDiffer) {
    const ScenarioFlight again(shipped(), 1, geoid()), other(shipped(), 2, geoid());
    ASSERT_EQ(again.states().size(), default_flight().states().size());
    EXPECT_EQ(again.states().back().latitude_rad, default_flight().states().back().latitude_rad);
    EXPECT_EQ(again.air().wind_speed_mps, default_flight().air().wind_speed_mps);
    EXPECT_NE(other.air().wind_speed_mps, default_flight().air().wind_speed_mps);
}

TEST(ScenarioFlight, StatesThePhaseOnTheLegsThatSaySo) {
    const Scenario scenario = shipped();
    for (std::size_t i = 0; i < scenario.legs.size(); ++i) {
        const auto& flown = default_flight().legs()[i];
        const auto phase = default_flight().stated_phase(at_second((flown.begin_s + flown.end_s) / 2));
        EXPECT_EQ(phase.has_value(), scenario.legs[i].stated_by == PhaseStatedBy::can) << i;
        EXPECT_EQ(phase.value_or(scenario.legs[i].phase), scenario.legs[i].phase);
    }
}

TEST(ScenarioFlight, NamesALegThatCannotEnd) {
    Scenario scenario = shipped();
    scenario.legs[3].altitude_msl_m = 1150;
    scenario.legs[3].capture_m = 0.001;
    test_support::expect_user_error([&] { ScenarioFlight(scenario, 1, geoid()); }, "leg 4 does not end");
}

TEST(ScenarioFlight, TheRadioAltimeterReadsNothingLessThanTheGround) {
    const double end_s = (default_flight().end() - default_flight().begin()).to_seconds();
    for (const double still_s : {0.0, 2.0, end_s - 1}) {
        const auto sample = default_flight().at(at_second(still_s));
        ASSERT_TRUE(sample && sample->has(Signal::radio_height)) << still_s;
        EXPECT_NEAR((*sample)[Signal::radio_height], 0, 1e-6) << still_s;
    }
    for (double t = 60; t < 330; t += 10) {
        const auto sample = default_flight().at(at_second(t));
        ASSERT_TRUE(sample && sample->has(Signal::radio_height)) << t;
        EXPECT_GT((*sample)[Signal::radio_height], 30) << t;
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario_flight
