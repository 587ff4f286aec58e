// Displays whose design asks for a larger focus, beside the same without.
#include <gtest/gtest.h>

#include "tests/support/scene/map_scene.hpp"

namespace tedavis::display::test_frame_planner_view {
namespace {

using test_support::aircraft_on_map;
using test_support::HillsPicture;
using test_support::in_three_d;
using test_support::kHillsNow;
using test_support::map_design;
using test_support::MapScene;
using test_support::received_later;
using test_support::without_symbols;

/// 3.9 km north of the own ship.
design::DesignSettings with_focus(design::DesignSettings design, std::uint32_t power) {
    design::FocusSettings focus;
    focus.name = "there";
    focus.at = design::FocusAt::position;
    focus.latitude_rad = base::radians(47.035);
    focus.longitude_rad = base::radians(9.7);
    focus.radius_m = 300;
    focus.context.width_m = 1500;
    focus.power = power;
    EXPECT_TRUE(design.foci.try_push_back(focus));
    return design;
}

flight::AircraftState aircraft(double speed_mps = 60) {
    flight::AircraftState state = aircraft_on_map();
    state[flight::Signal::ground_speed] = {speed_mps, kHillsNow};
    return state;
}

HillsPicture picture_of(const design::DesignSettings& design, const flight::AircraftState& state, DistortionRecords& records,
                        const char* device = "es3-mid") {
    MapScene scene(design, test_support::hills(), device);
    HillsPicture picture = scene.picture(state);
    records = scene.record().distortion;
    return picture;
}

/// By more than finer ground beside a focus changes a colour.
std::size_t differing(const HillsPicture& a, const HillsPicture& b) {
    constexpr int kMuch = 40;
    std::size_t count = 0;
    for (std::size_t n = 0; n < a.rgba.size(); n += 4) {
        int most = 0;
        for (std::size_t channel = 0; channel < 3; ++channel)
            most = std::max(most, std::abs(a.rgba[n + channel] - b.rgba[n + channel]));
        count += most > kMuch ? 1 : 0;
    }
    return count;
}

TEST(DisplayDistortion, TheMapAndTheOrthographicViewShowAFocusLarger) {
    for (const char* device : {"es2-small", "es3-mid"})
        for (const char* name : {"map_north_up", "orthographic"}) {
            const design::DesignSettings design = without_symbols(map_design(5000, name));
            DistortionRecords shown, none;
            const HillsPicture larger = picture_of(with_focus(design, 1), aircraft(), shown, device);
            const HillsPicture plain = picture_of(with_focus(design, 0), aircraft(), none, device);
            ASSERT_EQ(shown.size(), 1u) << name;
            EXPECT_EQ(shown[0].state, DistortionState::shown) << reason_of(shown[0].state) << ' ' << name << ' ' << device;
            EXPECT_EQ(shown[0].power, 1u);
            EXPECT_GT(shown[0].middle.height.m, 100);
            EXPECT_TRUE(none.empty());
            EXPECT_GT(differing(larger, plain), 300u) << name;
            EXPECT_LT(differing(larger, plain), larger.rgba.size() / 4 / 10) << name << ": the rest stays";
        }
}

TEST(DisplayDistortion, WhatTheOwnShipSeesAheadIsNeverMoved) {
    const design::DesignSettings design = in_three_d(map_design());
    DistortionRecords asked, none;
    const HillsPicture withheld = picture_of(with_focus(design, 2), aircraft(), asked);
    const HillsPicture plain = picture_of(with_focus(design, 0), aircraft(), none);
    EXPECT_EQ(withheld, plain);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].state, DistortionState::egocentric);
}

TEST(DisplayDistortion, NearTheOwnShipNothingIsMovedAndThePictureIsThePlainOne) {
    DistortionRecords asked, none;
    const HillsPicture withheld = picture_of(with_focus(map_design(), 1), aircraft(200), asked);
    const HillsPicture plain = picture_of(with_focus(map_design(), 0), aircraft(200), none);
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].state, DistortionState::own_ship);
    EXPECT_EQ(withheld, plain);
    flight::AircraftState unknown = aircraft();
    unknown[flight::Signal::ground_speed] = {};
    EXPECT_EQ(picture_of(with_focus(map_design(), 1), unknown, asked), picture_of(with_focus(map_design(), 0), unknown, none));
    EXPECT_EQ(asked[0].state, DistortionState::own_ship) << "a speed that nobody knows may be a high one";
}

TEST(DisplayDistortion, OnTheWayToTheMapNothingIsMovedYet) {
    design::DesignSettings design = with_focus(map_design(), 1);
    design.view.transition_s = 1;
    MapScene scene(design);
    static_cast<void>(scene.picture(aircraft()));
    ASSERT_EQ(scene.record().distortion[0].state, DistortionState::shown);
    ASSERT_TRUE(scene.display().set_design(in_three_d(design)));
    const base::Time later = kHillsNow + base::Duration{500'000'000};
    scene.display().plan({received_later(aircraft(), later), {}, later});
    ASSERT_EQ(scene.record().distortion.size(), 1u);
    EXPECT_EQ(scene.record().distortion[0].state, DistortionState::egocentric);
}

TEST(DisplayDistortion, ASecondDisplayShowsTheSameBitForBit) {
    DistortionRecords records;
    EXPECT_EQ(picture_of(with_focus(map_design(), 2), aircraft(), records),
              picture_of(with_focus(map_design(), 2), aircraft(), records));
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_view
