// The map in pictures. Oracle of places: GeographicLib's geodesics.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>

#include "tests/support/scene/map_scene.hpp"

namespace tedavis::display::test_map_pictures {
namespace {

using base::radians;
using base::SignalState;
using flight::Signal;
using test_support::aircraft_on_map;
using test_support::BuiltDatabase;
using test_support::hills;
using test_support::HillsPicture;
using test_support::in_three_d;
using test_support::kHillsNow;
using test_support::map_design;
using test_support::MapPlace;
using test_support::MapScene;
using test_support::without_symbols;

// -- where places lie

/// Flat ground with one post that stands out.
struct Peak {
    host_sim::Raster raster;
    MapPlace own_ship, peak;
};

Peak peak_in(std::uint32_t columns, std::uint32_t rows, double west_deg, double north_deg, double step_lon_deg,
             double step_lat_deg, std::uint32_t i, std::uint32_t j, const MapPlace& own_ship) {
    Peak peak;
    peak.raster = test_support::make_raster(
        columns, rows, [&](std::uint32_t a, std::uint32_t b) { return a == i && b == j ? 1400.0f : 1000.0f; }, west_deg,
        north_deg);
    peak.raster.step_lon_deg = step_lon_deg;
    peak.raster.step_lat_deg = step_lat_deg;
    peak.own_ship = own_ship;
    peak.peak = {north_deg - j * step_lat_deg, west_deg + i * step_lon_deg};
    return peak;
}

/// Only heights give colours, black to white.
design::DesignSettings height_design(double range_m) {
    design::DesignSettings design = without_symbols(map_design(range_m));
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.sketch = {};
    design.terrain.unknown = {0, 0, 0};
    design.warning_colors = false;
    design.terrain.palette.stops.clear();
    static_cast<void>(design.terrain.palette.stops.try_push_back({1000, {0, 0, 0}}));
    static_cast<void>(design.terrain.palette.stops.try_push_back({1400, {255, 255, 255}}));
    return design;
}

TEST(MapPictures, APeakStandsAtItsDistanceAndAzimuth) {
    constexpr double kStep = 1.0 / 1200;
    const Peak peaks[] = {peak_in(121, 121, 9.6, 47.1, kStep, kStep, 70, 40, {47.05, 9.65}),
                          peak_in(121, 121, 179.95, 0.05, kStep, kStep, 85, 80, {0.0, 179.99}),
                          peak_in(120, 121, -180, 90, 3, kStep, 17, 30, {90, 0}),
                          peak_in(120, 121, -180, 90, 3, kStep, 17, 30, {89.99, -100})};
    for (const Peak& peak : peaks) {
        const BuiltDatabase built(peak.raster);
        constexpr double kRange_m = 6000;
        MapScene scene(height_design(kRange_m), built);
        const HillsPicture picture = scene.picture(aircraft_on_map(peak.own_ship));
        double distance_m = 0, azimuth_deg = 0, unused = 0;
        GeographicLib::Geodesic::WGS84().Inverse(peak.own_ship.latitude_deg, peak.own_ship.longitude_deg, peak.peak.latitude_deg,
                                                 peak.peak.longitude_deg, distance_m, azimuth_deg, unused);
        ASSERT_LT(distance_m, kRange_m);
        std::uint32_t at_x = 320, at_y = 60;
        for (std::uint32_t y = 60; y < 440; ++y)  // between the notices
            for (std::uint32_t x = 0; x < 640; ++x)
                if (picture.at(x, y)[0] > picture.at(at_x, at_y)[0]) at_x = x, at_y = y;
        EXPECT_GT(picture.at(at_x, at_y)[0], 150) << peak.own_ship.latitude_deg;
        const double px = distance_m * 240 / kRange_m;
        EXPECT_NEAR(at_x + 0.5, 320 + px * std::sin(radians(azimuth_deg)), 1) << peak.own_ship.latitude_deg;
        EXPECT_NEAR(at_y + 0.5, 240 - px * std::cos(radians(azimuth_deg)), 1) << peak.own_ship.latitude_deg;
    }
}

TEST(MapPictures, NorthUpDependsOnNoAttitudeAndNoHeading) {
    MapScene scene(map_design());
    flight::AircraftState turned = aircraft_on_map({}, 123, 200);
    turned[Signal::pitch] = {radians(-20), kHillsNow};
    turned[Signal::roll] = {radians(50), kHillsNow};
    const HillsPicture pointing = scene.picture(aircraft_on_map({}, 0, 0));
    EXPECT_NE(pointing, scene.picture(turned)) << "the own ship points";
    ASSERT_TRUE(scene.display().set_design(without_symbols(map_design())));
    const HillsPicture north = scene.picture(aircraft_on_map({}, 0, 0));
    EXPECT_EQ(north, scene.picture(turned));
    EXPECT_NE(north, scene.picture(aircraft_on_map({47.001, 9.7}))) << "control";
}

TEST(MapPictures, TrackUpIsNorthUpTurned) {
    design::DesignSettings design = without_symbols(map_design());
    design.terrain.style.sketch = {};
    MapScene scene(design);
    const HillsPicture north = scene.picture(aircraft_on_map());
    design.view.map_orientation = design::MapOrientation::track_up;
    ASSERT_TRUE(scene.display().set_design(design));
    for (const double track_deg : {0.0, 90.0, 237.0}) {
        const HillsPicture turned = scene.picture(aircraft_on_map({}, 10, track_deg));
        double worst = 0, unturned = 0;
        for (double angle_deg = 0; angle_deg < 360; angle_deg += 9)
            for (const double radius : {30.0, 90.0, 150.0}) {
                const double a = radians(angle_deg), b = radians(angle_deg - track_deg);
                const double x = 320 + radius * std::sin(a), y = 240 - radius * std::cos(a);
                for (std::size_t channel = 0; channel < 3; ++channel) {
                    const double is = turned.mean(320 + radius * std::sin(b), 240 - radius * std::cos(b), channel);
                    worst = std::max(worst, std::abs(is - north.mean(x, y, channel)));
                    unturned = std::max(unturned, std::abs(turned.mean(x, y, channel) - north.mean(x, y, channel)));
                }
            }
        EXPECT_LT(worst, 2) << track_deg;
        EXPECT_EQ(unturned > 8, track_deg > 0) << "control";
    }
}

// -- what the map needs

TEST(MapPictures, WithoutAttitudeAndHeadingTheMapStays) {
    MapScene scene(without_symbols(map_design()));
    const HillsPicture whole = scene.picture(aircraft_on_map());
    flight::AircraftState state = aircraft_on_map();
    for (const Signal lost : {Signal::pitch, Signal::roll, Signal::true_heading, Signal::true_track}) state[lost] = {};
    const HillsPicture without = scene.picture(state);
    EXPECT_GT(scene.record().terrain.triangles, 0u);
    for (const double x : {250.0, 320.0, 400.0})
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_EQ(without.mean(x, 300, channel), whole.mean(x, 300, channel));
}

TEST(MapPictures, WithoutAPositionThereIsNoMap) {
    MapScene scene(map_design());
    const HillsPicture shown = scene.picture(aircraft_on_map());
    for (const SignalState bad : {SignalState::missing, SignalState::stale, SignalState::lost, SignalState::invalid}) {
        flight::AircraftState here = aircraft_on_map(), elsewhere = aircraft_on_map({47.03, 9.72});
        here.own_ship.state = elsewhere.own_ship.state = bad;
        const HillsPicture removed = scene.picture(here);
        EXPECT_NE(removed, shown);
        EXPECT_EQ(removed, scene.picture(elsewhere)) << "nothing tells where";
        EXPECT_EQ(scene.record().terrain.triangles, 0u);
        EXPECT_LT(removed.mean(320, 470, 2), 80) << "dark, no sky and no ground";
    }
}

TEST(MapPictures, WithoutTerrainTheGroundIsOneDarkColor) {
    MapScene scene(map_design());
    const HillsPicture outside = scene.picture(aircraft_on_map({48.5, 9.7}));
    EXPECT_TRUE(scene.has_flag("terrain.outside_database"));
    const std::uint8_t *high = outside.at(310, 70), *low = outside.at(310, 400);
    EXPECT_TRUE(std::equal(high, high + 3, low));
    EXPECT_LT(high[2], 64);
}

TEST(MapPictures, WarningColorsHold) {
    MapScene scene(without_symbols(map_design()));
    const HillsPicture high = scene.picture(aircraft_on_map({}, 30, 30, 9000));
    EXPECT_EQ(scene.record().effects[1].state, EffectState::run);
    const HillsPicture low = scene.picture(aircraft_on_map({}, 30, 30, 1100));
    double redder = 0;
    for (double x = 100; x < 540; x += 20)
        for (double y = 60; y < 420; y += 20) redder = std::max(redder, low.mean(x, y, 0) - high.mean(x, y, 0));
    EXPECT_GT(redder, 40);
}

TEST(MapPictures, HazeIsOff) {
    design::DesignSettings design = without_symbols(map_design());
    MapScene scene(design);
    const HillsPicture clear = scene.picture(aircraft_on_map());
    design.sky.haze_distance_m = 500;
    ASSERT_TRUE(scene.display().set_design(design));
    EXPECT_EQ(clear, scene.picture(aircraft_on_map()));
    ASSERT_TRUE(scene.display().set_design(in_three_d(design)));
    EXPECT_NE(scene.picture(aircraft_on_map()), clear);
}

TEST(MapPictures, BothLanesDrawTheMapWithinTheirCalls) {
    HillsPicture first;
    for (const char* device : {"es3-mid", "es2-small"}) {
        MapScene scene(without_symbols(map_design()), hills(), device);
        const HillsPicture picture = scene.picture(aircraft_on_map());
        EXPECT_GT(scene.record().terrain.triangles, 100u);
        EXPECT_EQ(scene.display().gl().denied().total, 0u);
        EXPECT_LE(scene.record().terrain.worst_error_px, scene.record().terrain.tau_px);
        if (first.rgba.empty()) first = picture;
        for (double x = 100; x < 540; x += 40) EXPECT_NEAR(picture.mean(x, 200, 1), first.mean(x, 200, 1), 12) << device;
    }
}

/// Heights tell themselves by colours, so that a map needs meshes though their errors displace nothing.
TEST(MapPictures, TheMapIsNotDrawnFromTheCoarsestMesh) {
    MapScene scene(without_symbols(map_design(100'000)));
    static_cast<void>(scene.picture(aircraft_on_map()));
    const std::uint32_t few = scene.record().terrain.triangles;
    ASSERT_TRUE(scene.display().set_design(without_symbols(map_design(3000))));
    static_cast<void>(scene.picture(aircraft_on_map()));
    EXPECT_GT(scene.record().terrain.triangles, 4 * few);
    EXPECT_EQ(scene.record().terrain.limit.view(), "met");
}

TEST(MapPictures, FromAboveThereAreNoSilhouettes) {
    design::DesignSettings design = map_design();
    design.terrain.style.sketch.silhouettes = 1;
    MapScene scene(design);
    static_cast<void>(scene.picture(aircraft_on_map()));
    const auto state = [&] {
        for (const EffectRecord& effect : scene.record().effects)
            if (effect.name.view() == "silhouettes") return effect.state;
        return EffectState::replaced;
    };
    EXPECT_EQ(state(), EffectState::skipped);
    ASSERT_TRUE(scene.display().set_design(in_three_d(design)));
    static_cast<void>(scene.picture(aircraft_on_map()));
    EXPECT_EQ(state(), EffectState::run);
}

}  // namespace
}  // namespace tedavis::display::test_map_pictures
