// The image over the terrain in the drawn picture: where it lies, what shows where it ends, and that it does not stretch.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "render_core/base/units.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/draped_database.hpp"
#include "tests/support/terrain/drawn_terrain.hpp"
#include "tests/support/terrain/raster_scene.hpp"

namespace tedavis::draw::test_terrain_drawer_pages {
namespace {

using base::radians;
using test_support::pixel_of;
using test_support::RasterScene;
using test_support::Rgba;

constexpr std::uint32_t kWidth = RasterScene::kWidth, kHeight = RasterScene::kHeight;
constexpr design::Color kPlain{0xD8, 0xD2, 0xC4};

/// The image as it is: no shade, no lines, no haze.
design::DesignSettings image_design() {
    design::DesignSettings design = design::default_design_settings();
    design.sky.haze_distance_m = 0;
    design.terrain.style = {};
    design.terrain.style.texture = design::TerrainTexture::image;
    design.terrain.style.plain = kPlain;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    return design;
}

RasterScene draped(const host_sim::Raster& raster, const test_support::ImageFile& image) {
    return RasterScene(raster, test_support::draped_image(raster, image));
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] const std::uint8_t* at(double x, double y) const {
        return rgba.data() + ((kHeight - 1 - static_cast<std::size_t>(y)) * kWidth + static_cast<std::size_t>(x)) * 4;
    }
    [[nodiscard]] bool is(double x, double y, const design::Color& c, int tolerance) const {
        const std::uint8_t* p = at(x, y);
        return std::abs(p[0] - c.red) <= tolerance && std::abs(p[1] - c.green) <= tolerance &&
               std::abs(p[2] - c.blue) <= tolerance;
    }
};

/// Draws the selected chunks after everything has arrived.
class Drawing {
public:
    Drawing(const RasterScene& scene, const char* device, std::uint32_t drape_slots = 25)
        : session_("egl", device, kWidth, kHeight),
          bytes_(scene.built.image),
          terrain_(bytes_, session_.device.max_chunk_slots, 0, drape_slots) {
        const terrain::FileHeader& h = scene.built.database.header();
        detail_ = {base::radians(std::ldexp(h.step_lat_deg / 4, h.drape_level)) * 6371000, h.drape_level};
        const design::DesignSettings design = image_design();
        const DrawnDesign only{&design};
        EXPECT_TRUE(indices_.start(terrain_.store(), staging_));
        EXPECT_EQ(drawer_.start(session_.gl, terrain_.store(), indices_, {&only, 1}, session_.device, staging_).message.view(),
                  "");
        session_.gl.seal();
    }
    ~Drawing() {
        session_.gl.retire();
        drawer_.destroy(session_.gl);
    }
    Picture draw(const terrain::View& view) {
        terrain::LodSettings settings;
        settings.max_chunks = session_.device.max_chunk_slots * 2 / 3;
        settings.drape = detail_;
        EXPECT_TRUE(terrain_.select(view, settings).within_budget);
        TerrainDrawInput input;
        input.view = view;
        input.light_direction[0] = glm::normalize(view.eye);
        session_.gl.begin_frame();
        EXPECT_TRUE(drawer_.prepare(session_.gl, terrain_.selected(), input));
        gl::bind_surface(session_.gl, *session_.surface);
        // Beyond the terrain the plain colour as well.
        session_.gl->ClearColor(kPlain.red / 255.0f, kPlain.green / 255.0f, kPlain.blue / 255.0f, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT);
        session_.gl->Enable(GL_DEPTH_TEST);
        session_.gl->Enable(GL_CULL_FACE);
        session_.gl->Clear(GL_DEPTH_BUFFER_BIT);
        TerrainDrawResult result;
        drawer_.draw(session_.gl, terrain_.selected(), input, {view.near_m, view.far_m}, result);
        EXPECT_EQ(session_.gl.denied().total, 0u);
        EXPECT_EQ(session_.gl.take_error(), GLenum{GL_NO_ERROR});
        return {session_.pixels()};
    }
    [[nodiscard]] std::uint64_t uploaded() const { return session_.gl.frame().uploaded_bytes; }

private:
    test_support::GlSession session_;
    test_support::MemoryBytes bytes_;
    test_support::DrawnTerrain terrain_;
    terrain::DrapeDetail detail_;
    std::vector<std::uint8_t> staging_memory_ = std::vector<std::uint8_t>(4 << 20);
    base::Arena staging_{staging_memory_.data(), staging_memory_.size()};
    terrain::ChunkIndices indices_;
    TerrainDrawer drawer_;
};

host_sim::Raster gentle_hills() {
    return test_support::make_raster(
        161, 161, [](std::uint32_t i, std::uint32_t j) { return 400 + 60 * std::sin(i * 0.05f) * std::cos(j * 0.06f); });
}

/// Squares of 8 posts with a colour of their own each, as far as 8 bits go.
Rgba square_color(int i, int j) {
    const int x = i / 8, y = j / 8;
    return {static_cast<std::uint8_t>((x + y) % 2 == 0 ? 230 : 20), static_cast<std::uint8_t>(30 + 9 * x),
            static_cast<std::uint8_t>(30 + 9 * y), 255};
}

class TerrainDrape : public testing::TestWithParam<const char*> {};

TEST_P(TerrainDrape, EverySquareOfAChequeredImageIsSeenWhereItLies) {
    const RasterScene scene = draped(
        gentle_hills(), test_support::image_over(gentle_hills(), 2, [](int i, int j) { return square_color(i / 2, j / 2); }));
    Drawing drawing(scene, GetParam());
    struct Case {
        double i, j, msl_m, heading_deg, pitch_deg;
    };
    for (const Case& c :
         {Case{80, 80, 9000, 0, -90}, Case{80, 80, 3000, 30, -90}, Case{60, 150, 4000, 10, -45}, Case{20, 30, 2500, 130, -40}}) {
        const terrain::View view = scene.view(c.i, c.j, c.msl_m, c.heading_deg, c.pitch_deg);
        const Picture picture = drawing.draw(view);
        int seen = 0, beside = 0;
        for (std::uint32_t j = 4; j < 160; j += 8)
            for (std::uint32_t i = 4; i < 160; i += 8) {
                const auto at = pixel_of(view, scene.post(i, j));
                if (!at || glm::length(scene.post(i, j) - view.eye) > 9500) continue;
                const Rgba here = square_color(static_cast<int>(i), static_cast<int>(j)),
                           next = square_color(static_cast<int>(i) + 8, static_cast<int>(j));
                EXPECT_TRUE(picture.is(at->x, at->y, {here[0], here[1], here[2]}, 3))
                    << "post " << i << ", " << j << " pitch " << c.pitch_deg;
                beside += picture.is(at->x, at->y, {next[0], next[1], next[2]}, 3) ? 1 : 0;
                ++seen;
            }
        EXPECT_GT(seen, 15);
        EXPECT_EQ(beside, 0) << "control: the square beside it has another colour";
    }
}

TEST_P(TerrainDrape, BeyondTheImageThePlainColorIsDrawn) {
    // The image covers posts 40 to 119 and has a hole in its middle.
    test_support::ImageFile image = test_support::image_over(gentle_hills(), 2, [](int i, int j) {
        const bool hole = i > 60 && i < 100 && j > 60 && j < 100;
        return Rgba{10, 120, 240, static_cast<std::uint8_t>(hole ? 0 : 255)};
    });
    image.transform[0] += 40 / 1200.0;
    image.transform[3] -= 40 / 1200.0;
    image.columns = image.rows = 160;
    const RasterScene scene = draped(gentle_hills(), image);
    Drawing drawing(scene, GetParam());
    const terrain::View view = scene.view(80, 80, 13000, 0, -90);
    const Picture picture = drawing.draw(view);
    const auto expect = [&](std::uint32_t i, std::uint32_t j, const design::Color& color) {
        const auto at = pixel_of(view, scene.post(i, j));
        ASSERT_TRUE(at.has_value()) << i << ", " << j;
        EXPECT_TRUE(picture.is(at->x, at->y, color, 2)) << "post " << i << ", " << j;
    };
    expect(50, 50, {10, 120, 240});
    expect(110, 60, {10, 120, 240});
    expect(80, 80, kPlain);
    expect(20, 80, kPlain);
    expect(140, 100, kPlain);
    // Where it ends, both mix and nothing else: no black, no fringe.
    for (std::size_t n = 0; n < picture.rgba.size(); n += 4) {
        const double share = (picture.rgba[n] - 10.0) / (kPlain.red - 10.0);
        EXPECT_NEAR(picture.rgba[n + 2], 240 + (kPlain.blue - 240) * share, 3);
    }
}

TEST_P(TerrainDrape, WithoutPagesThePlainColorIsDrawn) {
    const RasterScene scene = draped(gentle_hills(), test_support::image_over(gentle_hills(), 1, [](int, int) {
                                         return Rgba{10, 120, 240, 255};
                                     }));
    Drawing drawing(scene, GetParam(), 0);
    const Picture picture = drawing.draw(scene.view(80, 80, 5000, 0, -90));
    EXPECT_TRUE(picture.is(160, 120, kPlain, 1));
}

TEST_P(TerrainDrape, PagesAreUploadedOnce) {
    const RasterScene scene = draped(gentle_hills(), test_support::image_over(gentle_hills(), 2, square_color));
    Drawing drawing(scene, GetParam());
    const terrain::View view = scene.view(80, 80, 5000, 0, -60);
    const Picture first = drawing.draw(view);
    EXPECT_GT(drawing.uploaded(), sizeof(terrain::DrapePage));
    const Picture again = drawing.draw(view);
    EXPECT_EQ(drawing.uploaded(), 0u);
    EXPECT_EQ(first.rgba, again.rgba);
}

// -- slopes ------------------------------------------------------------------------------------------------------------

constexpr double kSlope_deg = 70, kStep_deg = 1.0 / 3600;

/// A slope that falls to the south, at the equator, where texels are square: 7.7 m.
host_sim::Raster slope(double slope_deg) {
    const double rise_m = std::tan(radians(slope_deg)) * radians(kStep_deg) * 6335439.33;
    return test_support::make_raster(
        100, 97, [rise_m](std::uint32_t, std::uint32_t j) { return static_cast<float>(10 + rise_m * (96 - j)); }, 9.6, 0.02,
        kStep_deg);
}

/// Grey chance in every pixel, as fine as texels.
std::vector<std::uint8_t> grey_noise(std::size_t pixels) {
    std::mt19937 random(11);
    std::vector<std::uint8_t> noise(pixels);
    for (std::uint8_t& n : noise) n = static_cast<std::uint8_t>(random());
    return noise;
}

/// A slope seen at right angles from its middle, and how the picture of it varies along the contour lines and down the slope.
struct SlopePicture {
    std::vector<double> grey;  // row by row, from the top
    [[nodiscard]] double at(std::uint32_t x, std::uint32_t y) const { return grey[std::size_t{y} * kWidth + x]; }
    /// Mean square of differences down the slope over that along the contour lines: how many times longer its grain is than
    /// wide, squared, below one.
    [[nodiscard]] double elongation() const {
        double across = 0, down = 0;
        for (std::uint32_t y = 20; y < kHeight - 20; ++y)
            for (std::uint32_t x = 20; x < kWidth - 20; ++x) {
                across += (at(x + 1, y) - at(x, y)) * (at(x + 1, y) - at(x, y));
                down += (at(x, y + 1) - at(x, y)) * (at(x, y + 1) - at(x, y));
            }
        return std::sqrt(across / down);
    }
    [[nodiscard]] double mean(std::uint32_t x0, std::uint32_t y0, std::uint32_t side) const {
        double sum = 0;
        for (std::uint32_t y = y0; y < y0 + side; ++y)
            for (std::uint32_t x = x0; x < x0 + side; ++x) sum += at(x, y);
        return sum / (side * side);
    }
};

struct SlopeScene {
    host_sim::Raster raster;
    std::vector<std::uint8_t> noise = grey_noise(400 * 388);
    RasterScene scene;
    terrain::View view;

