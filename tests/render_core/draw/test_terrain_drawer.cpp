#include "render_core/draw/terrain_drawer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/built_database.hpp"
#include "tests/support/drawn_terrain.hpp"
#include "tests/support/gl_session.hpp"
#include "tests/support/raster_ray_caster.hpp"
#include "tests/support/raster_scene.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using design::Color;
using test_support::pixel_of;
using test_support::RasterScene;

constexpr std::uint32_t kWidth = RasterScene::kWidth, kHeight = RasterScene::kHeight;
constexpr Color kBackground{255, 0, 255};

design::DesignSettings plain_design() {
    design::DesignSettings design = design::default_design_settings();
    design.sky.haze_distance_m = 0;
    return design;
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] Color at(double x, double y) const {
        const std::size_t column = static_cast<std::size_t>(x), row = kHeight - 1 - static_cast<std::size_t>(y);
        const std::uint8_t* p = rgba.data() + (row * kWidth + column) * 4;
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] std::size_t count(Color c) const {
        std::size_t n = 0;
        for (std::size_t p = 0; p < rgba.size(); p += 4)
            n += rgba[p] == c.red && rgba[p + 1] == c.green && rgba[p + 2] == c.blue ? 1 : 0;
        return n;
    }
};

class Drawing {
public:
    Drawing(const RasterScene& scene, const design::DesignSettings& design, const std::string& backend = "egl",
            const std::string& device = "es3-mid", bool pages = true)
        : session_(backend, device, kWidth, kHeight),
          bytes_(scene.built.image),
          terrain_(bytes_, session_.device.max_chunk_slots, pages ? session_.device.attribute_pages : 0),
          design_(design) {
        EXPECT_EQ(drawer_.start(session_.gl, terrain_.store(), design, session_.device, staging_).sentence.view(), "");
        session_.gl.seal();
    }
    ~Drawing() {
        session_.gl.retire();
        drawer_.destroy(session_.gl);
    }

    /// Selects, draws and reads; `leave_out` of the selected chunks are not drawn.
    Picture draw(const TerrainDrawInput& input, double tau_px, std::size_t leave_out = 0) {
        return draw(input, tau_px, leave_out, plan_depth(input.view.near_m, input.view.far_m));
    }
    Picture draw(const TerrainDrawInput& input, double tau_px, std::size_t leave_out, const DepthPlan& depth) {
        terrain::LodSettings settings;
        settings.tau_px = tau_px;
        settings.max_chunks = session_.device.max_chunk_slots * 2 / 3;
        settings.conservative_up = design_.terrain.conservative_up;
        lod_ = terrain_.select(input.view, settings);
        EXPECT_TRUE(lod_.within_budget);
        const base::Span<const terrain::SelectedChunk> all = terrain_.selected();
        const base::Span<const terrain::SelectedChunk> drawn = all.subspan(leave_out, all.size() - leave_out);
        levels_.clear();
        beside_coarser_ = 0;
        for (const terrain::SelectedChunk& chunk : drawn) {
            levels_.insert(chunk.key.level);
            beside_coarser_ += chunk.coarser_edges != 0 ? 1 : 0;
        }
        return draw_chunks(drawn, input, depth);
    }
    [[nodiscard]] bool set_design(const design::DesignSettings& design) { return drawer_.set_design(session_.gl, design); }
    [[nodiscard]] const std::set<std::uint32_t>& levels() const { return levels_; }
    [[nodiscard]] int beside_coarser() const { return beside_coarser_; }
    [[nodiscard]] std::uint64_t uploaded() const { return session_.gl.frame().uploaded_bytes; }
    [[nodiscard]] const TerrainDrawResult& result() const { return result_; }
    [[nodiscard]] const terrain::LodResult& lod() const { return lod_; }

private:
    Picture draw_chunks(base::Span<const terrain::SelectedChunk> drawn, const TerrainDrawInput& input, const DepthPlan& depth) {
        session_.gl.begin_frame();
        EXPECT_TRUE(drawer_.prepare(session_.gl, drawn, input));
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(1, 0, 1, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT);
        session_.gl->Enable(GL_DEPTH_TEST);
        session_.gl->Enable(GL_CULL_FACE);
        result_ = {};
        for (std::size_t n = 0; n < depth.count; ++n) {
            session_.gl->Clear(GL_DEPTH_BUFFER_BIT);
            drawer_.draw(session_.gl, drawn, input, depth.ranges[n], result_);
        }
        EXPECT_EQ(session_.gl.denied().total, 0u);
        EXPECT_EQ(session_.gl.take_error(), GLenum{GL_NO_ERROR});
        return {session_.pixels()};
    }

