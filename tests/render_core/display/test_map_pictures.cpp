// The map and the way to it, in pictures. Oracle of places: GeographicLib's geodesics.
#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/display/display.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/built_database.hpp"
#include "tests/support/default_flight.hpp"
#include "tests/support/drawn_pixels.hpp"

namespace tedavis::display {
namespace {

using base::radians;
using base::SignalState;
using base::Time;
using flight::Signal;
using test_support::BuiltDatabase;

constexpr Time kNow{1'700'000'000'000'000'000};
constexpr double kGround_m = 1000;

const BuiltDatabase& hills() {
    static const BuiltDatabase built(test_support::make_rough_raster(241, 241));
    return built;
}

struct Place {
    double latitude_deg = 47.0, longitude_deg = 9.7;
};

/// Everything valid, 1000 m above the ground.
flight::AircraftState aircraft(const Place& place = {}, double heading_deg = 30, double track_deg = 30,
                               double msl_m = 2 * kGround_m) {
    flight::AircraftState state;
    const auto set = [&](Signal signal, double value) { state[signal] = {value, kNow}; };
    set(Signal::latitude, radians(place.latitude_deg));
    set(Signal::longitude, radians(place.longitude_deg));
    set(Signal::ellipsoid_height, msl_m);
    set(Signal::pitch, radians(2));
    set(Signal::roll, radians(-10));
    set(Signal::true_heading, radians(heading_deg));
    set(Signal::true_track, radians(track_deg));
    set(Signal::indicated_airspeed, 60);
    set(Signal::baro_altitude, msl_m);
    set(Signal::vertical_speed, 0);
    set(Signal::height_above_terrain, msl_m - kGround_m);
    state.own_ship.position = {radians(place.latitude_deg), radians(place.longitude_deg), {msl_m}};
    state.own_ship.velocity_north_mps = 60;
    state.own_ship.height_is_geometric = true;
    state.own_ship.at = kNow;
    state.own_ship.state = SignalState::valid;
    return state;
}

/// All signals again, later.
flight::AircraftState later(flight::AircraftState state, Time now) {
    for (auto& signal : state.signals)
        if (signal.received()) signal = {signal.value_or(0), now};
    state.own_ship.at = now;
    return state;
}

design::DesignSettings bare(design::DesignSettings design) {
    design.symbology = {};
    for (bool* shown :
         {&design.symbology.attitude, &design.symbology.map, &design.symbology.heading, &design.symbology.airspeed,
          &design.symbology.altitude, &design.symbology.vertical_speed, &design.symbology.flight_path,
          &design.symbology.baro_setting, &design.symbology.ground_height, &design.symbology.phase, &design.symbology.legend})
        *shown = false;
    return design;
}

design::DesignSettings map_design(double range_m = 5000, const std::string& name = "map_north_up") {
    design::DesignSettings design = test_support::shipped_design(name);
    design.view.map_range_m = range_m;
    return design;
}

/// The same terrain in 3D, so that one display can show both.
design::DesignSettings in_three_d(design::DesignSettings design) {
    design.view.mode = design::ViewMode::perspective;
    return design;
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    std::uint32_t width = 0, height = 0;
    [[nodiscard]] const std::uint8_t* at(std::uint32_t x, std::uint32_t y) const {
        return rgba.data() + (std::size_t{height - 1 - y} * width + x) * 4;
    }
    /// Mean of a channel round a place, from the top left corner.
    [[nodiscard]] double mean(double x, double y, std::size_t channel) const {
        double sum = 0;
        for (int dy = -2; dy <= 2; ++dy)
            for (int dx = -2; dx <= 2; ++dx)
                sum += at(static_cast<std::uint32_t>(x + dx), static_cast<std::uint32_t>(y + dy))[channel];
        return sum / 25;
    }
};
bool operator==(const Picture& a, const Picture& b) { return a.rgba == b.rgba; }
bool operator!=(const Picture& a, const Picture& b) { return !(a == b); }
int largest_difference(const Picture& a, const Picture& b) {
    int largest = 0;
    for (std::size_t n = 0; n < a.rgba.size(); ++n) largest = std::max(largest, std::abs(int{a.rgba[n]} - int{b.rgba[n]}));
    return largest;
}

/// One at a time: its surface is current.
struct Scene {
    test_support::MemoryBytes bytes;
    test_support::HeadlessDisplay headless;

