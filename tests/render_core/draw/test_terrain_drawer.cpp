#include "render_core/draw/terrain_drawer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "host_sim/geoid_egm96.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/built_database.hpp"
#include "tests/support/gl_session.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using design::Color;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr Color kBackground{255, 0, 255};

design::DesignSettings plain_design() {
    design::DesignSettings design = design::default_design_settings();
    design.sky.haze_distance_m = 0;
    return design;
}

/// A raster, its database and a view on it from a place given in posts.
struct Scene {
    host_sim::Raster raster;
    test_support::BuiltDatabase built;

    explicit Scene(const host_sim::Raster& r) : raster(r), built(r) {}

    [[nodiscard]] earth::Geodetic place(double i, double j, double msl_m) const {
        const double latitude = radians(raster.north_deg - j * raster.step_lat_deg),
                     longitude = radians(raster.west_deg + i * raster.step_lon_deg);
        return {latitude, longitude, {msl_m + built.database.undulation(latitude, longitude).m}};
    }
    [[nodiscard]] glm::dvec3 post(std::uint32_t i, std::uint32_t j) const {
        return earth::to_ecef(place(i, j, double{raster.height_m[raster.at(i, j)]}));
    }
    [[nodiscard]] terrain::View view(double i, double j, double msl_m, double heading_deg, double pitch_deg) const {
        const earth::Geodetic at = place(i, j, msl_m);
        const glm::dmat3 body = earth::body_axes(at.latitude_rad, at.longitude_rad, radians(heading_deg), radians(pitch_deg), 0);
        return {earth::to_ecef(at), body[0], body[1], body[2], kWidth / 2 / std::tan(radians(30)), kWidth, kHeight, 5, 300000};
    }
};

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
    Drawing(Scene& scene, const design::DesignSettings& design, const std::string& backend = "egl",
            const std::string& device = "es3-mid")
        : scene_(scene), session_(backend, device, kWidth, kHeight) {
        const std::uint32_t slots = session_.device.max_chunk_slots;
        EXPECT_TRUE(cache_.start(scene.built.database, slots, arena_, arena_));
        EXPECT_EQ(drawer_.start(session_.gl, scene.built.database, cache_, design, session_.device, staging_).sentence.view(),
                  "");
        session_.gl.seal();
    }
    ~Drawing() {
        session_.gl.retire();
        drawer_.destroy(session_.gl);
    }

    /// Selects, draws and reads; `leave_out` of the selected chunks are not drawn.
    Picture draw(TerrainDrawInput input, double tau_px, std::size_t leave_out = 0) {
        std::vector<std::uint8_t> states(scene_.built.database.chunk_count());
        std::vector<terrain::ChunkIndex> work(4096);
        std::vector<terrain::SelectedChunk> chosen(256);
        const terrain::LodResult lod =
            terrain::select_chunks(scene_.built.database, input.view, {tau_px, 250000, session_.device.max_chunk_slots},
                                   {states.data(), states.size()}, {work.data(), work.size()}, {chosen.data(), chosen.size()});
        EXPECT_TRUE(lod.within_budget);
        levels_.clear();
        for (std::uint32_t n = 0; n < lod.chunks; ++n) levels_.insert(scene_.built.database.entry(chosen[n].chunk).level);
        const base::Span<const terrain::SelectedChunk> drawn(chosen.data() + leave_out, lod.chunks - leave_out);
        EXPECT_TRUE(drawer_.prepare(session_.gl, drawn, ++frame_));
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(1, 0, 1, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        session_.gl->Enable(GL_DEPTH_TEST);
        session_.gl->Enable(GL_CULL_FACE);
        result_ = drawer_.draw(session_.gl, drawn, input);
        EXPECT_TRUE(result_.complete);
        return {session_.pixels()};
    }
    void set_design(const design::DesignSettings& design) { drawer_.set_design(session_.gl, design); }
    [[nodiscard]] const std::set<std::uint32_t>& levels() const { return levels_; }
    [[nodiscard]] std::uint64_t uploaded() const { return result_.uploaded_bytes; }

private:
    Scene& scene_;
    test_support::GlSession session_;
    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(128 << 20),
                              staging_memory_ = std::vector<std::uint8_t>(8 << 20);
    base::Arena arena_{memory_.data(), memory_.size()}, staging_{staging_memory_.data(), staging_memory_.size()};
    terrain::ChunkCache cache_;
    TerrainDrawer drawer_;
    TerrainDrawResult result_;
    std::set<std::uint32_t> levels_;
    std::uint64_t frame_ = 0;
};

