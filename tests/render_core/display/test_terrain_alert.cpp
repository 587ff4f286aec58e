// P35: terrain ahead in the pictures of the shipped designs: colored and said in every phase, whatever a design says of warning
// colors.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render_core/display/display.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_terrain_alert {
namespace {

using flight::FlightPhase;
using flight::Scenario;
using test_support::HeadlessDisplay;
using test_support::kHillsNow;

constexpr std::uint32_t kWidth = 240, kHeight = 180;

/// Level, towards hills that are higher; there is a heading for it.
flight::AircraftState towards_hills(double speed_mps = 60) {
    flight::AircraftState state = test_support::aircraft_over_hills(1060, 30, 0);
    state.own_ship.velocity_north_mps *= speed_mps / 60;
    state.own_ship.velocity_east_mps *= speed_mps / 60;
    return state;
}

/// Red or yellow, which no design's own ground is; below the strip of annunciations (rows come from the bottom).
double colored_share(const std::vector<std::uint8_t>& rgba) {
    std::size_t colored = 0;
    for (std::size_t n = 0; n < rgba.size() * 4 / 5; n += 4) {
        const int red = rgba[n], green = rgba[n + 1], blue = rgba[n + 2];
        colored += red > blue + 60 && green < red + 30 ? 1u : 0u;
    }
    return static_cast<double>(colored) * 4 / static_cast<double>(rgba.size());
}

double red_share(const std::vector<std::uint8_t>& rgba) {
    std::size_t red = 0;
    for (std::size_t n = 0; n < rgba.size(); n += 4) red += rgba[n] > 100 && rgba[n + 1] < 40 && rgba[n + 2] < 40 ? 1u : 0u;
    return static_cast<double>(red) * 4 / static_cast<double>(rgba.size());
}

bool says_ahead(const FrameRecord& record) {
    for (const Name& name : record.flags)
        if (name.view() == "terrain.ahead") return true;
    return false;
}

struct Shown {
    FrameRecord record;
    double colored = 0, red = 0;
};

Shown shown(const design::DesignSettings& design, const flight::AircraftState& state, FlightPhase phase, const char* device) {
    test_support::MemoryBytes terrain{test_support::hills().image};
    HeadlessDisplay headless("egl", device, kWidth, kHeight, &terrain, design);
    const auto pixels =
        test_support::settled_pixels(headless, state, kHillsNow, flight::stated_phase(phase, flight::PhaseSource::motion));
    return {headless.display().record(), colored_share(pixels), red_share(pixels)};
}

/// Bands color ground by its height alone; the zone of an alert colors some of the ground, and only while there is one.
TEST(TerrainAlert, EveryShippedDesignTellsOfTerrainAhead) {
    for (const char* name :
         {"default", "takeoff", "cruise", "approach", "replanning", "priority", "map_north_up", "map_track_up", "focus/sphere"}) {
        design::DesignSettings design = test_support::shipped_design(name);
        design.symbology = {};
        design.warning_colors = false;
        const Shown alert = shown(design, towards_hills(), {Scenario::cruise, 0}, "es3-mid");
        const Shown calm = shown(design, towards_hills(10), {Scenario::cruise, 0}, "es3-mid");
        EXPECT_TRUE(says_ahead(alert.record)) << name;
        EXPECT_FALSE(says_ahead(calm.record)) << name << ": control, it stands nearly still";
        // Of the others the zone is a few pixels; draw/drawers/test_alert_zone_uniforms.cpp looks at each of them.
        if (design.view.mode != design::ViewMode::perspective || !design.foci.empty()) continue;
        EXPECT_GT(alert.colored, calm.colored + 0.003) << name;
        EXPECT_LT(alert.colored, calm.colored + 0.6) << name << ": not all of the ground";
    }
}

TEST(TerrainAlert, NoPhaseDeviceWeightOrBandsOfADesignSilenceIt) {
    for (const char* device : {"es3-mid", "es2-small"})
        for (const FlightPhase phase : {FlightPhase{}, FlightPhase{Scenario::cruise, 0}, flight::kApproachLanding,
                                        flight::kGoAroundReplanning, FlightPhase{Scenario::ground, 0}}) {
            design::DesignSettings design = test_support::shipped_design("cruise");
            design.priority.weights.of.fill(0);
            design.priority.hazard_weight = 0;
            design.priority.hazard_ahead_s = 10;
            design.priority.hazard_within_m = 50;
            design.warning_bands = {};
            static_cast<void>(design.warning_bands.try_push_back({6000, 6000, {0xFF, 0, 0}, 0}));
            const Shown alert = shown(design, towards_hills(), phase, device);
            EXPECT_TRUE(says_ahead(alert.record)) << device << " " << int{phase.code()};
            EXPECT_GT(alert.colored, 0.004) << device << " " << int{phase.code()};
        }
}

TEST(TerrainAlert, OnlyTheFailurePolicySilencesIt) {
    const design::DesignSettings design = test_support::shipped_design("cruise");
    flight::AircraftState lost = towards_hills();
    lost.own_ship.state = base::SignalState::stale;
    const Shown silent = shown(design, lost, {Scenario::cruise, 0}, "es3-mid");
    EXPECT_FALSE(says_ahead(silent.record));
    EXPECT_EQ(silent.record.terrain.triangles, 0u) << "there is no ground to color";
}

/// A turn may end at any time, and a gust is none.
TEST(TerrainAlert, WhatLiesStraightAheadCountsInATurn) {
    for (const double turn_deg : {-20.0, 8.0, 20.0}) {
        flight::AircraftState turning = towards_hills();
        turning[flight::Signal::heading_rate] = {base::radians(turn_deg), kHillsNow};
        const Shown alert = shown(test_support::shipped_design("cruise"), turning, {Scenario::cruise, 0}, "es3-mid");
        EXPECT_TRUE(says_ahead(alert.record)) << turn_deg;
    }
}

/// On the way towards hills, straight ahead and in a turn away from them.
TEST(TerrainAlert, WhatLiesStraightAheadOfATurnCountsForTwiceItsTime) {
    struct Place {
        double ahead_m;
        policy::TerrainAhead straight, turning;
    };
    using policy::TerrainAhead;
    for (const Place& place :
         {Place{300, TerrainAhead::caution, TerrainAhead::none}, Place{1200, TerrainAhead::warning, TerrainAhead::caution},
          Place{2400, TerrainAhead::warning, TerrainAhead::warning}}) {
        flight::AircraftState state = test_support::aircraft_over_hills(1150, 30, 0);
        earth::Geodetic& at = state.own_ship.position;
        at.latitude_rad += place.ahead_m * std::cos(base::radians(30)) / 6.37e6;
        at.longitude_rad += place.ahead_m * std::sin(base::radians(30)) / (6.39e6 * std::cos(base::radians(47)));
        const auto level = [&](double turn_deg_s) {
            state[flight::Signal::heading_rate] = {base::radians(turn_deg_s), kHillsNow};
            return shown(test_support::shipped_design("cruise"), state, {Scenario::cruise, 0}, "es3-mid").record.alerts.terrain;
        };
        EXPECT_EQ(level(0), place.straight) << place.ahead_m << " m";
        EXPECT_EQ(level(9), place.turning) << place.ahead_m << " m";
    }
}

/// As warning bands: said, but not colored, while the height is not geometric.
TEST(TerrainAlert, AHeightOnTheAltimetersSettingColorsNoGround) {
    design::DesignSettings design = test_support::shipped_design("cruise");
    design.symbology = {};
    flight::AircraftState on_qnh = towards_hills();
    on_qnh.own_ship.height_is_geometric = false;
    on_qnh.own_ship.height_is_on_qnh = true;
    on_qnh.own_ship.position.height.m -= 50;  // above MSL
    on_qnh[flight::Signal::baro_altitude] = {on_qnh.own_ship.position.height.m, kHillsNow};
    on_qnh[flight::Signal::baro_setting] = {101'325, kHillsNow};
    flight::AircraftState calm = on_qnh;
    calm.own_ship.velocity_north_mps = calm.own_ship.velocity_east_mps = 0;
    const Shown said = shown(design, on_qnh, {Scenario::cruise, 0}, "es3-mid");
    const Shown quiet = shown(design, calm, {Scenario::cruise, 0}, "es3-mid");
    EXPECT_TRUE(says_ahead(said.record));
    EXPECT_FALSE(says_ahead(quiet.record));
    EXPECT_NEAR(said.colored, quiet.colored, 0.001);
}

/// The alert comes and goes; what a design shows without it is as before.
TEST(TerrainAlert, TheDesignComesBackAsItWas) {
    test_support::MemoryBytes terrain{test_support::hills().image};
    HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &terrain, test_support::shipped_design("cruise"));
    const auto picture = [&](const flight::AircraftState& state) {
        return test_support::settled_pixels(headless, state, kHillsNow,
                                            flight::stated_phase({Scenario::cruise, 0}, flight::PhaseSource::can));
    };
    const auto before = picture(towards_hills(10)), alert = picture(towards_hills()), after = picture(towards_hills(10));
    EXPECT_EQ(before, after);
    EXPECT_NE(before, alert) << "control";
}

TEST(TerrainAlert, BelowTerrainIsNoCalmHorizon) {
    const design::DesignSettings design = test_support::shipped_design("cruise");
    flight::AircraftState below = test_support::aircraft_over_hills(900, 30, 0);
    const Shown contact = shown(design, below, {Scenario::cruise, 0}, "es3-mid");
    EXPECT_GT(contact.red, 0.25) << "red up to the horizon";
    below.own_ship.velocity_north_mps = below.own_ship.velocity_east_mps = 0;
    below[flight::Signal::height_above_terrain] = {-5, kHillsNow};
    const Shown parked = shown(design, below, {Scenario::cruise, 0}, "es3-mid");
    EXPECT_LT(parked.red, 0.02) << "control: parked, blue over brown";
}

}  // namespace
}  // namespace tedavis::display::test_terrain_alert
