#include "render_core/draw/data/focus_place.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>

#include "tests/support/display/foci_of_test.hpp"

namespace tedavis::draw::test_focus_place {
namespace {

using base::radians;
using test_support::FociOfTest;
using test_support::LoadedScene;
using test_support::scene_point;

constexpr std::int64_t kSecond_ns = 1'000'000'000;

host_sim::LayerDraft lines(const char* name, scene::LayerRole role, std::vector<std::vector<scene::ScenePoint>> all,
                           std::vector<std::string> names = {}) {
    host_sim::LayerDraft layer;
    layer.name = name;
    layer.shape = scene::LayerShape::lines;
    layer.role = role;
    layer.starts = {0};
    for (const auto& line : all) {
        layer.points.insert(layer.points.end(), line.begin(), line.end());
        layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    }
    layer.names = std::move(names);
    return layer;
}

/// A way east, then north; a near runway, and one at its end; a town and a mast of the same name.
host_sim::SceneDraft country() {
    host_sim::SceneDraft draft;
    draft.name = "country";
    draft.origin = "made for a test";
    std::vector<scene::ScenePoint> way;
    for (int n = 0; n <= 40; ++n) {
        way.push_back(scene_point(46.8 + 0.01 * std::max(n - 20, 0), 9.8 + 0.01 * std::min(n, 20), 3000));
        way.back().time_ns = n * 10 * kSecond_ns;
    }
    draft.layers.push_back(lines("flight", scene::LayerRole::trajectory, {way}));
    draft.layers.push_back(lines("strips", scene::LayerRole::runway,
                                 {{scene_point(46.81, 9.81, 500), scene_point(46.83, 9.81, 500)},
                                  {scene_point(47.01, 9.99, 500), scene_point(47.01, 10.01, 500)}},
                                 {"NEAR", "FAR"}));
    host_sim::LayerDraft masts = test_support::small_points();
    masts.names = {"Davos", "", ""};
    draft.layers.push_back(masts);
    host_sim::LayerDraft towns = test_support::small_points();
    towns.name = "towns";
    towns.role = scene::LayerRole::place;
    towns.points = {scene_point(46.9, 9.9, 0)};
    towns.names = {"Davos"};
    towns.attributes.clear();
    draft.layers.push_back(towns);
    return draft;
}

/// Metres over the ground by another code.
double metres(const scene::FocusRegion& region, std::uint32_t n, double latitude_deg, double longitude_deg) {
    const earth::Geodetic place =
        earth::from_ecef(region.anchor + region.east * region.points[n].x + region.north * region.points[n].y);
    double distance = 0;
    GeographicLib::Geodesic::WGS84().Inverse(base::degrees(place.latitude_rad), base::degrees(place.longitude_rad), latitude_deg,
                                             longitude_deg, distance);
    return distance;
}

TEST(FocusPlace, TheOwnShipAStatedPlaceAndANamedOne) {
    const LoadedScene scene(country());
    FociOfTest foci({R"(at = "own_ship", radius_m = 700)", R"(at = "position", position_deg = [46.95, 9.7])",
                     R"(at = "place", place = "Davos")", R"(at = "place", place = "Klosters")"},
                    &scene.scene());
    EXPECT_NEAR(metres(foci.region(0), 0, 46.8, 9.8), 0, 0.01);
    EXPECT_EQ(foci.region(0).radius_m, 700);
    EXPECT_NEAR(metres(foci.region(1), 0, 46.95, 9.7), 0, 0.01);
    EXPECT_NEAR(metres(foci.region(2), 0, 46.9, 9.9), 0, 0.01) << "the town comes before the mast";
    EXPECT_EQ(foci.plan.states[3], FocusState::no_such_place);
    EXPECT_FALSE(foci.region(3).is_valid);
}

TEST(FocusPlace, AHazardIsWhereItIsMetWhileThereIsOne) {
    FociOfTest foci({R"(at = "hazard", radius_m = 800)"});
    EXPECT_EQ(foci.plan.states[0], FocusState::no_hazard);
    EXPECT_FALSE(foci.region(0).is_valid);
    const earth::Geodetic met{radians(46.85), radians(9.85), {2900}};
    foci.hazard = &met;
    foci.plan_again();
    EXPECT_NEAR(metres(foci.region(0), 0, 46.85, 9.85), 0, 0.01);
    EXPECT_EQ(foci.plan.heights_m[0], 2900);
}

TEST(FocusPlace, TheDestinationIsTheRunwayAtTheWaysEnd) {
    const LoadedScene scene(country());
    FociOfTest foci({R"(at = "destination")", R"(at = "destination", place = "NEAR")", R"(at = "destination", place = "WEST")"},
                    &scene.scene());
    EXPECT_NEAR(metres(foci.region(0), 0, 47.01, 10.0), 0, 2);
    EXPECT_NEAR(metres(foci.region(1), 0, 46.82, 9.81), 0, 2);
    EXPECT_EQ(foci.plan.states[2], FocusState::no_runway);
    foci.own_ship.position.latitude_rad = radians(46.7);  // 11 km from the way
    foci.plan_again(&scene.scene());
    EXPECT_NEAR(metres(foci.region(0), 0, 46.82, 9.81), 0, 2) << "without a way the nearest";
    foci.plan_again();
    EXPECT_EQ(foci.plan.states[0], FocusState::no_runway) << "no scene";
}

TEST(FocusPlace, TheNextMinutesOfThePlannedWay) {
    const LoadedScene scene(country());
    FociOfTest foci({R"(shape = "path", ahead_s = 200, radius_m = 400)"}, &scene.scene());
    const scene::FocusRegion& region = foci.region();
    ASSERT_EQ(region.kind, scene::FocusPoints::path);
    ASSERT_EQ(region.point_count, 2u) << "straight on";
    EXPECT_NEAR(metres(region, 0, 46.8, 9.8), 0, 1);
    EXPECT_NEAR(metres(region, 1, 46.8, 10.0), 0, 1) << "20 points, 10 s each";
    foci.foci[0].ahead_s = 255;
    foci.plan_again(&scene.scene());
    ASSERT_EQ(foci.region().point_count, 3u) << "round the corner";
    EXPECT_NEAR(metres(foci.region(), 1, 46.8, 10.0), 0, 1);
    EXPECT_NEAR(metres(foci.region(), 2, 46.855, 10.0), 0, 1);
    foci.plan_again(&scene.scene(), {base::Time{150 * kSecond_ns}, true, true});
    EXPECT_NEAR(metres(foci.region(), 0, 46.8, 9.8), 0, 1) << "not where the plan has it: where it is";
    foci.own_ship.position.longitude_rad = radians(9.95);
    foci.plan_again(&scene.scene(), {base::Time{150 * kSecond_ns}, true, true});
    EXPECT_NEAR(metres(foci.region(), 0, 46.8, 9.95), 0, 1);
    EXPECT_NEAR(metres(foci.region(), 2, 47.0, 10.0), 0, 1) << "to the way's end at most";
}

TEST(FocusPlace, WithoutAWayStraightOn) {
    FociOfTest foci({R"(shape = "path", ahead_s = 100)"});
    ASSERT_EQ(foci.region().point_count, 2u);
    double latitude = 0, longitude = 0;
    GeographicLib::Geodesic::WGS84().Direct(46.8, 9.8, 90, 5000, latitude, longitude);
    EXPECT_NEAR(metres(foci.region(), 1, latitude, longitude), 0, 5);
    foci.own_ship.velocity_east_mps = 0.5;
    foci.plan_again();
    EXPECT_EQ(foci.plan.states[0], FocusState::no_motion);
    EXPECT_FALSE(foci.region().is_valid);
}

/// The corners of a spiral are more than a region holds: the kept ones stay near all of them.
TEST(FocusPlace, OfManyCornersThoseThatMatterAreKept) {
    std::vector<scene::ScenePoint> way;
    for (int n = 0; n <= 200; ++n) way.push_back(scene_point(46.8 + 0.02 * std::sin(0.06 * n), 9.8 + 0.002 * n, 3000));
    host_sim::SceneDraft draft{"bends", "a test", 1, {lines("flight", scene::LayerRole::trajectory, {way})}};
    const LoadedScene scene(draft);
    FociOfTest foci({R"(shape = "path", ahead_s = 7200, radius_m = 10, context.width_m = 0)"}, &scene.scene());
    EXPECT_EQ(foci.region().point_count, scene::kMaxFocusPoints);
    double farthest = 0;
    for (const scene::ScenePoint& point : way)
        farthest = std::max(
            farthest, scene::focus_distance_m(
                          foci.region(),
                          scene::in_focus_plane(foci.region(), earth::to_ecef({point.latitude_rad, point.longitude_rad, {0}}))));
    EXPECT_LT(farthest, 250);
}

TEST(FocusPlace, AVolumeHasHeights) {
    FociOfTest foci({R"(shape = "sphere", radius_m = 1000)", R"(shape = "sphere", height_m = 2000)",
                     R"(shape = "cuboid", lower_m = 1000, upper_m = 1500)",
                     R"(shape = "sphere", at = "position", position_deg = [46.9, 9.9])"});
    EXPECT_EQ(foci.region(0).lower_m, 3000) << "the own ship's";
    EXPECT_EQ(foci.region(1).lower_m, 2050) << "above MSL, and the geoid 50 m above the ellipsoid";
    EXPECT_EQ(foci.region(2).lower_m, 1050);
    EXPECT_EQ(foci.region(2).upper_m, 1550);
    EXPECT_EQ(foci.region(3).lower_m, 600) << "the ground's";
    EXPECT_TRUE(foci.region(0).is_ball);
    EXPECT_TRUE(foci.region(2).is_square);
}

TEST(FocusPlace, ALostPositionTakesItsFociAway) {
    const LoadedScene scene(country());
    FociOfTest foci(
        {R"(at = "own_ship")", R"(shape = "path")", R"(at = "destination")", R"(at = "position", position_deg = [46.9, 9.9])"},
        &scene.scene());
    for (std::size_t n = 0; n < 4; ++n) EXPECT_TRUE(foci.region(n).is_valid) << n;
    foci.own_ship.state = base::SignalState::lost;
    foci.plan_again(&scene.scene());
    for (std::size_t n = 0; n < 3; ++n) {
        EXPECT_EQ(foci.plan.states[n], FocusState::no_position) << n;
        EXPECT_FALSE(foci.region(n).is_valid) << n;
    }
    EXPECT_TRUE(foci.region(3).is_valid) << "is where it is";
    foci.own_ship.state = base::SignalState::stale;
    foci.plan_again(&scene.scene());
    EXPECT_EQ(foci.plan.states[0], FocusState::position_stale);
    EXPECT_TRUE(foci.region(0).is_valid);
}

}  // namespace
}  // namespace tedavis::draw::test_focus_place