TerrainDrawInput lit_from_above(const terrain::View& view) {
    TerrainDrawInput input;
    input.view = view;
    input.light_direction = glm::normalize(view.eye);
    return input;
}

/// Where a point is seen, if it is.
std::optional<glm::dvec2> pixel_of(const terrain::View& view, const glm::dvec3& point) {
    const glm::dvec3 d = point - view.eye;
    const double depth = glm::dot(d, view.forward);
    const glm::dvec2 at(kWidth / 2 + view.focal_px * glm::dot(d, view.right) / depth,
                        kHeight / 2 + view.focal_px * glm::dot(d, view.down) / depth);
    if (depth < view.near_m || at.x < 1 || at.y < 1 || at.x >= kWidth - 1 || at.y >= kHeight - 1) return std::nullopt;
    return at;
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
    Scene scene(ramp());
    const design::DesignSettings design = plain_design();
    Drawing drawing(scene, design);
    for (const bool warning : {false, true})
        for (const double aircraft_m : {150.0, 700.0, 1100.0}) {
            TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
            input.warning_colors = warning;
            input.aircraft_msl_m = aircraft_m;
            const Picture picture = drawing.draw(input, 1);
            const glm::dvec3 east = scene.post(81, 80) - scene.post(80, 80), north = scene.post(80, 79) - scene.post(80, 80);
            const double light =
                design.terrain.light.ambient +
                (1 - design.terrain.light.ambient) * glm::dot(glm::normalize(glm::cross(east, north)), input.light_direction);
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

TEST(TerrainDrawer, NoBackgroundIsSeenBetweenChunksOfDifferentLevels) {
    Scene scene(test_support::make_rough_raster(257, 257));
    Drawing drawing(scene, plain_design());
    int mixed = 0;
    for (const double heading : {0.0, 77.0, 200.0, 305.0})
        for (const double tau_px : {1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 32.0}) {
            const TerrainDrawInput input = lit_from_above(scene.view(128, 128, 3000, heading, -45));
            EXPECT_EQ(drawing.draw(input, tau_px).count(kBackground), 0u) << heading << " at tau " << tau_px;
            if (drawing.levels().size() < 2) continue;
            ++mixed;
            EXPECT_GT(drawing.draw(input, tau_px, 1).count(kBackground), 0u) << "control: a chunk left out leaves a hole";
        }
    EXPECT_GT(mixed, 4);
}

TEST(TerrainDrawer, NothingIsDrawnBeyondTheRaster) {
    Scene scene(test_support::make_raster(70, 45, [](std::uint32_t, std::uint32_t) { return 500.0f; }));
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
        Scene scene(raster);
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
    Scene scene(test_support::make_rough_raster(129, 129));
    Drawing drawing(scene, plain_design());
    const TerrainDrawInput input = lit_from_above(scene.view(64, 64, 4000, 0, -40));
    const Picture first = drawing.draw(input, 1);
    EXPECT_GT(drawing.uploaded(), 100000u);
    const Picture second = drawing.draw(input, 1);
    EXPECT_EQ(drawing.uploaded(), 0u);
    EXPECT_EQ(first.rgba, second.rgba);
}

TEST(TerrainDrawer, ANewDesignColoursTheNextFrame) {
    Scene scene(ramp());
    Drawing drawing(scene, plain_design());
    const TerrainDrawInput input = lit_from_above(scene.view(80, 80, 9000, 0, -90));
    const Picture before = drawing.draw(input, 1);
    design::DesignSettings blue = plain_design();
    for (design::ColorStop& stop : blue.terrain.palette.stops) stop.color = {0, 0, 200};
    drawing.set_design(blue);
    const Color after = drawing.draw(input, 1).at(160, 120);
    EXPECT_EQ(after.red, 0);
    EXPECT_EQ(after.green, 0);
    EXPECT_GT(after.blue, 150);
    EXPECT_GT(before.at(160, 120).green, 0);
}

TEST(TerrainDrawer, TheLanesAndTheBackendsAgree) {
    Scene scene(test_support::make_rough_raster(129, 129));
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