    test_support::GlSession session_;
    test_support::MemoryBytes bytes_;
    test_support::DrawnTerrain terrain_;
    design::DesignSettings design_;
    std::vector<std::uint8_t> staging_memory_ = std::vector<std::uint8_t>(8 << 20);
    base::Arena staging_{staging_memory_.data(), staging_memory_.size()};
    TerrainDrawer drawer_;
    TerrainDrawResult result_;
    terrain::LodResult lod_;
    std::set<std::uint32_t> levels_;
    int beside_coarser_ = 0;
};

TerrainDrawInput lit_from_above(const terrain::View& view) {
    TerrainDrawInput input;
    input.view = view;
    input.light_direction[0] = glm::normalize(view.eye);
    return input;
}

int difference(Color a, Color b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

/// Rises by 4 m a post to the east.
host_sim::Raster ramp() {
    return test_support::make_raster(161, 161, [](std::uint32_t i, std::uint32_t) { return 4.0f * static_cast<float>(i); });
}

Color blend(Color a, Color b, double share) {
    const auto mix = [share](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround(x + (y - x) * share));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

TEST(TerrainDrawer, ColoursFollowHeightAndWarningBandsInEveryPixel) {
    RasterScene scene(ramp());
    const design::DesignSettings design = plain_design();
    Drawing drawing(scene, design);
    for (const bool warning : {false, true})
        for (const double aircraft_m : {150.0, 700.0, 1100.0}) {
            TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
            input.warning_colors = warning;
            input.aircraft_msl_m = aircraft_m;
            const Picture picture = drawing.draw(input, 1);
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
                        expected = blend(expected, design.warning_bands[band].color, design.warning_bands[band].strength);
                    expected = blend({0, 0, 0}, expected, light);
                    EXPECT_LE(difference(picture.at(at->x, at->y), expected), 4)
                        << "post " << i << ", " << j << " aircraft " << aircraft_m;
                    ++compared;
                }
            EXPECT_GT(compared, 200);
        }
}

/// A hill whose top lies 20 m below the lowest limit is coloured when the limits go down by more than that.
TEST(TerrainDrawer, LoweredBandsColourMoreTerrainAndNeverLess) {
    RasterScene scene(ramp());
    const design::DesignSettings design = plain_design();
    Drawing drawing(scene, design);
    TerrainDrawInput input = lit_from_above(scene.view(80, 80, 11000, 0, -90));
    const Picture plain = drawing.draw(input, 1);
    input.warning_colors = true;
    const double top_m = 4.0 * 160, lowest_m = design.warning_bands.back().lower_m;
    input.aircraft_msl_m = top_m + 20 - lowest_m;
    std::vector<bool> coloured_before(plain.rgba.size() / 4, false);
    std::size_t before = 0;
    for (const double lowered_m : {0.0, 15.0, 25.0, 60.0, 200.0}) {
        input.bands_lowered_m = lowered_m;
        const Picture picture = drawing.draw(input, 1);
        std::size_t coloured = 0;
        for (std::size_t p = 0; p < coloured_before.size(); ++p) {
            const bool is_coloured =
                !std::equal(picture.rgba.begin() + 4 * p, picture.rgba.begin() + 4 * p + 4, &plain.rgba[4 * p]);
            EXPECT_TRUE(is_coloured || !coloured_before[p]) << "pixel " << p << " lost its colour";
            coloured_before[p] = is_coloured;
            coloured += is_coloured ? 1 : 0;
        }
        EXPECT_EQ(coloured > 0, lowered_m > 20) << lowered_m;
        EXPECT_GE(coloured, before);
        before = coloured;
    }
}

/// Pixels of the background below the uppermost pixel of terrain of their column.
std::size_t holes(const Picture& picture) {
    std::size_t found = 0;
    for (std::uint32_t x = 0; x < kWidth; ++x) {
        bool below_skyline = false;
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            const bool background = picture.at(x, y) == kBackground;
            below_skyline = below_skyline || !background;
            found += below_skyline && background ? 1 : 0;
        }
    }
    return found;
}

