#include "render_core/policy/hazard_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/draw/built_element.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::policy::test_hazard_watch {
namespace {

using test_support::LevelGround;
using test_support::LoadedScene;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLatitude_deg = 46.8, kLongitude_deg = 9.8, kSpeed_mps = 100;

/// Metres north and east of where the way begins, which leads north.
scene::ScenePoint point(double north_m, double east_m, double height_m) {
    const double latitude = base::radians(kLatitude_deg);
    return {latitude + north_m / earth::meridian_radius_m(latitude),
            base::radians(kLongitude_deg) + east_m / (earth::prime_vertical_radius_m(latitude) * std::cos(latitude)),
            static_cast<float>(height_m), 0, scene::kNoTime};
}

host_sim::LayerDraft masts(const std::vector<scene::ScenePoint>& points) {
    host_sim::LayerDraft layer;
    layer.name = "masts";
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = scene::HeightDatum::msl;
    layer.points = points;
    return layer;
}

/// Closed by itself; floor and ceiling in m MSL.
host_sim::LayerDraft area(const std::vector<scene::ScenePoint>& corners, float floor_m, float ceiling_m) {
    host_sim::LayerDraft layer = masts(corners);
    layer.role = scene::LayerRole::no_go;
    layer.shape = scene::LayerShape::areas;
    layer.starts = {0, static_cast<std::uint32_t>(corners.size())};
    for (const auto& [name, value] : {std::pair("floor", floor_m), std::pair("ceiling", ceiling_m)}) {
        host_sim::AttributeDraft limit;
        limit.name = name;
        limit.unit = "m";
        limit.of = scene::AttributeOf::feature;
        limit.values = {value};
        layer.attributes.push_back(limit);
    }
    return layer;
}

struct Watched {
    design::PrioritySettings settings;  // 90 s, 500 m
    LevelGround ground;                 // 600 m, geoid 50 m over the ellipsoid
    PredictedTrack way{{base::radians(kLatitude_deg), base::radians(kLongitude_deg), {2050}}, kSpeed_mps, 0, 0};

