#include "render_core/display/planner/symbology_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::display::test_symbology_data {
namespace {

using flight::Signal;

class SymbologyDataOf : public ::testing::Test {
protected:
    SymbologyDataOf() {
        symbology_ = test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480);
        symbology_.adjacent.layer = &loaded_.layer();
        symbology_.adjacent.attribute = &loaded_.attribute();
        symbology_.adjacent.view.size = 5;
        symbology_.adjacent.view.scale = test_support::wind().scale;
    }
    std::string flags(GroundDataState state = GroundDataState::shown) const {
        FrameRecord record;
        flag_symbology_data(symbology_, layout(), state, record);
        std::string all;
        for (const Name& name : record.flags) all += std::string(name.view()) + " ";
        return all;
    }
    [[nodiscard]] draw::Layout layout() const { return draw::make_layout(640, 480, 96, draw::legend_need(symbology_)); }

    test_support::LoadedScene loaded_{test_support::small_ensemble(9)};
    draw::SymbologyInput symbology_;
};

TEST_F(SymbologyDataOf, MapsWithRoomAreCountedAndRaiseNothing) {
    EXPECT_EQ(flags(), "");
    EXPECT_EQ(maps_drawn(symbology_, layout()), 1u);
    symbology_.adjacent.view.shows = design::AdjacentShows::members;
    EXPECT_EQ(maps_drawn(symbology_, layout()), 9u);
    symbology_.decisions.unusual_attitude = true;
    EXPECT_EQ(maps_drawn(symbology_, layout()), 0u) << "a recovery picture has none";
    EXPECT_EQ(flags(), "");
}

TEST_F(SymbologyDataOf, WhatHasNoRoomNoDataOrAnotherUnitIsFlagged) {
    EXPECT_EQ(flags(GroundDataState::no_members), "adjacent.missing ");
    EXPECT_EQ(flags(GroundDataState::not_asked_for), "");
    symbology_.adjacent.view.shows = design::AdjacentShows::value;
    symbology_.adjacent.view.scale.palette.unit = design::PaletteUnit::metres;
    EXPECT_EQ(flags(), "adjacent.unit ");
    symbology_.adjacent.view.shows = design::AdjacentShows::members;
    symbology_.adjacent.view.scale.palette.unit = design::PaletteUnit::one;
    symbology_.legend.highest = 2000;
    symbology_.legend.tint = symbology_.legend.bands = true;
    using test_support::wind;
    symbology_.data_legends = test_support::list_of({wind(), wind(), wind()});
    EXPECT_TRUE(layout().adjacent.empty());
    EXPECT_EQ(maps_drawn(symbology_, layout()), 0u);
    EXPECT_EQ(flags(), "adjacent.cut ") << "legends are never given up for maps";
}

/// The speed bands beside the airspeed of a scene.
class SpeedBandsOf : public ::testing::Test {
protected:
    [[nodiscard]] policy::SpeedBands bands() const {
        const policy::DisplayDecisions decisions = policy::decide_display(
            state_, test_support::kSceneNow, test_support::scene_conditions(), design::default_design_settings());
        return shown_speed_bands(aircraft_, state_, decisions, test_support::kSceneNow);
    }
    static design::AircraftSettings shipped(const std::string& name) {
        const std::string path = "configs/aircraft/" + name + ".toml";
        return design::load_aircraft(test_support::source_file(path), path).value();
    }
    void set(Signal signal, double value) { state_[signal] = {value, test_support::kSceneNow}; }

    flight::AircraftState state_ = test_support::scene_state(30, 2, 0);
    design::AircraftSettings aircraft_ = shipped("light_piston");
};

TEST_F(SpeedBandsOf, AreThoseOfIndicatedOrCalibratedAirspeedAlone) {
    ASSERT_FALSE(bands().bands.empty());
    EXPECT_EQ(bands().flags.size(), aircraft_.flags.size());
    state_[Signal::indicated_airspeed] = state_[Signal::calibrated_airspeed] = {};
    for (const Signal other : {Signal::true_airspeed, Signal::ground_speed}) {
        set(other, 60);
        EXPECT_TRUE(bands().bands.empty()) << to_string(other);
        EXPECT_TRUE(bands().flags.empty()) << to_string(other);
        state_[other] = {};
    }
    EXPECT_TRUE(bands().bands.empty()) << "no speed is known";
    set(Signal::calibrated_airspeed, 60);
    EXPECT_FALSE(bands().bands.empty());
    aircraft_ = {};
    EXPECT_TRUE(bands().bands.empty()) << "no aircraft file";
}

TEST_F(SpeedBandsOf, FollowTheLoadFactorAndTheFlaps) {
    state_[Signal::normal_acceleration] = state_[Signal::flaps_position] = {};
    state_[Signal::flaps_lever] = {};
    const double level_mps = bands().bands[0].high_mps;
    EXPECT_EQ(level_mps, aircraft_.flaps[0].stall_mps) << "with the flaps up";
    const auto above = [](const policy::SpeedBands& shown) {
        for (const policy::SpeedBand& band : shown.bands)
            if (band.role == policy::SpeedBandRole::above_limit) return band.low_mps;
        return 0.0;
    };
    EXPECT_EQ(above(bands()), aircraft_.flaps[0].limit_mps) << "the markings of an aircraft that never states its flaps";
    set(Signal::flaps_lever, 1);
    EXPECT_EQ(above(bands()), aircraft_.flaps.back().limit_mps) << "as far out as the lever";
    EXPECT_EQ(bands().bands[0].high_mps, level_mps) << "and perhaps still up";
    set(Signal::flaps_lever, 0);
    state_[Signal::flaps_position] = {0, test_support::kSceneNow - base::Duration{3'600'000'000'000}};
    EXPECT_EQ(above(bands()), aircraft_.flaps.back().limit_mps) << "lost: they may be out";
    EXPECT_EQ(bands().bands[0].high_mps, level_mps) << "and they may be up";
    set(Signal::flaps_position, 0);
    EXPECT_EQ(above(bands()), aircraft_.flaps[0].limit_mps) << "they are up";
    set(Signal::normal_acceleration, 2 * 9.80665);
    EXPECT_NEAR(bands().bands[0].high_mps, std::sqrt(2) * level_mps, 1e-9);
    state_[Signal::normal_acceleration] = {2 * 9.80665, test_support::kSceneNow - base::Duration{3'600'000'000'000}};
    EXPECT_EQ(bands().bands[0].high_mps, level_mps) << "an hour old";
}

TEST_F(SpeedBandsOf, HoldUpToTheAltitudeOfTheFile) {
    aircraft_ = shipped("jet");
    EXPECT_GT(bands().bands.size(), 2u);
    set(Signal::standard_altitude, 9000);
    EXPECT_EQ(bands().bands.size(), 2u) << "above it: low speeds alone";
    state_[Signal::standard_altitude] = {};
    EXPECT_EQ(bands().bands.size(), 2u) << "unknown";
}

}  // namespace
}  // namespace tedavis::display::test_symbology_data
