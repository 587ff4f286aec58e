// What the shaders color of an alert's zone, in pictures of hills, against policy::violation_at() at the ground of each pixel.
#include "render_core/draw/drawers/alert_zone_uniforms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/terrain/chunk_drawing.hpp"

namespace tedavis::draw::test_alert_zone_uniforms {
namespace {

using policy::TerrainAhead;
using policy::TerrainAlertZone;
using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::RasterScene;

constexpr int kWidth = RasterScene::kWidth, kHeight = RasterScene::kHeight;
constexpr std::size_t place_of(int column, int row) {
    return static_cast<std::size_t>(row) * kWidth + static_cast<std::size_t>(column);
}
constexpr double kHighest_m = 860, kFlat_m = 550;

const RasterScene& hills() {
    static const RasterScene scene(test_support::make_raster(161, 161, [](std::uint32_t i, std::uint32_t j) {
        return 600.0f + 250.0f * std::sin(static_cast<float>(i) / 9) * std::cos(static_cast<float>(j) / 7);
    }));
    return scene;
}

earth::Geodetic own_ship() { return hills().place(80, 118, 800); }

/// From behind the own ship and above it.
TerrainDrawInput hills_input(bool is_flat) {
    TerrainDrawInput input = test_support::lit_from_above(hills().view(78, 130, 2600, 6, -28));
    if (is_flat) input.view.flat_msl_m = kFlat_m;
    return input;
}

/// Of the triangles of the raster; empty outside.
std::optional<double> surface_msl_m(const earth::Geodetic& at) {
    const host_sim::Raster& raster = hills().raster;
    const double x = (base::degrees(at.longitude_rad) - raster.west_deg) / raster.step_lon_deg,
                 y = (raster.north_deg - base::degrees(at.latitude_rad)) / raster.step_lat_deg;
    if (!(x >= 0 && y >= 0 && x < raster.columns - 1 && y < raster.rows - 1)) return std::nullopt;
    const auto i = static_cast<std::uint32_t>(x), j = static_cast<std::uint32_t>(y);
    const double u = x - i, v = y - j;
    const auto post = [&](std::uint32_t a, std::uint32_t b) { return double{raster.height_m[raster.at(a, b)]}; };
    if (u + v <= 1) return post(i, j) + u * (post(i + 1, j) - post(i, j)) + v * (post(i, j + 1) - post(i, j));
    return post(i + 1, j + 1) + (1 - u) * (post(i, j + 1) - post(i + 1, j + 1)) + (1 - v) * (post(i + 1, j) - post(i + 1, j + 1));
}

struct GroundPlace {
    bool is_hit = false;
    double north_m = 0, east_m = 0, height_m = 0;
};

/// The ground that a pixel's middle looks at, of the full raster: the first place of its ray below the surface that is drawn.
GroundPlace place_of_pixel(const terrain::View& view, int column, int row) {
    const glm::dvec3 ray = glm::normalize(view.forward + view.right * ((column + 0.5 - 0.5 * view.width) / view.focal_px) +
                                          view.down * ((row + 0.5 - 0.5 * view.height) / view.focal_px));
    const double undulation_m = hills().place(80, 118, 0).height.m;
    const auto above_m = [&](double distance_m) {  // empty outside the raster
        const earth::Geodetic at = earth::from_ecef(view.eye + ray * distance_m);
        std::optional<double> ground = surface_msl_m(at);
        if (ground) *ground = at.height.m - undulation_m - (view.is_flat() ? kFlat_m : *ground);
        return ground;
    };
    double before_m = 0, at_m = 0;
    for (; at_m < 25'000; before_m = at_m) {
        const double height_m = earth::from_ecef(view.eye + ray * at_m).height.m - undulation_m;
        at_m += std::fmax(12, height_m - kHighest_m);
        const std::optional<double> above = above_m(at_m);
        if (!above) return {};
        if (*above <= 0) break;
    }
    for (int n = 0; n < 40; ++n) {
        const double middle_m = 0.5 * (before_m + at_m);
        (above_m(middle_m).value_or(1) > 0 ? before_m : at_m) = middle_m;
    }
    const glm::dvec3 place = view.eye + ray * at_m, from = earth::to_ecef(own_ship());
    const std::optional<double> height_m = surface_msl_m(earth::from_ecef(place));
    if (!height_m || at_m >= 25'000) return {};
    const glm::dmat3 axes = earth::north_east_down(own_ship().latitude_rad, own_ship().longitude_rad);
    return {true, glm::dot(place - from, axes[0]), glm::dot(place - from, axes[1]), *height_m};
}

/// Of all pixels of a view, rows from the top.
std::vector<GroundPlace> places_of_pixels(bool is_flat) {
    std::vector<GroundPlace> places;
    const terrain::View view = hills_input(is_flat).view;
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column) places.push_back(place_of_pixel(view, column, row));
    return places;
}

const std::vector<GroundPlace>& places(bool is_flat = false) {
    static const std::vector<GroundPlace> of_hills = places_of_pixels(false);
    if (!is_flat) return of_hills;
    static const std::vector<GroundPlace> of_plane = places_of_pixels(true);
    return of_plane;
}

TerrainAhead violation(const TerrainAlertZone& zone, const GroundPlace& at) {
    return policy::violation_at(zone, at.north_m, at.east_m, at.height_m);
}

/// Whether another color lies within a pixel, 5 m or 1 m of height, or what lies there is not known.
bool is_at_border(const TerrainAlertZone& zone, const std::vector<GroundPlace>& all, int column, int row) {
    const auto at = [&](int x, int y) { return all[place_of(x, y)]; };
    const GroundPlace middle = at(column, row);
    const TerrainAhead here = violation(zone, middle);
    for (int y = row - 1; y <= row + 1; ++y)
        for (int x = column - 1; x <= column + 1; ++x)
            if (!at(x, y).is_hit || violation(zone, at(x, y)) != here) return true;
    for (const double away : {-1.0, 1.0}) {
        GroundPlace north = middle, east = middle, up = middle;
        north.north_m += 5 * away;
        east.east_m += 5 * away;
        up.height_m += away;
        for (const GroundPlace& other : {north, east, up})
            if (violation(zone, other) != here) return true;
    }
    return false;
}

struct Agreement {
    int compared = 0, wrong = 0;
    int colored[3] = {};  ///< by TerrainAhead
};

/// `shown`: what a pixel shows; empty where it is none of the three.
template <class Shown>
Agreement compare(const TerrainAlertZone& zone, const Shown& shown, bool is_flat = false, double shifted_m = 0) {
    std::vector<GroundPlace> all = places(is_flat);
    for (GroundPlace& place : all) place.north_m += shifted_m;
    Agreement agreement;
    for (int row = 1; row + 1 < kHeight; ++row)
        for (int column = 1; column + 1 < kWidth; ++column) {
            const GroundPlace& place = all[place_of(column, row)];
            if (!place.is_hit || is_at_border(zone, all, column, row)) continue;
            const TerrainAhead expected = violation(zone, place);
            const std::optional<TerrainAhead> seen = shown(column, row);
            ++agreement.compared;
            ++agreement.colored[static_cast<std::size_t>(expected)];
            agreement.wrong += seen != expected ? 1 : 0;
        }
    return agreement;
}

TerrainAlertZone straight() {
    TerrainAlertZone zone;
    zone.alert = TerrainAhead::warning;
    zone.from = own_ship();
    zone.north_mps = 69;
    zone.east_mps = 12;
    zone.radius_m = 300;
    zone.radius_mps = 6;
    zone.radius_mps2 = 0.02;
    zone.floor_msl_m = 560;
    zone.floor_mps = -1.5;
    zone.until_s = 60;
    return zone;
}
TerrainAlertZone turning(double radps) {
    TerrainAlertZone zone = straight();
    zone.turn_radps = radps;
    return zone;
}
TerrainAlertZone to_runway() {
    TerrainAlertZone zone = straight();
    zone.runway = {2600, 500, 700, 760};
    return zone;
}

struct NamedZone {
    const char* name;
    TerrainAlertZone zone;
};
std::vector<NamedZone> zones() {
    return {{"straight", straight()},
            {"right", turning(0.02)},
            {"left", turning(-0.03)},
            {"hardly turning", turning(2.1e-5)},
            {"runway", to_runway()}};
}

constexpr design::Color kBare{255, 255, 255};

design::DesignSettings bare_design() {
    design::DesignSettings design = test_support::clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = kBare;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    return design;
}

/// By the colors of a picture without any other ones than the ground's.
auto shown_in(const ChunkPicture& picture) {
    return [&picture](int column, int row) -> std::optional<TerrainAhead> {
        const AlertColors colors;
        const design::Color seen = picture.at(column, row);
        const auto is = [&](design::Color color) {
            return test_support::color_difference(seen, test_support::color_blend(kBare, color, colors.strength)) <= 1;
        };
        if (seen == kBare) return TerrainAhead::none;
        if (is(colors.caution)) return TerrainAhead::caution;
        if (is(colors.warning)) return TerrainAhead::warning;
        return std::nullopt;
    };
}

void expect_agreement(const Agreement& agreement, const std::string& what) {
    EXPECT_EQ(agreement.wrong, 0) << what;
    EXPECT_GT(agreement.compared, 40'000) << what;
    for (const int colored : agreement.colored) EXPECT_GT(colored, 300) << what;
}

class AlertZonePictures : public testing::TestWithParam<const char*> {};

TEST_P(AlertZonePictures, TheGroundThatViolatesIsColoredAndNoOther) {
    ChunkDrawing drawing(hills(), bare_design(), "egl", GetParam());
    TerrainDrawInput input = hills_input(false);
    for (const NamedZone& of : zones()) {
        input.alert = alert_zone_look(of.zone);
        const ChunkPicture picture = drawing.draw(input, 0.02);
        expect_agreement(compare(of.zone, shown_in(picture)), of.name);
        EXPECT_GT(compare(of.zone, shown_in(picture), false, 300).wrong, 1000) << "control: elsewhere, " << of.name;
    }
}

TEST_P(AlertZonePictures, CodesSayWhichGroundViolates) {
    ChunkDrawing drawing(hills(), bare_design(), "egl", GetParam(), true, TerrainOutput::code);
    TerrainDrawInput input = hills_input(false);
    input.heights = {300, 900};
    for (const NamedZone& of : zones()) {
        input.alert = alert_zone_look(of.zone);
        const ChunkPicture picture = drawing.draw(input, 0.02);
        int other_heights = 0;
        const auto shown = [&](int column, int row) -> std::optional<TerrainAhead> {
            const design::Color code = picture.at(column, row);
            const int step = code.green / 3;
            const double height_m = 300 + 600 * (code.red + (step + 0.5) / 85) / 254;
            other_heights += std::fabs(height_m - places()[place_of(column, row)].height_m) > 4 ? 1 : 0;
            return static_cast<TerrainAhead>(code.green % 3);
        };
        expect_agreement(compare(of.zone, shown), of.name);
        EXPECT_LT(other_heights, kWidth * kHeight / 50) << "heights are coded as ever, but at silhouettes";
        EXPECT_GT(compare(of.zone, shown, false, 300).wrong, 1000) << "control: elsewhere, " << of.name;
    }
}

TEST_P(AlertZonePictures, OnAPlaneTheTrueHeightDecides) {
    design::DesignSettings design = bare_design();
    design.view.reference = design::Reference::flat;
    ChunkDrawing drawing(hills(), design, "egl", GetParam());
    TerrainDrawInput input = hills_input(true);
    for (const NamedZone& of : zones()) {
        input.alert = alert_zone_look(of.zone);
        expect_agreement(compare(of.zone, shown_in(drawing.draw(input, 0.02)), true), of.name);
    }
}

TEST_P(AlertZonePictures, TheZoneWinsOverBands) {
    ChunkDrawing drawing(hills(), bare_design(), "egl", GetParam());
    TerrainDrawInput input = hills_input(false);
    input.alert = alert_zone_look(straight());
    const ChunkPicture without = drawing.draw(input, 0.02);
    input.warning_colors = true;
    input.aircraft_msl_m = 800;
    const ChunkPicture banded = drawing.draw(input, 0.02);
    int inside = 0, outside = 0;
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column) {
            const std::optional<TerrainAhead> seen = shown_in(without)(column, row);
            if (seen.value_or(TerrainAhead::none) != TerrainAhead::none) {
                EXPECT_EQ(banded.at(column, row), without.at(column, row));
                ++inside;
            } else if (seen && !(banded.at(column, row) == without.at(column, row))) {
                ++outside;
            }
        }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000) << "control: there are bands";
}

TEST_P(AlertZonePictures, WithoutAnAlertThePictureIsThatWithoutAZone) {
    for (const TerrainOutput output : {TerrainOutput::color, TerrainOutput::code}) {
        ChunkDrawing drawing(hills(), bare_design(), "egl", GetParam(), true, output);
        TerrainDrawInput input = hills_input(false);
        input.heights = {300, 900};
        for (const bool has_bands : {false, true}) {
            input.warning_colors = has_bands;
            input.aircraft_msl_m = 800;
            input.alert = {};
            const ChunkPicture without = drawing.draw(input, 1);
            TerrainAlertZone zone = straight();
            input.alert = alert_zone_look(zone);
            EXPECT_NE(drawing.draw(input, 1).rgba, without.rgba) << "control";
            zone.alert = TerrainAhead::none;
            input.alert = alert_zone_look(zone);
            EXPECT_EQ(drawing.draw(input, 1).rgba, without.rgba);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, AlertZonePictures, testing::Values("es2-small", "es3-mid", "sc2"),
                         [](const auto& test) { return std::string(test.param).substr(0, 3); });

TEST(AlertZoneUniforms, StandAsTheShaderReadsThem) {
    TerrainAlertZone zone = turning(-0.035);
    zone.runway = {100, 200, 300, 400};
    const AlertZoneRows rows = alert_zone_rows(alert_zone_look(zone));
    EXPECT_NEAR(rows.of[0][0], zone.speed_mps(), 1e-4);
    EXPECT_NEAR(rows.of[0][1], zone.speed_mps() / 0.035, 1e-3);
    EXPECT_EQ(rows.of[0][2], -1) << "to the left";
    EXPECT_EQ(rows.of[1][3], 60);
    EXPECT_EQ(rows.of[2][2], 30);
    EXPECT_NEAR(std::hypot(rows.of[3][0], rows.of[3][1]), std::hypot(100.0, 200.0), 1e-3);
    EXPECT_NEAR(rows.of[4][3], 0.65, 1e-6);
    EXPECT_EQ(alert_zone_rows(alert_zone_look(straight())).of[0][3], 0) << "straight";
    EXPECT_LT(alert_zone_rows({}).of[1][3], 0) << "no time at all without an alert";
}

}  // namespace
}  // namespace tedavis::draw::test_alert_zone_uniforms
