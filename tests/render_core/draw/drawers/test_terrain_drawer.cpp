#include "render_core/draw/drawers/terrain_drawer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/programs/headless_backends.hpp"
#include "tests/support/terrain/chunk_drawing.hpp"
#include "tests/support/terrain/raster_ray_caster.hpp"

namespace tedavis::draw::test_terrain_drawer {
namespace {

using base::radians;
using design::Color;
using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::clear_design;
using test_support::eastward_ramp;
using test_support::holes_below_skyline;
using test_support::kDrawingBackground;
using test_support::lit_from_above;
using test_support::pixel_of;
using test_support::RasterScene;

TEST(TerrainDrawer, NoBackgroundIsSeenBetweenChunksOfDifferentLevels) {
    RasterScene scene(test_support::make_rough_raster(257, 257));
    for (const bool lifted : {false, true}) {
        design::DesignSettings design = clear_design();
        design.terrain.conservative_up = lifted;
        ChunkDrawing drawing(scene, design);
        int mixed = 0, holed = 0, beside_coarser = 0;
        for (const double heading : {0.0, 77.0, 200.0, 305.0})
            for (const double pitch : {-45.0, -12.0})
                for (const double tau_px : {1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 32.0}) {
                    const TerrainDrawInput input = lit_from_above(scene.view(128, 128, 3000, heading, pitch));
                    EXPECT_EQ(holes_below_skyline(drawing.draw(input, tau_px)), 0u)
                        << heading << ", " << pitch << " at tau " << tau_px << (lifted ? " lifted" : "");
                    beside_coarser += drawing.beside_coarser();
                    if (pitch != -45) continue;
                    EXPECT_EQ(drawing.draw(input, tau_px).count(kDrawingBackground), 0u) << heading << " at tau " << tau_px;
                    if (drawing.levels().size() < 2) continue;
                    ++mixed;
                    holed += drawing.draw(input, tau_px, 1).count(kDrawingBackground) > 0 ? 1 : 0;
                }
        EXPECT_GT(mixed, 4);
        EXPECT_GT(2 * holed, mixed) << "control: a chunk left out leaves a hole, unless it is hidden or out of the picture";
        EXPECT_GT(beside_coarser, 20) << "chunks beside a coarser one";
    }
}

TEST(TerrainDrawer, NothingIsDrawnBeyondTheRaster) {
    RasterScene scene(test_support::make_raster(70, 45, [](std::uint32_t, std::uint32_t) { return 500.0f; }));
    ChunkDrawing drawing(scene, clear_design());
    const TerrainDrawInput input = lit_from_above(scene.view(62, 40, 4000, 0, -90));
    const ChunkPicture picture = drawing.draw(input, 1);
    const glm::dvec2 corner = *pixel_of(input.view, scene.post(69, 44));
    ASSERT_LT(corner.x, RasterScene::kWidth - 20);
    ASSERT_LT(corner.y, RasterScene::kHeight - 20);
    for (double y = 2; y < RasterScene::kHeight - 2; y += 3)
        for (double x = 2; x < RasterScene::kWidth - 2; x += 3) {
            if (std::abs(x - corner.x) < 2 || std::abs(y - corner.y) < 2) continue;
            const bool inside = x < corner.x && y < corner.y;
            EXPECT_EQ(picture.at(x, y) == kDrawingBackground, !inside) << x << ", " << y;
        }
}

/// The same ground at the same latitude elsewhere: a world turned about its axis.
TEST(TerrainDrawer, TheSamePictureAfterTurningTheWorld) {
    const host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();
    design::DesignSettings design = clear_design();
    for (design::ColorStop& stop : design.terrain.palette.stops) stop.color = {120, 160, 90};  // the geoid differs between places
    const auto picture_at = [&](double west_deg) {
        host_sim::Raster raster = test_support::make_rough_raster(129, 129);
        raster.west_deg = west_deg;
        for (std::uint32_t j = 0; j < raster.rows; ++j)
            for (std::uint32_t i = 0; i < raster.columns; ++i) {
                const double latitude = radians(raster.north_deg - j * raster.step_lat_deg),
                             longitude = radians(raster.west_deg + i * raster.step_lon_deg);
                raster.height_m[raster.at(i, j)] -= static_cast<float>(geoid.undulation(latitude, longitude).m);
            }
        RasterScene scene(raster);
        ChunkDrawing drawing(scene, design);
        // The eye at the same height above the ellipsoid.
        const double undulation = geoid.undulation(scene.place(64, 64, 0).latitude_rad, scene.place(64, 64, 0).longitude_rad).m;
        return drawing.draw(lit_from_above(scene.view(64, 64, 3500 - undulation, 40, -25)), 1);
    };
    const ChunkPicture here = picture_at(9.6), there = picture_at(-120.4), other = picture_at(9.6);
    std::size_t different = 0;
    for (std::size_t n = 0; n < here.rgba.size(); ++n) different += std::abs(here.rgba[n] - there.rgba[n]) > 6 ? 1 : 0;
    // Silhouettes may fall on the other side of a pixel's centre.
    EXPECT_LT(static_cast<double>(different), 0.01 * static_cast<double>(here.rgba.size()));
    EXPECT_EQ(here.rgba, other.rgba) << "the same place gives the same bits";
}

TEST(TerrainDrawer, UploadsOnlyWhatIsNew) {
    RasterScene scene(test_support::make_rough_raster(129, 129));
    ChunkDrawing drawing(scene, clear_design());
    const TerrainDrawInput input = lit_from_above(scene.view(64, 64, 4000, 0, -40));
    const ChunkPicture first = drawing.draw(input, 1);
    EXPECT_GT(drawing.uploaded(), 100000u);
    const ChunkPicture second = drawing.draw(input, 1);
    EXPECT_EQ(drawing.uploaded(), 0u);
    EXPECT_EQ(first.rgba, second.rgba);
}

TEST(TerrainDrawer, ANewDesignColorsTheNextFrame) {
    RasterScene scene(eastward_ramp());
    ChunkDrawing drawing(scene, clear_design());
    const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
    const ChunkPicture before = drawing.draw(input, 1);
    design::DesignSettings blue = clear_design();
    for (design::ColorStop& stop : blue.terrain.palette.stops) stop.color = {0, 0, 200};
    EXPECT_TRUE(drawing.set_design(blue));
    const Color after = drawing.draw(input, 1).at(160, 120);
    EXPECT_EQ(after.red, 0);
    EXPECT_EQ(after.green, 0);
    EXPECT_GT(after.blue, 150);
    EXPECT_GT(before.at(160, 120).green, 0);
}

TEST(TerrainDrawer, AStyleThatNeedsOtherProgramsIsRefused) {
    RasterScene scene(eastward_ramp());
    ChunkDrawing drawing(scene, clear_design());
    const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
    const ChunkPicture before = drawing.draw(input, 1);
    design::DesignSettings other = clear_design();
    for (design::ColorStop& stop : other.terrain.palette.stops) stop.color = {0, 0, 200};
    other.terrain.style.sketch.contours = 1;
    EXPECT_FALSE(drawing.set_design(other));
    other.terrain.style.sketch.contours = 0;
    other.terrain.conservative_up = true;
    EXPECT_FALSE(drawing.set_design(other));
    EXPECT_EQ(drawing.draw(input, 1).rgba, before.rgba) << "nothing of it was taken";
}

struct SkylineCount {
    int columns = 0, too_low = 0, other = 0;
};

/// Through a long lens, against the skyline of a ray cast.
SkylineCount compare_skylines(const RasterScene& scene, bool lifted) {
    constexpr double kFieldOfView_deg = 12, kEye_m = 1900, kPitch_deg = -2, kTau_px = 60;
    design::DesignSettings design = clear_design();
    design.terrain.conservative_up = lifted;
    ChunkDrawing drawing(scene, design);
    const test_support::RasterRayCaster caster(scene.raster);
    const earth::Geodetic eye = scene.place(96, 96, kEye_m);
    SkylineCount count;
    for (const double heading : {20.0, 80.0, 140.0, 200.0, 260.0, 320.0}) {
        terrain::View view = scene.view(96, 96, kEye_m, heading, kPitch_deg);
        view.focal_px = RasterScene::kWidth / 2.0 / std::tan(radians(kFieldOfView_deg / 2));
        const ChunkPicture picture = drawing.draw(lit_from_above(view), kTau_px);
        const test_support::OracleCamera camera(base::degrees(eye.latitude_rad), base::degrees(eye.longitude_rad), eye.height.m,
                                                heading, kPitch_deg, 0, kFieldOfView_deg, RasterScene::kWidth,
                                                RasterScene::kHeight);
        for (std::uint32_t x = 4; x < RasterScene::kWidth; x += 20) {
            const auto cast = caster.skyline_px(camera, static_cast<int>(x));
            if (!cast) continue;
            std::uint32_t row = 0;
            while (row < RasterScene::kHeight && picture.at(x, row) == kDrawingBackground) ++row;
            ++count.columns;
            count.too_low += static_cast<int>(row) > *cast ? 1 : 0;
            count.other += static_cast<int>(row) != *cast ? 1 : 0;
        }
    }
    return count;
}

TEST(TerrainDrawer, ALiftedSkylineIsNeverBelowTheTrueOne) {
    const RasterScene scene(test_support::make_rough_raster(193, 193));
    const SkylineCount lifted = compare_skylines(scene, true), plain = compare_skylines(scene, false);
    EXPECT_GT(lifted.columns, 60);
    EXPECT_EQ(lifted.too_low, 0) << "of " << lifted.columns;
    EXPECT_GT(lifted.other, 0) << "it is a coarse surface";
    EXPECT_GT(plain.too_low, 5) << "control: without lift it often is";
}

TEST(TerrainDrawer, TwoRangesOfDepthGiveThePictureOfOne) {
    const RasterScene scene(test_support::make_rough_raster(193, 193));
    ChunkDrawing drawing(scene, clear_design());
    terrain::View view = scene.view(96, 96, 2300, 30, -10);
    view.near_m = 20;
    view.far_m = 20000;
    const DepthPlan one = plan_depth(view.near_m, view.far_m);
    ASSERT_EQ(one.count, 1u);
    DepthPlan two;
    two.count = 2;
    two.ranges[0] = {3960, view.far_m};
    two.ranges[1] = {view.near_m, 4000};
    const TerrainDrawInput input = lit_from_above(view);
    const ChunkPicture whole = drawing.draw(input, 1, 0, one), parted = drawing.draw(input, 1, 0, two);
    EXPECT_EQ(holes_below_skyline(parted), 0u);
    std::size_t different = 0;
    for (std::size_t n = 0; n < whole.rgba.size(); ++n) different += std::abs(whole.rgba[n] - parted.rgba[n]) > 2 ? 1 : 0;
    // Where a range ends, triangles are cut and their edges are rounded anew.
    EXPECT_LT(different, whole.rgba.size() / 1000);
    two.ranges[1].far_m = 3500;
    EXPECT_GT(holes_below_skyline(drawing.draw(input, 1, 0, two)), 50u) << "control: a gap between the ranges is seen";
}

TEST(TerrainDrawer, CodesTakeNoPalette) {
    const RasterScene scene(eastward_ramp());
    const auto bytes_with = [&scene](TerrainOutput output) {
        test_support::GlSession session("egl", "es3-mid", RasterScene::kWidth, RasterScene::kHeight);
        test_support::MemoryBytes bytes(scene.built.image);
        const test_support::DrawnTerrain terrain(bytes, session.device.max_chunk_slots);
        std::vector<std::uint8_t> memory(8 << 20);
        base::Arena staging(memory.data(), memory.size());
        terrain::ChunkIndices indices;
        EXPECT_TRUE(indices.start(terrain.store(), staging));
        TerrainDrawer drawer;
        const design::DesignSettings design = clear_design();
        const DrawnDesign only{&design, output};
        EXPECT_EQ(drawer.start(session.gl, terrain.store(), indices, {&only, 1}, session.device, staging).message.view(), "");
        EXPECT_TRUE(drawer.shows(only));
        drawer.set_design(session.gl, only);
        const std::uint64_t taken = session.device.budget.find(effects::kRenderTargets)->use.in_use;
        drawer.destroy(session.gl);
        return taken;
    };
    EXPECT_EQ(bytes_with(TerrainOutput::code), 0u);
    EXPECT_EQ(bytes_with(TerrainOutput::color), 1024u * 4);
}

TEST(TerrainDrawer, TheLanesAndTheBackendsAgree) {
    RasterScene scene(test_support::make_rough_raster(129, 129));
    const TerrainDrawInput input = lit_from_above(scene.view(64, 64, 3000, 120, -20));
    const auto picture = [&](const std::string& backend, const std::string& device) {
        ChunkDrawing drawing(scene, clear_design(), backend, device);
        return drawing.draw(input, 2);
    };
    const ChunkPicture egl = picture("egl", "es3-mid");
    for (const std::string& backend : test_support::headless_backends())
        EXPECT_EQ(picture(backend, "es3-mid").rgba, egl.rgba) << backend;
    const ChunkPicture es2 = picture("egl", "es2-small");
    std::size_t different = 0;
    for (std::size_t n = 0; n < egl.rgba.size(); ++n) different += std::abs(egl.rgba[n] - es2.rgba[n]) > 2 ? 1 : 0;
    EXPECT_EQ(different, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_drawer