    double layer(const host_sim::LayerDraft& draft) {
        const LoadedScene scene({"one", "a test", 1, {draft}});
        return HazardWatch(settings, way, ground, 0).layer_share(scene.scene().layers()[0]);
    }
    double terrain() { return HazardWatch(settings, way, ground, 0).terrain_share(); }
};

TEST(HazardWatch, AHazardCountsTheMoreTheNearerItIs) {
    Watched watched;
    double before = 1;
    for (double ahead_m = 500; ahead_m < 12'000; ahead_m += 250) {
        const double share = watched.layer(masts({point(ahead_m, 0, 2000)}));
        EXPECT_LE(share, before) << ahead_m;
        EXPECT_EQ(share * 8, std::floor(share * 8)) << "in eighths";
        before = share;
    }
    EXPECT_EQ(watched.layer(masts({point(4000, 0, 2000)})), 1) << "within half of the time";
    EXPECT_EQ(before, 0);
    EXPECT_EQ(watched.layer(masts({point(-2000, 0, 2000)})), 0) << "behind";
}

TEST(HazardWatch, WhatIsAsideOrFarBelowIsNone) {
    Watched watched;
    EXPECT_EQ(watched.layer(masts({point(3000, 480, 2000)})), 1);
    EXPECT_EQ(watched.layer(masts({point(3000, 900, 2000)})), 0);
    EXPECT_EQ(watched.layer(masts({point(3000, 0, 1850)})), 1) << "within a third of 500 m of the 2000 m MSL that are flown";
    EXPECT_EQ(watched.layer(masts({point(3000, 0, 1800)})), 0);
    EXPECT_EQ(watched.layer(masts({point(3000, 0, kNaN)})), 1) << "nobody knows its height";
    watched.way.up_mps = -10;
    EXPECT_GT(watched.layer(masts({point(4000, 0, 1600)})), 0) << "flown into, on the way down";
    watched.way.up_mps = 0;
    EXPECT_EQ(watched.layer(masts({point(4000, 0, 1600)})), 0);
}

TEST(HazardWatch, AnAreaIsOneFromItsBorderOnAndWithin) {
    const auto square = [](double south_m, double half_m) {
        return std::vector<scene::ScenePoint>{point(south_m, -half_m, 0), point(south_m, half_m, 0),
                                              point(south_m + 2 * half_m, half_m, 0), point(south_m + 2 * half_m, -half_m, 0)};
    };
    Watched watched;
    EXPECT_EQ(watched.layer(area(square(-30'000, 30'000), 1000, 3000)), 1) << "no corner is near";
    EXPECT_EQ(watched.layer(area(square(30'000, 3000), 1000, 3000)), 0);
    const double entered = watched.layer(area(square(6000, 3000), 1000, 3000));
    EXPECT_GT(entered, 0);
    EXPECT_LT(entered, 1);
    EXPECT_EQ(watched.layer(area(square(6000, 3000), 2400, 3000)), 0) << "under it";
    EXPECT_EQ(watched.layer(area(square(6000, 3000), 0, 1500)), 0) << "over it";
    EXPECT_EQ(watched.layer(area({point(3000, 5000, 0), point(6000, 5000, 0), point(6000, 9000, 0)}, 0, 9000)), 0) << "beside";
}

TEST(HazardWatch, TheFirstOneIsWhereItIsMet) {
    Watched watched;
    const LoadedScene far({"one", "a test", 1, {masts({point(6000, 0, 2000), point(3000, 0, 2000)})}});
    HazardWatch watch(watched.settings, watched.way, watched.ground, 0);
    earth::Geodetic met;
    EXPECT_FALSE(watch.first_met(met));
    EXPECT_EQ(watch.terrain_share(), 0);
    EXPECT_FALSE(watch.first_met(met)) << "asked for, and there is none";
    EXPECT_EQ(watch.layer_share(far.scene().layers()[0]), 1);
    ASSERT_TRUE(watch.first_met(met));
    const double north_m = (met.latitude_rad - base::radians(kLatitude_deg)) * earth::meridian_radius_m(met.latitude_rad);
    EXPECT_NEAR(north_m, 2600, 400) << "500 m before the nearer one, by steps of 375 m";
    EXPECT_EQ(met.longitude_rad, base::radians(kLongitude_deg));
    EXPECT_EQ(met.height.m, 2050);
}

TEST(HazardWatch, TheWayIsTheSameWhereverItLeads) {
    Watched north, east;
    east.way.east_mps = kSpeed_mps;
    east.way.north_mps = 0;
    for (double ahead_m = 1000; ahead_m < 11'000; ahead_m += 777)
        EXPECT_EQ(north.layer(masts({point(ahead_m, 100, 2000)})), east.layer(masts({point(-100, ahead_m, 2000)}))) << ahead_m;
}

TEST(HazardWatch, TerrainIsOneWhereTheWayComesDownToIt) {
    Watched watched;
    EXPECT_EQ(watched.terrain(), 0);
    watched.way.up_mps = -10;
    EXPECT_EQ(watched.terrain(), 0) << "still 500 m over it after 90 s";
    watched.way.up_mps = -30;
    EXPECT_EQ(watched.terrain(), 1);
    watched.ground.is_known = false;
    EXPECT_EQ(watched.terrain(), 0) << "what is not known is said otherwise";
}

/// Rises to 2000 m beyond a line east of where the way begins.
class RidgeEast final : public scene::Ground {
public:
    double height_m(double, double longitude_rad) override { return longitude_rad > from_rad ? 2000 : 600; }
    double undulation_m(double, double) override { return 0; }
    double from_rad = 0;
};

TEST(HazardWatch, TerrainAsideIsOneAsFarAsAnythingElse) {
    Watched watched;
    RidgeEast ridge;
    for (const double east_m : {-300.0, 200.0, 450.0, 550.0, 900.0}) {
        ridge.from_rad = point(0, east_m, 0).longitude_rad;
        EXPECT_EQ(HazardWatch(watched.settings, watched.way, ridge, 0).terrain_share(), east_m < 500 ? 1 : 0) << east_m;
        PredictedTrack back = watched.way;  // it lies on the other side of who flies the other way
        back.north_mps = -kSpeed_mps;
        EXPECT_EQ(HazardWatch(watched.settings, back, ridge, 0).terrain_share(), east_m < 500 ? 1 : 0) << east_m;
    }
}

}  // namespace
}  // namespace tedavis::policy::test_hazard_watch
