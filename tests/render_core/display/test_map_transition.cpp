// The way between 3D and the map, in pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "tests/support/scene/map_scene.hpp"

namespace tedavis::display::test_map_transition {
namespace {

using base::Time;
using flight::Signal;
using test_support::aircraft_on_map;
using test_support::HillsPicture;
using test_support::in_three_d;
using test_support::kHillsNow;
using test_support::map_design;
using test_support::map_picture;
using test_support::MapScene;
using test_support::received_later;
using test_support::without_symbols;

int largest_difference(const HillsPicture& a, const HillsPicture& b) {
    int largest = 0;
    for (std::size_t n = 0; n < a.rgba.size(); ++n) largest = std::max(largest, std::abs(int{a.rgba[n]} - int{b.rgba[n]}));
    return largest;
}

struct Flight {
    MapScene scene{in_three_d(map_design())};
    Time now = kHillsNow;
    flight::AircraftState state = aircraft_on_map();

    Flight() { static_cast<void>(scene.picture(state)); }
    /// One frame received_later.
    const FrameRecord& step(double seconds) {
        now = now + base::Duration::from_seconds(seconds);
        state = received_later(state, now);
        scene.display().plan({state, {}, now});
        return scene.record();
    }
};

TEST(MapPictures, AnotherModeTravelsAndArrives) {
    HillsPicture arrived;
    flight::AircraftState state;
    Time now;
    {
        Flight flight;
        EXPECT_EQ(flight.scene.record().view.mode, design::ViewMode::perspective);
        EXPECT_EQ(flight.scene.record().view.transition, 1);
        const glm::dvec3 own = flight.scene.display().planned().picture.camera.view.eye;
        ASSERT_TRUE(flight.scene.display().set_design(map_design()));
        double height_m = 0;
        for (int n = 1; n <= 10; ++n) {
            const FrameRecord& record = flight.step(0.1);
            EXPECT_EQ(record.view.mode, design::ViewMode::map);
            EXPECT_NEAR(record.view.transition, n / 10.0, 1e-6);
            EXPECT_GE(glm::length(flight.scene.display().planned().picture.camera.view.eye - own), height_m);
            height_m = glm::length(flight.scene.display().planned().picture.camera.view.eye - own);
            static_cast<void>(flight.scene.drawn());
            EXPECT_GT(flight.scene.record().terrain.triangles, 0u);
        }
        EXPECT_EQ(flight.step(0.1).view.transition, 1);
        now = flight.now;
        state = flight.state;
        arrived = flight.scene.picture(state, now);
    }
    const HillsPicture at_once = map_picture(map_design(), state, now);
    EXPECT_LE(largest_difference(arrived, at_once), 1)
        << "as if it had always been a map, but for the places of pages in the atlas";
    EXPECT_GT(largest_difference(arrived, map_picture(in_three_d(map_design()), state, now)), 1) << "control";
}

TEST(MapPictures, TheWayBackEndsInTheSamePicture) {
    Flight flight;
    const HillsPicture before = flight.scene.picture(flight.state, flight.now);
    ASSERT_TRUE(flight.scene.display().set_design(map_design()));
    flight.step(0.4);
    ASSERT_TRUE(flight.scene.display().set_design(in_three_d(map_design())));
    EXPECT_NEAR(flight.step(0.2).view.transition, 0.8, 1e-6);
    EXPECT_EQ(flight.step(0.3).view.transition, 1);
    static_cast<void>(flight.step(6.1));  // seven seconds in all: the hand of the activity mark has gone round
    EXPECT_LE(largest_difference(before, flight.scene.picture(flight.state, flight.now)), 1);
}

TEST(MapPictures, OnTheWayStandNoSymbolsThatWouldNotBeTrue) {
    design::DesignSettings shown = without_symbols(map_design()), hidden = shown;
    shown.symbology.attitude = shown.symbology.map = shown.symbology.flight_path = true;
    const auto halfway = [](const design::DesignSettings& design) {
        MapScene scene(in_three_d(design));
        flight::AircraftState state = aircraft_on_map();
        static_cast<void>(scene.picture(state));
        EXPECT_TRUE(scene.display().set_design(design));
        const Time now = kHillsNow + base::Duration::milliseconds(500);
        return scene.picture(received_later(state, now), now);
    };
    EXPECT_EQ(halfway(shown), halfway(hidden));
    EXPECT_NE(map_picture(shown, aircraft_on_map()), map_picture(hidden, aircraft_on_map())) << "control";
}

TEST(MapPictures, JumpsInTimeAndLostTerrainLeaveTheWayOut) {
    Flight flight;
    bool is_map = false;
    for (const double jump_s : {-5.0, 3.0, 0.0}) {
        is_map = !is_map;
        ASSERT_TRUE(flight.scene.display().set_design(is_map ? map_design() : in_three_d(map_design())));
        EXPECT_EQ(flight.step(jump_s).view.transition, 1) << jump_s;
    }
    ASSERT_TRUE(flight.scene.display().set_design(in_three_d(map_design())));
    EXPECT_LT(flight.step(0.2).view.transition, 1) << "control";
    EXPECT_EQ(flight.step(2).view.transition, 1);
    ASSERT_TRUE(flight.scene.display().set_design(map_design()));
    flight.state[Signal::pitch] = {};
    EXPECT_EQ(flight.step(0.2).view.transition, 1);
    static_cast<void>(flight.scene.drawn());
    EXPECT_GT(flight.scene.record().terrain.triangles, 0u) << "the map needs no attitude";
}

}  // namespace
}  // namespace tedavis::display::test_map_transition