    explicit SlopeScene(double slope_deg)
        : raster(slope(slope_deg)), scene(draped(raster, test_support::image_over(raster, 4, [this](int i, int j) {
                                                     const std::uint8_t n = noise[static_cast<std::size_t>(j * 400 + i)];
                                                     return Rgba{n, n, n, 255};
                                                 }))) {
        const double distance_m = 700, cell_m = radians(kStep_deg) * 6335439.33;
        const double back = distance_m * std::sin(radians(slope_deg)) / cell_m;
        const double middle_m = double{raster.height_m[raster.at(50, 48)]};
        view = scene.view(50, 48 + back, middle_m + distance_m * std::cos(radians(slope_deg)), 0, slope_deg - 90);
    }
    SlopePicture drawn(const char* device) {
        Drawing drawing(scene, device);
        const Picture picture = drawing.draw(view);
        SlopePicture grey;
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) grey.grey.push_back(picture.at(x, y)[0]);
        return grey;
    }
    /// The image read as it is, by rays against the slope's plane.
    SlopePicture read_as_it_is() {
        const glm::dvec3 origin = scene.post(50, 48), east = scene.post(51, 48) - origin, south = scene.post(50, 49) - origin;
        const glm::dvec3 normal = glm::normalize(glm::cross(east, south));
        SlopePicture grey;
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) {
                const glm::dvec3 ray =
                    view.forward * view.focal_px + view.right * (x + 0.5 - kWidth / 2.0) + view.down * (y + 0.5 - kHeight / 2.0);
                const glm::dvec3 hit = view.eye + ray * (glm::dot(origin - view.eye, normal) / glm::dot(ray, normal)) - origin;
                grey.grey.push_back(image_at(4 * (50 + glm::dot(hit, east) / glm::dot(east, east)),
                                             4 * (48 + glm::dot(hit, south) / glm::dot(south, south))));
            }
        return grey;
    }

