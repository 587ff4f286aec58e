#include "render_core/policy/terrain_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/base/utc_time.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/flights/placed_aircraft.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::policy::test_terrain_light {
namespace {

using base::degrees;
using base::radians;

const earth::Geodetic kPlace{radians(47.05), radians(9.65), {2000}};

base::Time utc(const char* text) {
    base::Time time;
    EXPECT_TRUE(base::parse_utc(text, time)) << text;
    return time;
}

design::ShadeSettings sunny() {
    design::ShadeSettings shade;
    shade.follows_sun = true;
    return shade;
}

TEST(TerrainLight, StandsWhereTheDesignSaysOrWhereTheSunIs) {
    design::ShadeSettings shade;
    shade.lights[0] = {radians(200), radians(30), 1};
    const TerrainLight fixed = terrain_light(shade, kPlace, utc("2026-06-21T11:00:00Z"));
    EXPECT_EQ(fixed.source, LightSource::fixed);
    EXPECT_DOUBLE_EQ(degrees(fixed.azimuth_rad), 200);
    shade.follows_sun = true;
    // True noon at 9.65 E in late June: 12:00 - 38.6 min + 2 min of the equation of time = 11:23 UTC.
    const TerrainLight noon = terrain_light(shade, kPlace, utc("2026-06-21T11:23:20Z"));
    EXPECT_EQ(noon.source, LightSource::sun);
    EXPECT_NEAR(degrees(noon.azimuth_rad), 180, 0.5);
    EXPECT_NEAR(degrees(noon.elevation_rad), 90 - 47.05 + 23.44, 0.03);
    shade.sun_is_fixed = true;
    shade.sun_utc = utc("2026-06-21T11:23:20Z");
    const TerrainLight stated = terrain_light(shade, kPlace, utc("2026-12-21T07:00:00Z"));
    EXPECT_EQ(stated.azimuth_rad, noon.azimuth_rad) << "whenever the source says";
}

TEST(TerrainLight, TheFixedLightServesWithoutADateAndAtNight) {
    const design::ShadeSettings shade = sunny();
    for (const base::Time no_date : {base::Time{0}, base::Time{3'600'000'000'000}, base::Time{-5}, utc("1999-12-31T23:59:59Z")}) {
        const TerrainLight light = terrain_light(shade, kPlace, no_date);
        EXPECT_EQ(light.source, LightSource::no_date) << no_date.ns;
        EXPECT_EQ(light.elevation_rad, shade.lights[0].elevation_rad);
    }
    const TerrainLight night = terrain_light(shade, kPlace, utc("2026-06-21T23:00:00Z"));
    EXPECT_EQ(night.source, LightSource::sun_too_low);
    EXPECT_EQ(night.azimuth_rad, shade.lights[0].azimuth_rad);
    EXPECT_EQ(night.elevation_rad, shade.lights[0].elevation_rad);
    int risen = 0;
    for (int minute = 0; minute < 24 * 60; ++minute) {
        const TerrainLight light =
            terrain_light(shade, kPlace, utc("2026-03-20T00:00:00Z") + base::Duration::seconds(60 * minute));
        risen += light.source == LightSource::sun ? 1 : 0;
        EXPECT_GE(light.elevation_rad, kLowestSun_rad) << minute;
    }
    // At the equinox the sun climbs 15 cos 47 degrees an hour: 3 degrees take it 17.6 minutes.
    EXPECT_NEAR(risen, 12 * 60 - 2 * 17.6, 8);
}

TEST(TerrainLight, DirectionIsThatOfTheLocalCompass) {
    const glm::dmat3 axes = earth::north_east_down(kPlace.latitude_rad, kPlace.longitude_rad);
    const glm::dvec3 east = towards_light(radians(90), 0, kPlace), up = towards_light(radians(17), radians(90), kPlace);
    EXPECT_NEAR(glm::dot(east, axes[1]), 1, 1e-12);
    EXPECT_NEAR(glm::dot(up, axes[2]), -1, 1e-12);
    EXPECT_NEAR(glm::length(towards_light(radians(200), radians(33), kPlace)), 1, 1e-12);
}

// -- pictures: the shadow of a wall from north to south on a plain ---------------------------------------------------------

constexpr std::uint32_t kSide = 257, kWallWest = 112, kWallEast = 143;  // first and last column, so wide that no mean loses it
constexpr double kWall_m = 600, kWest_deg = 9.6, kNorth_deg = 47.1, kStep_deg = 1.0 / 1200;

const test_support::BuiltDatabase& wall() {
    static const test_support::BuiltDatabase built(test_support::make_raster(kSide, kSide, [](std::uint32_t i, std::uint32_t) {
        return kWallWest <= i && i <= kWallEast ? 1000.0f + static_cast<float>(kWall_m) : 1000.0f;
    }));
    return built;
}

design::DesignSettings shadow_design() {
    design::DesignSettings design = design::default_design_settings();
    design.name = "shadow";
    design.sky.haze_distance_m = 0;
    design.warning_colors = false;
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade = sunny();
    design.terrain.style.shade.cast_shadows = true;
    design.terrain.style.shade.ambient = 0.3;
    return design;
}

/// Above the middle of the wall.
flight::AircraftState aircraft(base::Time now) {
    return test_support::aircraft_at(
        {radians(kNorth_deg - kSide / 2 * kStep_deg), radians(kWest_deg + kSide / 2 * kStep_deg), {9000}}, now);
}

struct WallPicture {
    static constexpr std::uint32_t kWidth = 480, kHeight = 64;
    static constexpr double kEyeAbove_m = 10000;