TEST(TerrainDrawer, NoBackgroundIsSeenBetweenChunksOfDifferentLevels) {
    RasterScene scene(test_support::make_rough_raster(257, 257));
    for (const bool lifted : {false, true}) {
        design::DesignSettings design = plain_design();
        design.terrain.conservative_up = lifted;
        Drawing drawing(scene, design);
        int mixed = 0, holed = 0, beside_coarser = 0;
        for (const double heading : {0.0, 77.0, 200.0, 305.0})
            for (const double pitch : {-45.0, -12.0})
                for (const double tau_px : {1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 32.0}) {
                    const TerrainDrawInput input = lit_from_above(scene.view(128, 128, 3000, heading, pitch));
                    EXPECT_EQ(holes(drawing.draw(input, tau_px)), 0u)
                        << heading << ", " << pitch << " at tau " << tau_px << (lifted ? " lifted" : "");
                    beside_coarser += drawing.beside_coarser();
                    if (pitch != -45) continue;
                    EXPECT_EQ(drawing.draw(input, tau_px).count(kBackground), 0u) << heading << " at tau " << tau_px;
                    if (drawing.levels().size() < 2) continue;
                    ++mixed;
                    holed += drawing.draw(input, tau_px, 1).count(kBackground) > 0 ? 1 : 0;
                }
        EXPECT_GT(mixed, 4);
        EXPECT_GT(2 * holed, mixed) << "control: a chunk left out leaves a hole, unless it is hidden or out of the picture";
        EXPECT_GT(beside_coarser, 20) << "chunks beside a coarser one";
    }
}

TEST(TerrainDrawer, NothingIsDrawnBeyondTheRaster) {
    RasterScene scene(test_support::make_raster(70, 45, [](std::uint32_t, std::uint32_t) { return 500.0f; }));
    Drawing drawing(scene, plain_design());
    const TerrainDrawInput input = lit_from_above(scene.view(62, 40, 4000, 0, -90));
    const Picture picture = drawing.draw(input, 1);
    const glm::dvec2 corner = *pixel_of(input.view, scene.post(69, 44));
    ASSERT_LT(corner.x, kWidth - 20);
    ASSERT_LT(corner.y, kHeight - 20);
    for (double y = 2; y < kHeight - 2; y += 3)
        for (double x = 2; x < kWidth - 2; x += 3) {
            if (std::abs(x - corner.x) < 2 || std::abs(y - corner.y) < 2) continue;
            const bool inside = x < corner.x && y < corner.y;
            EXPECT_EQ(picture.at(x, y) == kBackground, !inside) << x << ", " << y;
        }
}

/// The same ground at the same latitude elsewhere: a world turned about its axis.
TEST(TerrainDrawer, TheSamePictureAfterTurningTheWorld) {
    const host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();
    design::DesignSettings design = plain_design();
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
        Drawing drawing(scene, design);
        // The eye at the same height above the ellipsoid.
        const double undulation = geoid.undulation(scene.place(64, 64, 0).latitude_rad, scene.place(64, 64, 0).longitude_rad).m;
        return drawing.draw(lit_from_above(scene.view(64, 64, 3500 - undulation, 40, -25)), 1);
    };
    const Picture here = picture_at(9.6), there = picture_at(-120.4), other = picture_at(9.6);
    std::size_t different = 0;
    for (std::size_t n = 0; n < here.rgba.size(); ++n) different += std::abs(here.rgba[n] - there.rgba[n]) > 6 ? 1 : 0;
    // Silhouettes may fall on the other side of a pixel's centre.
    EXPECT_LT(static_cast<double>(different), 0.01 * static_cast<double>(here.rgba.size()));
    EXPECT_EQ(here.rgba, other.rgba) << "the same place gives the same bits";
}

TEST(TerrainDrawer, UploadsOnlyWhatIsNew) {
    RasterScene scene(test_support::make_rough_raster(129, 129));
    Drawing drawing(scene, plain_design());
    const TerrainDrawInput input = lit_from_above(scene.view(64, 64, 4000, 0, -40));
    const Picture first = drawing.draw(input, 1);
    EXPECT_GT(drawing.uploaded(), 100000u);
    const Picture second = drawing.draw(input, 1);
    EXPECT_EQ(drawing.uploaded(), 0u);
    EXPECT_EQ(first.rgba, second.rgba);
}

TEST(TerrainDrawer, ANewDesignColoursTheNextFrame) {
    RasterScene scene(ramp());
    Drawing drawing(scene, plain_design());
    const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
    const Picture before = drawing.draw(input, 1);
    design::DesignSettings blue = plain_design();
    for (design::ColorStop& stop : blue.terrain.palette.stops) stop.color = {0, 0, 200};
    EXPECT_TRUE(drawing.set_design(blue));
    const Color after = drawing.draw(input, 1).at(160, 120);
    EXPECT_EQ(after.red, 0);
    EXPECT_EQ(after.green, 0);
    EXPECT_GT(after.blue, 150);
    EXPECT_GT(before.at(160, 120).green, 0);
}