    explicit Scene(const design::DesignSettings& design, const BuiltDatabase& terrain = hills(),
                   const std::string& device = "es3-mid", std::uint32_t width = 640, std::uint32_t height = 480)
        : bytes(terrain.image), headless("egl", device, width, height, &bytes, design) {}
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    [[nodiscard]] Display& display() { return headless.display(); }
    [[nodiscard]] const FrameRecord& record() { return display().record(); }

    /// With all terrain arrived.
    Picture picture(const flight::AircraftState& state, Time now = kNow) {
        display().settle(state, {}, now);
        display().update(state, {}, now);
        return drawn();
    }
    Picture drawn() { return {test_support::drawn_pixels(headless), headless.surface().width(), headless.surface().height()}; }
    [[nodiscard]] bool has_flag(std::string_view name) {
        const auto& flags = record().flags;
        return std::any_of(flags.begin(), flags.end(), [&](const Name& flag) { return flag.view() == name; });
    }
};

/// Of a display of its own.
Picture picture_of(const design::DesignSettings& design, const flight::AircraftState& state, Time now = kNow) {
    Scene scene(design);
    return scene.picture(state, now);
}

// -- where places lie

/// Flat ground with one post that stands out.
struct Peak {
    host_sim::Raster raster;
    Place own_ship, peak;
};

Peak peak_in(std::uint32_t columns, std::uint32_t rows, double west_deg, double north_deg, double step_lon_deg,
             double step_lat_deg, std::uint32_t i, std::uint32_t j, const Place& own_ship) {
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
    design::DesignSettings design = bare(map_design(range_m));
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
        Scene scene(height_design(kRange_m), built);
        const Picture picture = scene.picture(aircraft(peak.own_ship));
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
    Scene scene(map_design());
    flight::AircraftState turned = aircraft({}, 123, 200);
    turned[Signal::pitch] = {radians(-20), kNow};
    turned[Signal::roll] = {radians(50), kNow};
    const Picture pointing = scene.picture(aircraft({}, 0, 0));
    EXPECT_NE(pointing, scene.picture(turned)) << "the own ship points";
    ASSERT_TRUE(scene.display().set_design(bare(map_design())));
    const Picture north = scene.picture(aircraft({}, 0, 0));
    EXPECT_EQ(north, scene.picture(turned));
    EXPECT_NE(north, scene.picture(aircraft({47.001, 9.7}))) << "control";
}

TEST(MapPictures, TrackUpIsNorthUpTurned) {
    design::DesignSettings design = bare(map_design());
    design.terrain.style.sketch = {};
    Scene scene(design);
    const Picture north = scene.picture(aircraft());
    design.view.map_orientation = design::MapOrientation::track_up;
    ASSERT_TRUE(scene.display().set_design(design));
    for (const double track_deg : {0.0, 90.0, 237.0}) {
        const Picture turned = scene.picture(aircraft({}, 10, track_deg));
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
    Scene scene(bare(map_design()));
    const Picture whole = scene.picture(aircraft());
    flight::AircraftState state = aircraft();
    for (const Signal lost : {Signal::pitch, Signal::roll, Signal::true_heading, Signal::true_track}) state[lost] = {};
    const Picture without = scene.picture(state);
    EXPECT_GT(scene.record().terrain.triangles, 0u);
    for (const double x : {250.0, 320.0, 400.0})
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_EQ(without.mean(x, 300, channel), whole.mean(x, 300, channel));
}

TEST(MapPictures, WithoutAPositionThereIsNoMap) {
    Scene scene(map_design());
    const Picture shown = scene.picture(aircraft());
    for (const SignalState bad : {SignalState::missing, SignalState::stale, SignalState::lost, SignalState::invalid}) {
        flight::AircraftState here = aircraft(), elsewhere = aircraft({47.03, 9.72});
        here.own_ship.state = elsewhere.own_ship.state = bad;
        const Picture removed = scene.picture(here);
        EXPECT_NE(removed, shown);
        EXPECT_EQ(removed, scene.picture(elsewhere)) << "nothing tells where";
        EXPECT_EQ(scene.record().terrain.triangles, 0u);
        EXPECT_LT(removed.mean(320, 470, 2), 80) << "dark, no sky and no ground";
    }
}

TEST(MapPictures, WithoutTerrainTheGroundIsOneDarkColour) {
    Scene scene(map_design());
    const Picture outside = scene.picture(aircraft({48.5, 9.7}));
    EXPECT_TRUE(scene.has_flag("terrain.outside_database"));
    const std::uint8_t *high = outside.at(310, 70), *low = outside.at(310, 400);
    EXPECT_TRUE(std::equal(high, high + 3, low));
    EXPECT_LT(high[2], 64);
}

TEST(MapPictures, WarningColoursHold) {
    Scene scene(bare(map_design()));
    const Picture high = scene.picture(aircraft({}, 30, 30, 9000));
    EXPECT_EQ(scene.record().effects[1].state, EffectState::run);
    const Picture low = scene.picture(aircraft({}, 30, 30, 1100));
    double redder = 0;
    for (double x = 100; x < 540; x += 20)
        for (double y = 60; y < 420; y += 20) redder = std::max(redder, low.mean(x, y, 0) - high.mean(x, y, 0));
    EXPECT_GT(redder, 40);
}

TEST(MapPictures, HazeIsOff) {
    design::DesignSettings design = bare(map_design());
    Scene scene(design);
    const Picture clear = scene.picture(aircraft());
    design.sky.haze_distance_m = 500;
    ASSERT_TRUE(scene.display().set_design(design));
    EXPECT_EQ(clear, scene.picture(aircraft()));
    ASSERT_TRUE(scene.display().set_design(in_three_d(design)));
    EXPECT_NE(scene.picture(aircraft()), clear);
}

TEST(MapPictures, BothLanesDrawTheMapWithinTheirCalls) {
    Picture first;
    for (const char* device : {"es3-mid", "es2-small"}) {
        Scene scene(bare(map_design()), hills(), device);
        const Picture picture = scene.picture(aircraft());
        EXPECT_GT(scene.record().terrain.triangles, 100u);
        EXPECT_EQ(scene.display().gl().denied().total, 0u);
        EXPECT_LE(scene.record().terrain.worst_error_px, scene.record().terrain.tau_px);
        if (first.rgba.empty()) first = picture;
        for (double x = 100; x < 540; x += 40) EXPECT_NEAR(picture.mean(x, 200, 1), first.mean(x, 200, 1), 12) << device;
    }
}

/// Heights tell themselves by colours, so that a map needs meshes though their errors displace nothing.
TEST(MapPictures, TheMapIsNotDrawnFromTheCoarsestMesh) {
    Scene scene(bare(map_design(100'000)));
    static_cast<void>(scene.picture(aircraft()));
    const std::uint32_t few = scene.record().terrain.triangles;
    ASSERT_TRUE(scene.display().set_design(bare(map_design(3000))));
    static_cast<void>(scene.picture(aircraft()));
    EXPECT_GT(scene.record().terrain.triangles, 4 * few);
    EXPECT_EQ(scene.record().terrain.limit.view(), "met");
}

TEST(MapPictures, FromAboveThereAreNoSilhouettes) {
    design::DesignSettings design = map_design();
    design.terrain.style.sketch.silhouettes = 1;
    Scene scene(design);
    static_cast<void>(scene.picture(aircraft()));
    const auto state = [&] {
        for (const EffectRecord& effect : scene.record().effects)
            if (effect.name.view() == "silhouettes") return effect.state;
        return EffectState::replaced;
    };
    EXPECT_EQ(state(), EffectState::skipped);
    ASSERT_TRUE(scene.display().set_design(in_three_d(design)));
    static_cast<void>(scene.picture(aircraft()));
    EXPECT_EQ(state(), EffectState::run);
}

// -- the way between 3D and the map

struct Flight {
    Scene scene{in_three_d(map_design())};
    Time now = kNow;
    flight::AircraftState state = aircraft();

    Flight() { static_cast<void>(scene.picture(state)); }
    /// One frame later.
    const FrameRecord& step(double seconds) {
        now = now + base::Duration::from_seconds(seconds);
        state = later(state, now);
        scene.display().update(state, {}, now);
        return scene.record();
    }
};

TEST(MapPictures, AnotherModeTravelsAndArrives) {
    Picture arrived;
    flight::AircraftState state;
    Time now;
    {
        Flight flight;
        EXPECT_EQ(flight.scene.record().view.mode, design::ViewMode::perspective);
        EXPECT_EQ(flight.scene.record().view.transition, 1);
        const glm::dvec3 own = flight.scene.display().view().eye;
        ASSERT_TRUE(flight.scene.display().set_design(map_design()));
        double height_m = 0;
        for (int n = 1; n <= 10; ++n) {
            const FrameRecord& record = flight.step(0.1);
            EXPECT_EQ(record.view.mode, design::ViewMode::map);
            EXPECT_NEAR(record.view.transition, n / 10.0, 1e-6);
            EXPECT_GE(glm::length(flight.scene.display().view().eye - own), height_m);
            height_m = glm::length(flight.scene.display().view().eye - own);
            static_cast<void>(flight.scene.drawn());
            EXPECT_GT(flight.scene.record().terrain.triangles, 0u);
        }
        EXPECT_EQ(flight.step(0.1).view.transition, 1);
        now = flight.now;
        state = flight.state;
        arrived = flight.scene.picture(state, now);
    }
    const Picture at_once = picture_of(map_design(), state, now);
    EXPECT_LE(largest_difference(arrived, at_once), 1)
        << "as if it had always been a map, but for the places of pages in the atlas";
    EXPECT_GT(largest_difference(arrived, picture_of(in_three_d(map_design()), state, now)), 1) << "control";
}

TEST(MapPictures, TheWayBackEndsInTheSamePicture) {
    Flight flight;
    const Picture before = flight.scene.picture(flight.state, flight.now);
    ASSERT_TRUE(flight.scene.display().set_design(map_design()));
    flight.step(0.4);
    ASSERT_TRUE(flight.scene.display().set_design(in_three_d(map_design())));
    EXPECT_NEAR(flight.step(0.2).view.transition, 0.8, 1e-6);
    EXPECT_EQ(flight.step(0.3).view.transition, 1);
    EXPECT_LE(largest_difference(before, flight.scene.picture(flight.state, flight.now)), 1);
}

TEST(MapPictures, OnTheWayStandNoSymbolsThatWouldNotBeTrue) {
    design::DesignSettings shown = bare(map_design()), hidden = shown;
    shown.symbology.attitude = shown.symbology.map = shown.symbology.flight_path = true;
    const auto halfway = [](const design::DesignSettings& design) {
        Scene scene(in_three_d(design));
        flight::AircraftState state = aircraft();
        static_cast<void>(scene.picture(state));
        EXPECT_TRUE(scene.display().set_design(design));
        const Time now = kNow + base::Duration::milliseconds(500);
        return scene.picture(later(state, now), now);
    };
    EXPECT_EQ(halfway(shown), halfway(hidden));
    EXPECT_NE(picture_of(shown, aircraft()), picture_of(hidden, aircraft())) << "control";
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
}  // namespace tedavis::display