    test_support::MemoryBytes bytes{wall().image};
    test_support::HeadlessDisplay display{"egl", "es3-mid", kWidth, kHeight, &bytes, shadow_design()};
    terrain::View view;

    /// Straight down on the plain, north up.
    void look_down(const flight::AircraftState& state) {
        earth::Geodetic eye = state.own_ship.position;
        eye.height.m = wall().database.undulation(eye.latitude_rad, eye.longitude_rad).m + 1000 + kEyeAbove_m;
        const glm::dmat3 axes = earth::north_east_down(eye.latitude_rad, eye.longitude_rad);
        view = {earth::to_ecef(eye), axes[2], axes[1], -axes[0], 480, kWidth, kHeight, 100, 100000, {}};
        display.display().planner().set_free_view(view);
    }
    /// Red of the middle row.
    std::vector<int> row(base::Time now) {
        const flight::AircraftState state = aircraft(now);
        look_down(state);
        const std::vector<std::uint8_t> rgba = test_support::settled_pixels(display, state, now);
        std::vector<int> red;
        for (std::uint32_t x = 0; x < kWidth; ++x) red.push_back(rgba[(std::size_t{kHeight / 2} * kWidth + x) * 4]);
        return red;
    }
    [[nodiscard]] double east_m(double x) const { return (x - kWidth / 2.0) * kEyeAbove_m / view.focal_px; }
};

/// Metres from a side of the wall to where the plain beyond it is lit again.
double shadow_length_m(const WallPicture& picture, const std::vector<int>& row, double elevation_rad, bool eastwards) {
    const double column_m = kStep_deg * base::kPi / 180 * 6.388e6 * std::cos(radians(47.0));
    const int lit = static_cast<int>(255 * (0.3 + 0.7 * std::sin(elevation_rad))), dark = static_cast<int>(255 * 0.3);
    const int eye_column = kSide / 2;
    const double edge_m =
        eastwards ? column_m * (static_cast<int>(kWallEast) - eye_column) : column_m * (eye_column - static_cast<int>(kWallWest));
    double farthest = 0;
    for (std::size_t x = 0; x < row.size(); ++x) {
        const double east = picture.east_m(static_cast<double>(x) + 0.5);
        const double away = (eastwards ? east : -east) - edge_m;
        if (away > 3 * column_m && row[x] < (lit + dark) / 2) farthest = std::max(farthest, away);
    }
    return farthest;
}

TEST(TerrainLight, TheShadowOfAWallFallsWhereTheSunThrowsIt) {
    WallPicture picture;
    struct Case {
        const char* when;
        bool eastwards;
        double tolerance;  // of the length, beside a texel of the horizons
    };
    // First the sun in the east and west, where horizons are baked; then between two of the 16 directions, where a long wall
    // looks lower by the linear mix of its horizons.
    for (const Case& c : {Case{"2026-04-19T06:36:00Z", false, 0.05},
                          {"2026-04-19T16:06:00Z", true, 0.05},
                          {"2026-03-21T06:30:00Z", false, 0.15},
                          {"2026-03-21T07:00:00Z", false, 0.15},
                          {"2026-03-21T16:00:00Z", true, 0.15}}) {
        const base::Time now = utc(c.when);
        const std::vector<int> row = picture.row(now);
        const TerrainLight& light = picture.display.display().record().light;
        ASSERT_EQ(light.source, LightSource::sun);
        const double expected = kWall_m / std::tan(light.elevation_rad) * std::fabs(std::sin(light.azimuth_rad));
        EXPECT_NEAR(shadow_length_m(picture, row, light.elevation_rad, c.eastwards), expected, c.tolerance * expected + 130)
            << c.when << " sun at " << degrees(light.azimuth_rad) << ", " << degrees(light.elevation_rad);
        EXPECT_EQ(shadow_length_m(picture, row, light.elevation_rad, !c.eastwards), 0) << c.when << ": control, the sunny side";
    }
}

TEST(TerrainLight, HorizonsAreMixedAgainOnlyWhenTheAzimuthHasMovedAStep) {
    WallPicture picture;
    const base::Time now = utc("2026-03-21T07:00:00Z");
    static_cast<void>(picture.row(now));
    const auto uploaded_after = [&](base::Duration later) {
        static_cast<void>(picture.row(now + later));
        return picture.display.display().record().bytes.uploaded;
    };
    EXPECT_EQ(uploaded_after(base::Duration::seconds(0)), 0u);
    int moved = 0;
    for (int second = 1; second <= 10; ++second) moved += uploaded_after(base::Duration::seconds(second)) > 0 ? 1 : 0;
    EXPECT_LE(moved, 4) << "each of a few pages once: in ten seconds the sun turns by 0.04 degrees";
    EXPECT_GT(uploaded_after(base::Duration::seconds(300)), 0u) << "control: five minutes later";
}

TEST(TerrainLight, APictureDependsOnItsInstantAlone) {
    const base::Time now = utc("2026-03-21T15:30:00Z");
    const auto direct = [&](base::Time time) { return WallPicture().row(time); };
    const std::vector<int> first = direct(now);
    EXPECT_NE(direct(now - base::Duration::seconds(1800)), first) << "control";
    WallPicture after_others;
    for (int minutes = 60; minutes > 0; minutes -= 7)
        static_cast<void>(after_others.row(now - base::Duration::seconds(60 * minutes)));
    EXPECT_EQ(after_others.row(now), first);
}

TEST(TerrainLight, TheRecordSaysWhoShines) {
    WallPicture picture;
    const auto effect_at = [&](const char* when) {
        static_cast<void>(picture.row(utc(when)));
        for (const display::EffectRecord& effect : picture.display.display().record().effects)
            if (effect.name.view() == "moving_sun") return effect;
        return display::EffectRecord{};
    };
    EXPECT_EQ(effect_at("2026-03-21T12:00:00Z").state, display::EffectState::run);
    const display::EffectRecord night = effect_at("2026-03-21T22:00:00Z");
    EXPECT_EQ(night.state, display::EffectState::replaced);
    EXPECT_EQ(night.replaced_by.view(), "fixed_light");
    EXPECT_NE(std::string(night.reason.view()).find("below 3 degrees"), std::string::npos);
    EXPECT_NE(std::string(effect_at("1980-01-01T12:00:00Z").reason.view()).find("sun_utc"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::policy::test_terrain_light