TEST(TerrainDrawer, AStyleThatNeedsOtherProgramsIsRefused) {
    RasterScene scene(ramp());
    Drawing drawing(scene, plain_design());
    const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
    const Picture before = drawing.draw(input, 1);
    design::DesignSettings other = plain_design();
    for (design::ColorStop& stop : other.terrain.palette.stops) stop.color = {0, 0, 200};
    other.terrain.style.sketch.contours = 1;
    EXPECT_FALSE(drawing.set_design(other));
    other.terrain.style.sketch.contours = 0;
    other.terrain.conservative_up = true;
    EXPECT_FALSE(drawing.set_design(other));
    EXPECT_EQ(drawing.draw(input, 1).rgba, before.rgba) << "nothing of it was taken";
}

/// How far the shading of the posts in view is from Lambert's of the full-resolution surface, on average, in steps of 255.
double shading_error(const RasterScene& scene, const Picture& picture, const TerrainDrawInput& input) {
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
    design::DesignSettings design = plain_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.ambient = 0.2;
    design.terrain.style.shade.baked_normals = true;
    TerrainDrawInput input = lit_from_above(scene.view(64, 64, 3500, 0, -90));
    input.light_direction[0] = glm::normalize(input.light_direction[0] + 0.8 * input.view.right);
    const auto drawn = [&](bool pages, double tau_px) {
        Drawing drawing(scene, design, "egl", "es3-mid", pages);
        return drawing.draw(input, tau_px);
    };
    const Picture baked = drawn(true, 30), bare = drawn(false, 30);
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
int wrong_posts(const RasterScene& scene, const Picture& picture, const terrain::View& view, Color sea, double tolerance_px) {
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
            if (!at || at->y < 2 || picture.at(at->x, at->y - 1) == kBackground) continue;  // at the skyline
            if ((difference(picture.at(at->x, at->y), sea) < 3) == sea_at(i, j)) continue;
            wrong += is_near_coast(i, j, *at) ? 0 : 1;
        }
    return wrong;
}

TEST(TerrainDrawer, TheCoastIsWhereItIsAndNotWhereTrianglesAre) {
    RasterScene scene(shallow_coast());
    design::DesignSettings design = plain_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.technique = design::TerrainShade::none;
    for (const bool from_above : {true, false}) {
        const TerrainDrawInput input =
            lit_from_above(from_above ? scene.view(256, 256, 20000, 0, -90) : scene.view(256, 420, 2500, 0, -15));
        int wrong[2] = {};
        for (const bool pages : {false, true}) {
            Drawing drawing(scene, design, "egl", "es3-mid", pages);
            const Picture picture = drawing.draw(input, 1);
            wrong[pages ? 1 : 0] = wrong_posts(scene, picture, input.view, design.terrain.sea, 1.5);
            EXPECT_LE(drawing.lod().worst_error_px, 1);
        }
        EXPECT_EQ(wrong[1], 0) << from_above;
        EXPECT_GT(wrong[0], 100) << "control: by the triangles alone";
    }
}

TEST(TerrainDrawer, VoidsAreHatchedInTheirColourInEveryStyleAndNeverLookLikeSea) {
    RasterScene scene(with_gaps());
    for (std::size_t texture = 0; texture < design::kTerrainTextures; ++texture) {
        design::DesignSettings design = plain_design();
        design.terrain.style.texture = static_cast<design::TerrainTexture>(texture);
        design.terrain.style.shade.technique = static_cast<design::TerrainShade>(texture % design::kTerrainShades);
        design.terrain.style.sketch.hatching = texture % 2 == 0 ? 1 : 0;
        design.terrain.style.sketch.contours = texture % 3 == 0 ? 1 : 0;
        Drawing drawing(scene, design);
        TerrainDrawInput input = lit_from_above(scene.view(70, 64, 9000, 0, -90));
        for (std::size_t n = 1; n < design::kMaxLights; ++n) input.light_direction[n] = input.light_direction[0];
        input.warning_colors = true;
        input.aircraft_msl_m = 300;
        const Picture picture = drawing.draw(input, 2);
        const Color unknown = design.terrain.unknown;
        int strong = 0, weak = 0;
        const auto north_west = pixel_of(input.view, earth::to_ecef(scene.place(71, 51, 400))),
                   south_east = pixel_of(input.view, earth::to_ecef(scene.place(89, 79, 400)));
        ASSERT_TRUE(north_west && south_east);
        for (double y = north_west->y; y < south_east->y; ++y)
            for (double x = north_west->x; x < south_east->x; ++x) {
                const Color seen = picture.at(x, y);
                const double share = 1.0 * seen.red / unknown.red;
                EXPECT_LE(difference(seen, blend({0, 0, 0}, unknown, share)), 2) << texture << ": " << x << ", " << y;
                strong += share > 0.98 ? 1 : 0;
                weak += share < 0.45 ? 1 : 0;
            }
        EXPECT_GT(strong, 100) << "stripes, texture " << texture;
        EXPECT_GT(weak, 100) << "and what is between them";
        input.warning_colors = false;
        const auto at_sea = pixel_of(input.view, scene.post(15, 64));
        const Color sea = drawing.draw(input, 2).at(at_sea->x, at_sea->y);
        EXPECT_GT(sea.blue, sea.red + 25) << "control: the sea is a sea, texture " << texture;
    }
}