private:
    [[nodiscard]] double image_at(double i, double j) const {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        const double u = i - static_cast<double>(a), v = j - static_cast<double>(b);
        const auto n = [&](std::size_t x, std::size_t y) { return static_cast<double>(noise[y * 400 + x]); };
        return (n(a, b) * (1 - u) + n(a + 1, b) * u) * (1 - v) + (n(a, b + 1) * (1 - u) + n(a + 1, b + 1) * u) * v;
    }
};

TEST_P(TerrainDrape, OnSteepSlopesItsGrainIsTheSameInEveryDirection) {
    SlopeScene steep(kSlope_deg);
    const SlopePicture drawn = steep.drawn(GetParam()), as_it_is = steep.read_as_it_is();
    EXPECT_GT(as_it_is.elongation(), 2.5) << "control: it would stretch to 1 / cos 70 degrees";
    EXPECT_NEAR(drawn.elongation(), 1, 0.25);
    // And it is the same image: whatever is larger than its grain.
    double difference = 0, spread = 0;
    int blocks = 0;
    for (std::uint32_t y = 20; y + 60 < kHeight; y += 60)
        for (std::uint32_t x = 20; x + 60 < kWidth; x += 60, ++blocks) {
            difference += std::abs(drawn.mean(x, y, 60) - as_it_is.mean(x, y, 60));
            spread += std::abs(as_it_is.mean(x, y, 60) - as_it_is.mean(20, 20, 60));
        }
    EXPECT_LT(difference / blocks, 0.5 * spread / blocks);
}

TEST_P(TerrainDrape, OnGentleGroundItIsReadAsItIs) {
    SlopeScene gentle(10);
    const SlopePicture drawn = gentle.drawn(GetParam()), as_it_is = gentle.read_as_it_is();
    double difference = 0;
    for (std::size_t n = 0; n < drawn.grey.size(); ++n) difference += std::abs(drawn.grey[n] - as_it_is.grey[n]);
    EXPECT_LT(difference / static_cast<double>(drawn.grey.size()), 4);
    EXPECT_NEAR(drawn.elongation(), 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Lanes, TerrainDrape, testing::Values("es2-small", "es3-mid"),
                         [](const auto& lane) { return std::string(lane.param).substr(0, 3); });

}  // namespace
}  // namespace tedavis::draw::test_terrain_drawer_pages
