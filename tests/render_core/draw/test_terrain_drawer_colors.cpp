// The colours of drawn terrain, pixel by pixel: heights, warning bands, coloured lights, baked normals, coasts and
// voids.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/terrain/chunk_drawing.hpp"

namespace tedavis::draw::test_terrain_drawer_colors {
namespace {

using design::Color;
using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::clear_design;
using test_support::color_blend;
using test_support::color_difference;
using test_support::eastward_ramp;
using test_support::kDrawingBackground;
using test_support::lit_from_above;
using test_support::pixel_of;
using test_support::RasterScene;

TEST(TerrainDrawer, ColorsFollowHeightAndWarningBandsInEveryPixel) {
    RasterScene scene(eastward_ramp());
    const design::DesignSettings design = clear_design();
    ChunkDrawing drawing(scene, design);
    for (const bool warning : {false, true})
        for (const double aircraft_m : {150.0, 700.0, 1100.0}) {
            TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
            input.warning_colors = warning;
            input.aircraft_msl_m = aircraft_m;
            const ChunkPicture picture = drawing.draw(input, 1);
            const glm::dvec3 east = scene.post(81, 80) - scene.post(80, 80), north = scene.post(80, 79) - scene.post(80, 80);
            const double light = design.terrain.style.shade.ambient +
                                 (1 - design.terrain.style.shade.ambient) *
                                     glm::dot(glm::normalize(glm::cross(east, north)), input.light_direction[0]);
            int compared = 0;
            for (std::uint32_t j = 10; j < 150; j += 7)
                for (std::uint32_t i = 10; i < 150; i += 3) {
                    const auto at = pixel_of(input.view, scene.post(i, j));
                    if (!at) continue;
                    const double height = 4.0 * i;
                    const std::size_t band = design::band_of(design.warning_bands, height - aircraft_m, false),
                                      below = design::band_of(design.warning_bands, height - 12 - aircraft_m, false),
                                      above = design::band_of(design.warning_bands, height + 12 - aircraft_m, false);
                    if (below != above) continue;  // a pixel at a limit holds both
                    Color expected = design::color_of_value(design.terrain.palette, height);
                    if (warning && band < design.warning_bands.size())
                        expected = color_blend(expected, design.warning_bands[band].color, design.warning_bands[band].strength);
                    expected = color_blend({0, 0, 0}, expected, light);
                    EXPECT_LE(color_difference(picture.at(at->x, at->y), expected), 4)
                        << "post " << i << ", " << j << " aircraft " << aircraft_m;
                    ++compared;
                }
            EXPECT_GT(compared, 200);
        }
}

/// A hill whose top lies 20 m below the lowest limit is coloured when the limits go down by more than that.
TEST(TerrainDrawer, LoweredBandsColorMoreTerrainAndNeverLess) {
    RasterScene scene(eastward_ramp());
    const design::DesignSettings design = clear_design();
    ChunkDrawing drawing(scene, design);
    TerrainDrawInput input = lit_from_above(scene.view(80, 80, 11000, 0, -90));
    const ChunkPicture plain = drawing.draw(input, 1);
    input.warning_colors = true;
    const double top_m = 4.0 * 160, lowest_m = design.warning_bands.back().lower_m;
    input.aircraft_msl_m = top_m + 20 - lowest_m;
    std::vector<bool> colored_before(plain.rgba.size() / 4, false);
    std::size_t before = 0;
    for (const double lowered_m : {0.0, 15.0, 25.0, 60.0, 200.0}) {
        input.bands_lowered_m = lowered_m;
        const ChunkPicture picture = drawing.draw(input, 1);
        std::size_t colored = 0;
        for (std::size_t p = 0; p < colored_before.size(); ++p) {
            const bool is_colored =
                !std::equal(picture.rgba.begin() + 4 * p, picture.rgba.begin() + 4 * p + 4, &plain.rgba[4 * p]);
            EXPECT_TRUE(is_colored || !colored_before[p]) << "pixel " << p << " lost its colour";
            colored_before[p] = is_colored;
            colored += is_colored ? 1 : 0;
        }
        EXPECT_EQ(colored > 0, lowered_m > 20) << lowered_m;
        EXPECT_GE(colored, before);
        before = colored;
    }
}

/// A slope in three coloured lights and ambient light of a colour: every channel is its own sum of the shares.
TEST(TerrainDrawer, EveryLightAddsItsColor) {
    RasterScene scene(eastward_ramp());
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {240, 220, 200};
    design::ShadeSettings& shade = design.terrain.style.shade;
    shade.technique = design::TerrainShade::lights;
    shade.light_count = 3;
    shade.ambient = 0.3;
    shade.ambient_color = {128, 255, 64};
    const Color colors[3] = {{255, 0, 128}, {0, 255, 255}, {255, 255, 0}};
    const double weights[3] = {0.5, 0.3, 0.2};
    TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
    const glm::dvec3 east = scene.post(81, 80) - scene.post(80, 80), north = scene.post(80, 79) - scene.post(80, 80);
    const glm::dvec3 up = glm::normalize(glm::cross(east, north)), sideways = glm::normalize(east);
    input.light_direction[0] = glm::normalize(up + sideways);
    input.light_direction[1] = glm::normalize(up - 0.5 * sideways);
    input.light_direction[2] = -up;  // from below: adds nothing
    glm::dvec3 light = 0.3 * glm::dvec3(128, 255, 64);
    for (int n = 0; n < 3; ++n) {
        shade.lights[n].weight = weights[n];
        shade.lights[n].color = colors[n];
        const double share = 0.7 * weights[n] * std::max(glm::dot(up, input.light_direction[n]), 0.0);
        light += share * glm::dvec3(colors[n].red, colors[n].green, colors[n].blue);
    }
    ChunkDrawing drawing(scene, design);
    const Color expected{static_cast<std::uint8_t>(std::lround(240 * light.x / 255)),
                         static_cast<std::uint8_t>(std::lround(220 * light.y / 255)),
                         static_cast<std::uint8_t>(std::lround(200 * light.z / 255))};
    const ChunkPicture picture = drawing.draw(input, 1);
    for (std::uint32_t n = 60; n < 100; n += 8) {
        const auto at = pixel_of(input.view, scene.post(n, n));
        ASSERT_TRUE(at);
        EXPECT_LE(color_difference(picture.at(at->x, at->y), expected), 2) << n;
    }
    shade.lights[0].color = {255, 255, 255};
    ASSERT_TRUE(drawing.set_design(design));
    EXPECT_GT(drawing.draw(input, 1).at(50, 50).green, picture.at(50, 50).green + 20) << "control: the colour counts";
}

/// How far the shading of the posts in view is from Lambert's of the full-resolution surface, on average, in steps of 255.
double shading_error(const RasterScene& scene, const ChunkPicture& picture, const TerrainDrawInput& input) {
    constexpr double kAmbient = 0.2;
    double sum = 0;
    int posts = 0;
    for (std::uint32_t j = 8; j < 120; ++j)
        for (std::uint32_t i = 8; i < 120; ++i) {
            const auto at = pixel_of(input.view, scene.post(i, j));
            if (!at) continue;
            const glm::dvec3 east = scene.post(i + 1, j) - scene.post(i - 1, j),
                             north = scene.post(i, j - 1) - scene.post(i, j + 1);
            const double cosine = glm::dot(glm::normalize(glm::cross(east, north)), input.light_direction[0]);
            sum += std::abs(picture.at(at->x, at->y).red - 255 * (kAmbient + (1 - kAmbient) * std::max(cosine, 0.0)));
            ++posts;
        }
    EXPECT_GT(posts, 200);
    return sum / posts;
}

/// The mesh is so coarse that its vertices know little of the slopes between them; the baked normals do.
TEST(TerrainDrawer, AttributePagesShadeWhereTheyAreAndVertexNormalsWhereNot) {
    RasterScene scene(test_support::make_raster(129, 129, [](std::uint32_t i, std::uint32_t j) {
        return 1000.0f + 25.0f * std::sin(static_cast<float>(i) / 2.2f) * std::sin(static_cast<float>(j) / 3.0f);
    }));
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.ambient = 0.2;
    design.terrain.style.shade.baked_normals = true;
    TerrainDrawInput input = lit_from_above(scene.view(64, 64, 3500, 0, -90));
    input.light_direction[0] = glm::normalize(input.light_direction[0] + 0.8 * input.view.right);
    const auto drawn = [&](bool pages, double tau_px) {
        ChunkDrawing drawing(scene, design, "egl", "es3-mid", pages);
        return drawing.draw(input, tau_px);
    };
    const ChunkPicture baked = drawn(true, 30), bare = drawn(false, 30);
    EXPECT_NE(baked.rgba, bare.rgba);
    const double with_pages = shading_error(scene, baked, input), without = shading_error(scene, bare, input),
                 fine = shading_error(scene, drawn(false, 0.02), input);
    RecordProperty("with_pages", std::to_string(with_pages));
    RecordProperty("without", std::to_string(without));
    EXPECT_LT(with_pages, 5);
    EXPECT_GT(without, 2 * with_pages) << "control: without pages the coarse mesh must do";
    EXPECT_LT(fine, 5) << "vertex normals of a fine mesh are as good";
}

/// Void posts in the middle, a sea in the west.
host_sim::Raster with_gaps() {
    host_sim::Raster raster = test_support::make_raster(
        129, 129, [](std::uint32_t i, std::uint32_t) { return i < 40 ? 0.0f : 30.0f + 10.0f * static_cast<float>(i - 40); });
    for (std::uint32_t j = 0; j < 129; ++j)
        for (std::uint32_t i = 0; i < 129; ++i) {
            if (i < 40) raster.post_class[raster.at(i, j)] = terrain::PostClass::sea;
            if (i < 70 || i > 90 || j < 50 || j > 80) continue;
            raster.height_m[raster.at(i, j)] = std::nanf("");
            raster.post_class[raster.at(i, j)] = terrain::PostClass::void_;
            ++raster.void_posts;
        }
    return raster;
}

/// A bay and a headland of a shallow coast: the land rises by a centimetre a post, so that no mesh needs a vertex there.
bool is_sea(double i, double j) { return i < 256 + 60 * std::sin(j / 25) + 12 * std::sin(j / 6); }
host_sim::Raster shallow_coast() {
    host_sim::Raster raster = test_support::make_raster(
        513, 513, [](std::uint32_t i, std::uint32_t j) { return is_sea(i, j) ? 0.0f : 0.5f + 0.01f * static_cast<float>(i); });
    for (std::uint32_t j = 0; j < 513; ++j)
        for (std::uint32_t i = 0; i < 513; ++i)
            if (is_sea(i, j)) raster.post_class[raster.at(i, j)] = terrain::PostClass::sea;
    return raster;
}

/// Posts that are drawn as the other of sea and land though the true coast is more than `tolerance_px` and a post away.
int wrong_posts(const RasterScene& scene, const ChunkPicture& picture, const terrain::View& view, Color sea,
                double tolerance_px) {
    const host_sim::Raster& raster = scene.raster;
    const auto sea_at = [&](std::uint32_t i, std::uint32_t j) {
        return raster.post_class[raster.at(i, j)] == terrain::PostClass::sea;
    };
    constexpr std::uint32_t kReach = 8;
    const auto is_near_coast = [&](std::uint32_t i, std::uint32_t j, const glm::dvec2& at) {
        for (std::uint32_t b = j - kReach; b <= j + kReach; ++b)
            for (std::uint32_t a = i - kReach; a <= i + kReach; ++a) {
                if (sea_at(a, b) == sea_at(i, j)) continue;
                if (a + 1 >= i && a <= i + 1 && b + 1 >= j && b <= j + 1) return true;
                const auto other = pixel_of(view, scene.post(a, b));
                if (other && glm::distance(at, *other) <= tolerance_px) return true;
            }
        return false;
    };
    int wrong = 0;
    for (std::uint32_t j = kReach; j + kReach < raster.rows; ++j)
        for (std::uint32_t i = kReach; i + kReach < raster.columns; ++i) {
            const auto at = pixel_of(view, scene.post(i, j));
            if (!at || at->y < 2 || picture.at(at->x, at->y - 1) == kDrawingBackground) continue;  // at the skyline
            if ((color_difference(picture.at(at->x, at->y), sea) < 60) == sea_at(i, j))
                continue;  // a shore is lighter, land is white
            wrong += is_near_coast(i, j, *at) ? 0 : 1;
        }
    return wrong;
}

TEST(TerrainDrawer, TheCoastIsWhereItIsAndNotWhereTrianglesAre) {
    RasterScene scene(shallow_coast());
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.technique = design::TerrainShade::none;
    for (const bool from_above : {true, false}) {
        const TerrainDrawInput input =
            lit_from_above(from_above ? scene.view(256, 256, 20000, 0, -90) : scene.view(256, 420, 2500, 0, -15));
        int wrong[2] = {};
        for (const bool pages : {false, true}) {
            ChunkDrawing drawing(scene, design, "egl", "es3-mid", pages);
            const ChunkPicture picture = drawing.draw(input, 1);
            wrong[pages ? 1 : 0] = wrong_posts(scene, picture, input.view, design.terrain.sea, 1.5);
            EXPECT_LE(drawing.lod().worst_error_px, 1);
        }
        EXPECT_EQ(wrong[1], 0) << from_above;
        EXPECT_GT(wrong[0], 100) << "control: by the triangles alone";
    }
}

TEST(TerrainDrawer, VoidsAreHatchedInTheirColorInEveryStyleAndNeverLookLikeSea) {
    RasterScene scene(with_gaps());
    for (std::size_t texture = 0; texture < design::kTerrainTextures; ++texture) {
        design::DesignSettings design = clear_design();
        design.terrain.style.texture = static_cast<design::TerrainTexture>(texture);
        design.terrain.style.shade.technique = static_cast<design::TerrainShade>(texture % design::kTerrainShades);
        design.terrain.style.sketch.hatching = texture % 2 == 0 ? 1 : 0;
        design.terrain.style.sketch.contours = texture % 3 == 0 ? 1 : 0;
        ChunkDrawing drawing(scene, design);
        TerrainDrawInput input = lit_from_above(scene.view(70, 64, 9000, 0, -90));
        for (std::size_t n = 1; n < design::kMaxLights; ++n) input.light_direction[n] = input.light_direction[0];
        input.warning_colors = true;
        input.aircraft_msl_m = 300;
        const ChunkPicture picture = drawing.draw(input, 2);
        const Color unknown = design.terrain.unknown;
        int strong = 0, weak = 0;
        const auto north_west = pixel_of(input.view, earth::to_ecef(scene.place(71, 51, 400))),
                   south_east = pixel_of(input.view, earth::to_ecef(scene.place(89, 79, 400)));
        ASSERT_TRUE(north_west && south_east);
        for (double y = north_west->y; y < south_east->y; ++y)
            for (double x = north_west->x; x < south_east->x; ++x) {
                const Color seen = picture.at(x, y);
                const double share = 1.0 * seen.red / unknown.red;
                EXPECT_LE(color_difference(seen, color_blend({0, 0, 0}, unknown, share)), 2) << texture << ": " << x << ", " << y;
                strong += share > 0.98 ? 1 : 0;
                weak += share < 0.55 ? 1 : 0;
            }
        EXPECT_GT(strong, 100) << "stripes, texture " << texture;
        EXPECT_GT(weak, 100) << "and what is between them";
        input.warning_colors = false;
        const auto at_sea = pixel_of(input.view, scene.post(15, 64));
        const Color sea = drawing.draw(input, 2).at(at_sea->x, at_sea->y);
        EXPECT_GT(sea.blue, sea.red + 25) << "control: the sea is a sea, texture " << texture;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_drawer_colors