struct SkylineCount {
    int columns = 0, too_low = 0, other = 0;
};

/// Through a long lens, against the skyline of a ray cast.
SkylineCount compare_skylines(const RasterScene& scene, bool lifted) {
    constexpr double kFieldOfView_deg = 12, kEye_m = 1900, kPitch_deg = -2, kTau_px = 60;
    design::DesignSettings design = plain_design();
    design.terrain.conservative_up = lifted;
    Drawing drawing(scene, design);
    const test_support::RasterRayCaster caster(scene.raster);
    const earth::Geodetic eye = scene.place(96, 96, kEye_m);
    SkylineCount count;
    for (const double heading : {20.0, 80.0, 140.0, 200.0, 260.0, 320.0}) {
        terrain::View view = scene.view(96, 96, kEye_m, heading, kPitch_deg);
        view.focal_px = kWidth / 2 / std::tan(radians(kFieldOfView_deg / 2));
        const Picture picture = drawing.draw(lit_from_above(view), kTau_px);
        const test_support::OracleCamera camera(base::degrees(eye.latitude_rad), base::degrees(eye.longitude_rad), eye.height.m,
                                                heading, kPitch_deg, 0, kFieldOfView_deg, kWidth, kHeight);
        for (std::uint32_t x = 4; x < kWidth; x += 20) {
            const auto cast = caster.skyline_px(camera, static_cast<int>(x));
            if (!cast) continue;
            std::uint32_t row = 0;
            while (row < kHeight && picture.at(x, row) == kBackground) ++row;
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
    Drawing drawing(scene, plain_design());
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
    const Picture whole = drawing.draw(input, 1, 0, one), parted = drawing.draw(input, 1, 0, two);
    EXPECT_EQ(holes(parted), 0u);
    std::size_t different = 0;
    for (std::size_t n = 0; n < whole.rgba.size(); ++n) different += std::abs(whole.rgba[n] - parted.rgba[n]) > 2 ? 1 : 0;
    // Where a range ends, triangles are cut and their edges are rounded anew.
    EXPECT_LT(different, whole.rgba.size() / 1000);
    two.ranges[1].far_m = 3500;
    EXPECT_GT(holes(drawing.draw(input, 1, 0, two)), 50u) << "control: a gap between the ranges is seen";
}

TEST(TerrainDrawer, CodesTakeNoPalette) {
    const RasterScene scene(ramp());
    const auto bytes_with = [&scene](TerrainOutput output) {
        test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
        test_support::MemoryBytes bytes(scene.built.image);
        const test_support::DrawnTerrain terrain(bytes, session.device.max_chunk_slots);
        std::vector<std::uint8_t> memory(8 << 20);
        base::Arena staging(memory.data(), memory.size());
        TerrainDrawer drawer;
        EXPECT_EQ(drawer.start(session.gl, terrain.store(), plain_design(), session.device, staging, output).sentence.view(), "");
        EXPECT_TRUE(drawer.set_design(session.gl, plain_design()));
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
        Drawing drawing(scene, plain_design(), backend, device);
        return drawing.draw(input, 2);
    };
    const Picture egl = picture("egl", "es3-mid");
    for (const std::string& backend : test_support::headless_backends())
        EXPECT_EQ(picture(backend, "es3-mid").rgba, egl.rgba) << backend;
    const Picture es2 = picture("egl", "es2-small");
    std::size_t different = 0;
    for (std::size_t n = 0; n < egl.rgba.size(); ++n) different += std::abs(egl.rgba[n] - es2.rgba[n]) > 2 ? 1 : 0;
    EXPECT_EQ(different, 0u);
}

}  // namespace
}  // namespace tedavis::draw
