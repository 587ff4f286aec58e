#include "render_core/draw/data/planned_track.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::draw::test_planned_track {
namespace {

using base::radians;
using test_support::LoadedScene;
using test_support::scene_point;

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// Out to the east along 46.8 N, 0.01 degrees a minute, and back by the same way.
host_sim::LayerDraft out_and_back(bool has_times) {
    host_sim::LayerDraft layer;
    layer.name = "flight";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    for (int n = 0; n <= 20; ++n) {
        layer.points.push_back(scene_point(46.8, 9.8 + 0.01 * (n <= 10 ? n : 20 - n), 2000 + 10.0f * static_cast<float>(n)));
        if (has_times) layer.points.back().time_ns = n * 60 * kSecond_ns;
    }
    layer.starts = {0, 21};
    return layer;
}

earth::Geodetic at(double latitude_deg, double longitude_deg) { return {radians(latitude_deg), radians(longitude_deg), {0}}; }

TEST(PlannedTrack, IsTheNearestPlaceOfATrajectory) {
    const LoadedScene scene(out_and_back(false));
    const PlannedTrack way = planned_track(scene.scene(), at(46.81, 9.825), 0, false, 5000);
    ASSERT_NE(way.layer, nullptr);
    EXPECT_EQ(way.leg, 2u);
    EXPECT_NEAR(way.part, 0.5, 1e-3);
    const scene::ScenePoint here = point_on(way, way.leg, way.part);
    EXPECT_NEAR(here.longitude_rad, radians(9.825), 1e-7);
    EXPECT_NEAR(here.height_m, 2025, 0.1);
    EXPECT_EQ(here.time_ns, scene::kNoTime);
    EXPECT_EQ(planned_track(scene.scene(), at(46.86, 9.825), 0, false, 5000).layer, nullptr) << "6 km away";
}

/// The way is there twice; the time says which of them.
TEST(PlannedTrack, TheTimeTellsTheWayBackFromTheWayOut) {
    const LoadedScene scene(out_and_back(true));
    EXPECT_EQ(planned_track(scene.scene(), at(46.8, 9.825), 150 * kSecond_ns, true, 5000).leg, 2u);
    const PlannedTrack back = planned_track(scene.scene(), at(46.8, 9.825), (17 * 60 + 30) * kSecond_ns, true, 5000);
    EXPECT_EQ(back.leg, 17u);
    EXPECT_NEAR(back.part, 0.5, 1e-9);
    EXPECT_EQ(point_on(back, back.leg, back.part).time_ns, (17 * 60 + 30) * kSecond_ns);
    EXPECT_EQ(planned_track(scene.scene(), at(46.8, 9.825), 10 * 60 * kSecond_ns, true, 5000).leg, 2u)
        << "who is not where the plan has him is where he is nearest";
}

/// Late by half a minute, on the way back: the own ship is on the way back where it is nearest, not where the plan has it.
TEST(PlannedTrack, BesideALateFlightIsTheNearestPlaceOfThePartThatIsFlown) {
    const LoadedScene scene(out_and_back(true));
    const auto beside = [&](double longitude_deg, int time_s) {
        return track_beside(scene.layer(), at(46.801, longitude_deg), time_s * kSecond_ns, true, 5000);
    };
    EXPECT_EQ(beside(9.825, 17 * 60).leg, 17u);
    EXPECT_NEAR(beside(9.825, 17 * 60).part, 0.5, 1e-3);
    EXPECT_EQ(beside(9.825, 120).leg, 2u) << "on the way out";
    EXPECT_EQ(beside(9.825, 10 * 60).leg, 2u) << "the plan is elsewhere";
    EXPECT_EQ(track_beside(scene.layer(), at(46.801, 9.825), 17 * 60 * kSecond_ns, false, 5000).leg, 2u) << "without a date";
    EXPECT_EQ(track_beside(scene.layer(), at(46.86, 9.825), 0, false, 5000).layer, nullptr) << "6 km away";
}

TEST(PlannedTrack, OtherLinesAreNone) {
    host_sim::LayerDraft road = out_and_back(false);
    road.role = scene::LayerRole::road;
    const LoadedScene scene(road);
    EXPECT_EQ(planned_track(scene.scene(), at(46.8, 9.82), 0, false, 5000).layer, nullptr);
}

}  // namespace
}  // namespace tedavis::draw::test_planned_track
