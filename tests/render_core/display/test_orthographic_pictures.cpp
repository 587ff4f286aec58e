// The orthographic view and the flat ground in pictures. Oracle: a parallel projection of GeographicLib's local coordinates.
#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/map_scene.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_orthographic_pictures {
namespace {

using base::radians;
using test_support::aircraft_on_map;
using test_support::BuiltDatabase;
using test_support::HillsPicture;
using test_support::kHillsNow;
using test_support::map_design;
using test_support::MapPlace;
using test_support::MapScene;
using test_support::without_symbols;

constexpr double kRange_m = 6000, kDown_deg = 35, kPxPerM = 240 / kRange_m;
constexpr double kGround_m = 1000, kPeak_m = 1400, kOwnShip_m = 2000;
constexpr MapPlace kOwnShip{47.05, 9.65};

/// Level ground with a pyramid on it.
const BuiltDatabase& peak_ground() {
    static const BuiltDatabase built([] {
        host_sim::Raster raster = test_support::make_raster(
            121, 121,
            [](std::uint32_t i, std::uint32_t j) {
                const int away = std::max(std::abs(static_cast<int>(i) - 70), std::abs(static_cast<int>(j) - 40));
                return static_cast<float>(std::max(kGround_m, kPeak_m - 80.0 * away));
            },
            9.6, 47.1);
        raster.step_lon_deg = raster.step_lat_deg = 1.0 / 1200;
        return raster;
    }());
    return built;
}
constexpr MapPlace kPeak{47.1 - 40 / 1200.0, 9.6 + 70 / 1200.0};

/// Only heights give colours, black to white.
design::DesignSettings ortho_design(double turn_deg, design::Reference reference, double flat_msl_m = 0) {
    design::DesignSettings design = without_symbols(map_design(kRange_m));
    design.view.mode = design::ViewMode::orthographic;
    design.view.look_down_rad = radians(kDown_deg);
    design.view.look_turn_rad = radians(turn_deg);
    design.view.reference = reference;
    design.view.flat_msl_m = flat_msl_m;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.sketch = {};
    design.terrain.unknown = {0, 0, 0};
    design.warning_colors = false;
    design.terrain.palette.stops.clear();
    static_cast<void>(design.terrain.palette.stops.try_push_back({kGround_m, {0, 0, 0}}));
    static_cast<void>(design.terrain.palette.stops.try_push_back({kPeak_m, {255, 255, 255}}));
    return design;
}

struct Spot {
    double x = 0, y = 0;
};

/// Where a parallel projection onto the own ship puts a place; heights above MSL.
Spot expected(const MapPlace& place, double msl_m, double turn_deg) {
    const double undulation_m = peak_ground().database.undulation(radians(place.latitude_deg), radians(place.longitude_deg)).m;
    const GeographicLib::LocalCartesian frame(kOwnShip.latitude_deg, kOwnShip.longitude_deg, kOwnShip_m);
    double east = 0, north = 0, up = 0;
    frame.Forward(place.latitude_deg, place.longitude_deg, msl_m + undulation_m, east, north, up);
    const double turn = radians(turn_deg), down = radians(kDown_deg);
    const double right = east * std::cos(turn) - north * std::sin(turn), ahead = east * std::sin(turn) + north * std::cos(turn);
    return {320 + kPxPerM * right, 240 - kPxPerM * (ahead * std::sin(down) + up * std::cos(down))};
}

Spot brightest(const HillsPicture& picture) {
    std::uint32_t at_x = 320, at_y = 40;
    for (std::uint32_t y = 40; y < 440; ++y)  // between the notices
        for (std::uint32_t x = 0; x < 640; ++x)
            if (picture.at(x, y)[0] > picture.at(at_x, at_y)[0]) at_x = x, at_y = y;
    EXPECT_GT(picture.at(at_x, at_y)[0], 120);
    return {at_x + 0.5, at_y + 0.5};
}

constexpr const char* kDevices[] = {"es3-mid", "es2-small"};

TEST(OrthographicPictures, APeakStandsWhereAParallelProjectionPutsIt) {
    for (const char* device : kDevices)
        for (const double turn_deg : {0.0, 75.0, -160.0}) {
            MapScene scene(ortho_design(turn_deg, design::Reference::terrain), peak_ground(), device);
            const Spot found = brightest(scene.picture(aircraft_on_map(kOwnShip, 30, 30, kOwnShip_m)));
            const Spot peak = expected(kPeak, kPeak_m, turn_deg), foot = expected(kPeak, kGround_m, turn_deg);
            EXPECT_NEAR(found.x, peak.x, 1.5) << device << " " << turn_deg;
            EXPECT_NEAR(found.y, peak.y, 1.5) << device << " " << turn_deg;
            EXPECT_GT(foot.y - peak.y, 10) << "its height is seen";
            EXPECT_EQ(scene.record().view.mode, design::ViewMode::orthographic);
            EXPECT_EQ(scene.record().view.transition, 1);
            EXPECT_FALSE(scene.has_flag("terrain.flat"));
        }
}

TEST(OrthographicPictures, OnAFlatGroundItLiesInThePlane) {
    for (const char* device : kDevices)
        for (const double flat_msl_m : {0.0, 700.0}) {
            MapScene scene(ortho_design(0, design::Reference::flat, flat_msl_m), peak_ground(), device);
            const Spot found = brightest(scene.picture(aircraft_on_map(kOwnShip, 30, 30, kOwnShip_m)));
            const Spot plane = expected(kPeak, flat_msl_m, 0), relief = expected(kPeak, kPeak_m, 0);
            EXPECT_NEAR(found.x, plane.x, 1.5) << device << " " << flat_msl_m;
            EXPECT_NEAR(found.y, plane.y, 1.5) << device << " " << flat_msl_m;
            EXPECT_GT(plane.y - relief.y, 15) << "control: elsewhere than on the relief";
            EXPECT_TRUE(scene.has_flag("terrain.flat")) << "the record says so";
        }
}

/// The ground is drawn wherever its plane is in the picture, though its relief would be seen elsewhere.
TEST(OrthographicPictures, TheFlatGroundFillsThePictureOverHills) {
    for (const char* device : kDevices) {
        design::DesignSettings design = ortho_design(0, design::Reference::flat, -400);
        design.view.map_range_m = 1500;
        design.terrain.unknown = {255, 0, 255};
        MapScene scene(design, test_support::hills(), device);
        const HillsPicture picture = scene.picture(aircraft_on_map({}, 30, 30, 1500));
        int unknown = 0;
        for (std::uint32_t y = 60; y < 420; ++y)
            for (std::uint32_t x = 0; x < 640; ++x)
                unknown += picture.at(x, y)[0] > 200 && picture.at(x, y)[2] > 200 && picture.at(x, y)[1] < 60;
        EXPECT_EQ(unknown, 0) << device;
    }
}

/// A ball at each of two heights, side by side.
host_sim::LayerDraft balls(double left_msl_m, double right_msl_m) {
    host_sim::LayerDraft layer;
    layer.name = "balls";
    layer.role = scene::LayerRole::sample;
    layer.height_datum = scene::HeightDatum::msl;
    const double latitude = radians(kOwnShip.latitude_deg), longitude = radians(kOwnShip.longitude_deg);
    for (const double side : {-1.0, 1.0})
        layer.points.push_back({latitude, longitude + side * radians(0.003),
                                static_cast<float>(side < 0 ? left_msl_m : right_msl_m), 0, scene::kNoTime});
    host_sim::AttributeDraft attribute;
    attribute.name = "value";
    attribute.values = {1, 1};
    layer.attributes.push_back(attribute);
    return layer;
}

/// Red pixels left and right of the middle.
struct Sides {
    int left = 0, right = 0;
};
Sides balls_seen(design::DesignSettings design, const char* device, double own_ship_m, double left_msl_m, double right_msl_m) {
    design::DataElement element;
    element.layer = "balls";
    element.technique = design::DataTechnique::spheres;
    element.size_m = 80;
    element.by_color.attribute = "value";
    for (const double value : {0.0, 1.0})
        static_cast<void>(element.by_color.scale.palette.stops.try_push_back({value, {250, 0, 0}}));
    static_cast<void>(design.data.elements.try_push_back(element));
    design.view.map_range_m = 900;
    test_support::FlakyBytes scene_bytes(
        host_sim::sdb_bytes(host_sim::SceneDraft{"one", "a test", 1, {balls(left_msl_m, right_msl_m)}}));
    MapScene scene(design, peak_ground(), device, 640, 480, &scene_bytes);
    const HillsPicture picture = scene.picture(aircraft_on_map(kOwnShip, 30, 30, own_ship_m));
    Sides seen;
    for (std::uint32_t y = 0; y < 480; ++y)
        for (std::uint32_t x = 0; x < 640; ++x)
            if (picture.at(x, y)[0] > 100 && picture.at(x, y)[1] < 60) ++(x < 320 ? seen.left : seen.right);
    return seen;
}

/// The depth of the flat ground is that of its plane, wherever the relief is.
TEST(OrthographicPictures, ThePlaneHidesWhatIsBelowItAndNothingElse) {
    const design::DesignSettings relief = ortho_design(0, design::Reference::terrain);
    for (const char* device : kDevices) {
        const auto over_plane = [&](double plane_m) { return ortho_design(0, design::Reference::flat, plane_m); };
        const Sides high = balls_seen(over_plane(2500), device, 2500, 2560, 2440);
        EXPECT_GT(high.left, 100) << device << ", over the plane";
        EXPECT_EQ(high.right, 0) << device << ", below the plane, though high over the relief";
        const Sides in_air = balls_seen(relief, device, 2500, 2560, 2440);
        EXPECT_GT(in_air.left, 100) << device;
        EXPECT_NEAR(in_air.right, in_air.left, 30) << device << ", and as large as the other";
        const Sides low = balls_seen(over_plane(800), device, 1300, 900, 800);
        EXPECT_GT(low.left, 100) << device << ", under the relief, over the plane";
        EXPECT_GT(low.right, 50) << device << ", half in the plane";
        EXPECT_LT(low.right, low.left) << device;
        const Sides buried = balls_seen(relief, device, 1300, 900, 800);
        EXPECT_EQ(buried.left + buried.right, 0) << device << ": the relief hides both";
    }
}

TEST(OrthographicPictures, DependsOnNoAttitude) {
    MapScene scene(ortho_design(20, design::Reference::terrain));
    flight::AircraftState turned = aircraft_on_map({}, 123, 200);
    turned[flight::Signal::pitch] = {radians(-20), kHillsNow};
    turned[flight::Signal::roll] = {};
    EXPECT_TRUE(scene.picture(aircraft_on_map()) == scene.picture(turned)) << "north up";
    const HillsPicture here = scene.picture(aircraft_on_map());
    EXPECT_TRUE(here != scene.picture(aircraft_on_map({47.01, 9.7}))) << "but on the place";
}

TEST(OrthographicPictures, NoConformalSymbolStandsInIt) {
    design::DesignSettings design = map_design(kRange_m);
    design.view.mode = design::ViewMode::orthographic;
    design::DesignSettings without = design;
    without.symbology.attitude = without.symbology.flight_path = false;
    const HillsPicture with_them = test_support::map_picture(design, aircraft_on_map());
    EXPECT_TRUE(with_them == test_support::map_picture(without, aircraft_on_map()));
    without.symbology.map = false;
    EXPECT_TRUE(with_them != test_support::map_picture(without, aircraft_on_map())) << "those of the map do";
}

TEST(OrthographicPictures, WhetherTheGroundIsFlatIsSettledAtTheStart) {
    MapScene scene(ortho_design(0, design::Reference::terrain));
    EXPECT_FALSE(scene.display().set_design(ortho_design(0, design::Reference::flat)));
    EXPECT_TRUE(scene.display().set_design(ortho_design(30, design::Reference::terrain)));
}

}  // namespace
}  // namespace tedavis::display::test_orthographic_pictures
