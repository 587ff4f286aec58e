// What the uniforms place on the ground, in pictures from straight above: parallel ridges whose places are known. Then their
// values, read back from the driver.
#include "render_core/draw/drawers/terrain_uniforms.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <random>
#include <string>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/drawn_surface.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::draw::test_terrain_uniforms {
namespace {

constexpr int kColumns = 257, kCellsAWave = 32;
constexpr double kStep_deg = 0.001, kWest_deg = 9.6, kNorth_deg = 47.1;
constexpr std::uint32_t kSide_px = 320, kFirstRow = kSide_px * 2 / 3, kEndRow = kSide_px * 5 / 6;  ///< rows that are looked at
constexpr double kRange_m = 4000;
constexpr double kMiddleColumn = 128;  ///< of kColumns
constexpr int kMiddleWave = 4;         ///< the ridge that the aircraft stands over

double ridge_longitude_deg(int wave) { return kWest_deg + (wave * kCellsAWave + 0.5) * kStep_deg; }
double latitude_deg() { return kNorth_deg - kMiddleColumn * kStep_deg; }

/// Ridges from north to south, 32 posts from one to the next, 500 m above the valleys between them.
class RidgedGround {
public:
    /// Ink of a column of the map, 0..1: the mean over its upper third, which the own ship does not reach. `style`: keys of
    /// [terrain.sketch].
    [[nodiscard]] std::vector<double> ink(const std::string& style) {
        test_support::HeadlessDisplay headless("egl", "es3-mid", kSide_px, kSide_px, &bytes_, map_with(style));
        const host_sim::AircraftPose above{latitude_deg(), ridge_longitude_deg(kMiddleWave), 3000, 0, 0, 0};
        const flight::AircraftState state = host_sim::posed_aircraft(above, headless.display());
        const std::vector<std::uint8_t> rgba = test_support::settled_pixels(headless, state, host_sim::kPosedTime);
        std::vector<double> columns(kSide_px);
        for (std::uint32_t x = 0; x < kSide_px; ++x)
            for (std::uint32_t y = kFirstRow; y < kEndRow; ++y)  // bottom row first
                columns[x] += (1 - rgba[(std::size_t{y} * kSide_px + x) * 4] / 255.0) / double{kEndRow - kFirstRow};
        return columns;
    }

private:
    static design::DesignSettings map_with(const std::string& style) {
        std::string text = "[symbology]\n";
        for (const char* shown : {"attitude", "map", "heading", "airspeed", "altitude", "vertical_speed", "flight_path",
                                  "baro_setting", "ground_height", "phase", "legend"})
            text += std::string(shown) + " = false\n";
        text +=
            "[view]\nmode = 'map'\nmap_range_m = 4000\n"
            "[sky]\nhaze_distance_m = 0\n[warning]\nenabled = false\n[terrain.texture]\ntechnique = 'plain'\n"
            "plain_color = '#ffffff'\n[terrain.shade]\ntechnique = 'none'\n[[terrain.shade.light]]\n"
            "azimuth_deg = 270\nelevation_deg = 30\n[terrain.sketch]\nline_color = '#000000'\n" +
            style;
        test_support::ShippedFiles files;
        return design::read_design_settings("name = 'map'\n" + text, "map.toml", files).value();
    }

    std::vector<std::uint8_t> image_ = test_support::build_image(test_support::make_raster(
        kColumns, kColumns,
        [](std::uint32_t i, std::uint32_t) { return static_cast<float>(500 + 250 * std::cos(2 * base::kPi * i / kCellsAWave)); },
        kWest_deg + 0.5 * kStep_deg, kNorth_deg - 0.5 * kStep_deg, kStep_deg));  // middles of cells
    test_support::MemoryBytes bytes_{image_};
};

RidgedGround& ground() {
    static RidgedGround ground;
    return ground;
}

/// Column of the picture at so many waves east of its middle.
double column_at(double waves) {
    const double latitude = base::radians(latitude_deg());
    const double wave_m = base::radians(kCellsAWave * kStep_deg) * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
    return kSide_px / 2.0 + waves * wave_m / kRange_m * (kSide_px / 2.0);
}

double ink_between(const std::vector<double>& ink, double from, double to) {
    double sum = 0;
    for (auto x = static_cast<std::size_t>(from); x < static_cast<std::size_t>(to); ++x) sum += ink[x];
    return sum;
}

/// The line's middle near a column, and its width in pixels of full ink.
void expect_line(const std::vector<double>& ink, double column) {
    double sum = 0, moment = 0;
    for (int x = static_cast<int>(column) - 8; x <= static_cast<int>(column) + 8; ++x) {
        sum += ink[static_cast<std::size_t>(x)];
        moment += ink[static_cast<std::size_t>(x)] * (x + 0.5);
    }
    ASSERT_GT(sum, 0.4) << "no line near column " << column;
    EXPECT_LT(sum, 3) << "a thick line";
    EXPECT_NEAR(moment / sum, column, 1.5);
}

TEST(TerrainUniforms, RidgesAndValleysAreDrawnWhereTheyLie) {
    const std::vector<double> ridges = ground().ink("ridges = 1.0\n"), valleys = ground().ink("valleys = 1.0\n");
    for (const double waves : {-1.0, 0.0, 1.0}) expect_line(ridges, column_at(waves));
    for (const double waves : {-0.5, 0.5}) expect_line(valleys, column_at(waves));
    for (const double waves : {-0.5, 0.5})
        EXPECT_LT(ink_between(ridges, column_at(waves) - 8, column_at(waves) + 8), 0.1) << "no ridge in a valley";
    for (const double waves : {-1.0, 0.0, 1.0})
        EXPECT_LT(ink_between(valleys, column_at(waves) - 8, column_at(waves) + 8), 0.1) << "no valley on a ridge";
}

TEST(TerrainUniforms, ContoursFollowHeights) {
    // 500 m is half way between ridge and valley, the only contour of this interval.
    const std::vector<double> ink = ground().ink("contours = 1.0\ncontour_interval_m = 500\n");
    for (const double waves : {-0.75, -0.25, 0.25, 0.75}) expect_line(ink, column_at(waves));
    for (const double waves : {-0.5, 0.0, 0.5}) EXPECT_LT(ink_between(ink, column_at(waves) - 8, column_at(waves) + 8), 0.1);
}

TEST(TerrainUniforms, HatchesAndDotsFillTheSlopesInTheShade) {
    for (const char* style : {"hatching = 1.0\n", "stippling = 1.0\n"}) {
        const std::vector<double> ink = ground().ink(style);
        const double shade = ink_between(ink, column_at(0.1), column_at(0.4));  // east of a ridge, the light comes from the west
        const double light = ink_between(ink, column_at(-0.4), column_at(-0.1));
        EXPECT_GT(shade, 2) << style;
        EXPECT_LT(light, 0.2 * shade) << style;
    }
}

TEST(TerrainUniforms, NothingIsInkedWhereNoLineIsAskedFor) {
    const std::vector<double> ink = ground().ink("");
    EXPECT_EQ(ink_between(ink, 0, kSide_px), 0);
}

// -- the values themselves, as the driver holds them

using test_support::GlSession;
using test_support::WrittenTdb;

/// Hills of 500 m at 47 N 9 E.
const WrittenTdb& hills() {
    static const WrittenTdb written([] {
        test_support::TdbSpec spec;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 500 + 300 * std::sin(i / 9.0) * std::cos(j / 7.0); };
        return spec;
    }());
    return written;
}

/// Every technique of the uniforms at once.
design::TerrainStyle rich_style() {
    design::TerrainStyle style;
    style.texture = design::TerrainTexture::material;
    style.shade.technique = design::TerrainShade::lights;
    style.shade.light_count = 3;
    style.shade.lights[0].weight = 0.5;
    style.shade.lights[1].weight = 0.25;
    style.shade.lights[2].weight = 0.5;
    style.shade.lights[1].color = {255, 51, 0};
    style.shade.ambient_color = {0, 102, 255};
    style.sketch.contours = 1;
    return style;
}

class TerrainUniformValues : public testing::Test {
protected:
    TerrainUniformValues() : at_("egl", "es3-mid") {
        TerrainVariant variant;
        variant.baked = variant.lifted = true;
        for (bool& map : variant.maps) map = true;
        program_ = build_terrain_program(at_.gl, style_, variant).value();
        location_ = reinterpret_cast<Location>(at_.surface->proc_address("glGetUniformLocation"));
        values_ = reinterpret_cast<Values>(at_.surface->proc_address("glGetUniformfv"));
        line_.bytes = 4'000'000;
        EXPECT_EQ(atlas_.start(at_.gl, line_, {}, false, 6, staging_).message.view(), "");
        at_.gl.seal();
        program_.use(at_.gl);
    }
    ~TerrainUniformValues() override {
        EXPECT_EQ(at_.gl.denied().total, 0u);
        at_.gl.retire();
        atlas_.destroy(at_.gl);
        program_.destroy(at_.gl);
    }
    /// What the driver holds under a name of the shader.
    template <std::size_t N>
    std::array<float, N> read(const std::string& name) const {
        std::array<float, N> out{};
        const GLint location = location_(program_.id(), name.c_str());
        EXPECT_GE(location, 0) << name;
        values_(program_.id(), location, out.data());
        return out;
    }
    static terrain::SelectedChunk chunk(const terrain::ChunkKey& key) {
        terrain::SelectedChunk selected;
        selected.key = key;
        selected.entry = &hills().entry(key);
        return selected;
    }

    using Location = GLint (*)(GLuint, const char*);
    using Values = void (*)(GLuint, GLint, float*);
    design::TerrainStyle style_ = rich_style();
    GlSession at_;
    gl::Program program_;
    base::BudgetLine line_;
    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 16);
    base::Arena staging_{memory_.data(), memory_.size()};
    PageAtlas atlas_;
    Location location_ = nullptr;
    Values values_ = nullptr;
};

TEST_F(TerrainUniformValues, TheMatrixProjectsAsAPinholeAndSpreadsTheRangeOfDepths) {
    std::mt19937 random(3);
    int seen = 0;
    for (const terrain::View& view : test_support::some_views(hills(), 12)) {
        const DepthRange range{30, 9000};
        set_view_uniforms(at_.gl, program_, view, range);
        const auto m = read<16>("view_projection");
        for (int n = 0; n < 40; ++n) {
            const glm::dvec3 point = hills().position(random() % 129, random() % 129);
            const test_support::Pixel expected = test_support::project(view, point);
            if (!expected.visible) continue;
            const glm::dvec3 p = point - glm::round(view.eye);
            double clip[4];
            for (int r = 0; r < 4; ++r) clip[r] = m[r] * p.x + m[4 + r] * p.y + m[8 + r] * p.z + double{m[12 + r]};
            const double depth = glm::dot(point - view.eye, view.forward);
            EXPECT_NEAR((clip[0] / clip[3] + 1) / 2 * view.width, expected.x, 0.02);
            EXPECT_NEAR((1 - clip[1] / clip[3]) / 2 * view.height, expected.y, 0.02);
            EXPECT_NEAR(clip[3], depth, 0.01 + 1e-5 * depth);
            EXPECT_EQ(clip[2] / clip[3] >= -1 && clip[2] / clip[3] <= 1, depth >= range.near_m && depth <= range.far_m);
            ++seen;
        }
    }
    EXPECT_GT(seen, 50);
}

TEST_F(TerrainUniformValues, OffsetsAreWholeMetresAndBringTheVerticesToTheEye) {
    const terrain::View view = test_support::view_from(hills(), 50, 60, 300, 20, -10);
    for (const terrain::ChunkKey& key : hills().keys()) {
        const terrain::SelectedChunk selected = chunk(key);
        const glm::dvec3 lights[design::kMaxLights] = {view.forward, view.right, view.down, view.down};
        set_chunk_uniforms(at_.gl, program_, {selected, hills().lattice(), view.eye, lights}, style_);
        const auto offset = read<3>("chunk_offset");
        for (std::size_t a = 0; a < 3; ++a) {
            EXPECT_EQ(offset[a], std::round(offset[a]));
            EXPECT_EQ(double{offset[a]}, selected.entry->centre_m[a] - std::round(view.eye[static_cast<int>(a)]));
        }
    }
}

TEST_F(TerrainUniformValues, LightsComeInLocalAxesWithSharesOfOne) {
    const terrain::SelectedChunk selected = chunk({0, 1, 2});
    const terrain::ChunkEntry& entry = *selected.entry;
    const glm::dvec3 north(entry.axes[0], entry.axes[1], entry.axes[2]), east(entry.axes[3], entry.axes[4], entry.axes[5]),
        down(entry.axes[6], entry.axes[7], entry.axes[8]);
    const glm::dvec3 lights[design::kMaxLights] = {east, -down, glm::normalize(north - east), {}};
    set_chunk_uniforms(at_.gl, program_, {selected, hills().lattice(), hills().position(0, 0), lights}, style_);
    const float expected[3][4] = {{1, 0, 0, 0.4f}, {0, 0, 1, 0.2f}, {-std::sqrt(0.5f), std::sqrt(0.5f), 0, 0.4f}};
    for (int n = 0; n < 3; ++n) {
        const auto light = read<4>("lights[" + std::to_string(n) + "]");
        for (std::size_t a = 0; a < 4; ++a) EXPECT_NEAR(light[a], expected[n][a], 1e-6) << n;
    }
    const auto to_local = read<9>("to_local");  // column by column
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(double{to_local[static_cast<std::size_t>(3 * c)]}, east[c], 1e-6);
}

TEST_F(TerrainUniformValues, ColorsOfLightsAreSharesOfFullLight) {
    set_style_uniforms(at_.gl, program_, style_, 500);
    EXPECT_EQ(read<3>("light_color[0]"), (std::array<float, 3>{1, 1, 1}));
    EXPECT_EQ(read<3>("light_color[1]"), (std::array<float, 3>{1, 0.2f, 0}));
    EXPECT_EQ(read<3>("ambient_color"), (std::array<float, 3>{0, 0.4f, 1}));
}

TEST_F(TerrainUniformValues, LiftsLieWhereTheVerticesAre) {
    terrain::SelectedChunk selected = chunk({0, 1, 1});
    selected.lift.own_m = 1;
    for (int n = 0; n < 4; ++n) {
        selected.lift.edge_m[n] = 10.0f + static_cast<float>(n);
        selected.lift.corner_m[n] = 20.0f + static_cast<float>(n);
    }
    const glm::dvec3 lights[design::kMaxLights]{};
    const glm::dvec3 eye = hills().position(60, 60) + glm::dvec3(0.3, 0.2, 0.4);
    set_chunk_uniforms(at_.gl, program_, {selected, hills().lattice(), eye, lights}, style_);
    const auto end = read<2>("place_end");
    const auto step = [](float edge, float x) { return x < edge ? 0 : 1; };
    const terrain::PostRange posts = hills().lattice().posts_of(selected.key);
    for (const terrain::ChunkVertex& v : hills().vertices(selected.key)) {
        const int x = step(0.5f, v.i) + step(end[0] - 0.5f, v.i), y = step(0.5f, v.j) + step(end[1] - 0.5f, v.j);
        EXPECT_EQ(read<1>("lift[" + std::to_string(3 * y + x) + "]")[0], terrain::vertex_lift_m(selected.lift, posts, v))
            << v.i << ", " << v.j;
    }
    // From the eye's whole metres to the middle of the Earth.
    const terrain::View view = test_support::free_view(eye, earth::body_axes(0.8, 0.2, 0, 0, 0), 64, 48, 1);
    set_view_uniforms(at_.gl, program_, view, {1, 1000});
    const auto centre = read<3>("earth_centre");
    for (int a = 0; a < 3; ++a) EXPECT_EQ(double{centre[static_cast<std::size_t>(a)]}, -std::round(eye[a]));
}

TEST_F(TerrainUniformValues, APostFindsItsTexelInThePageOfEveryAncestor) {
    for (const terrain::ChunkKey& key : hills().keys())
        for (terrain::ChunkKey owner = key.level == 0 ? key.parent() : key; owner.level < hills().lattice().levels();
             owner = owner.parent()) {
            set_page_uniforms(at_.gl, program_, hills().lattice(), key, owner, atlas_, 4);
            const auto window = read<4>("page_window");
            const terrain::PostRange posts = hills().lattice().posts_of(key), page = hills().lattice().posts_of(owner);
            const double posts_a_texel = std::exp2(owner.level - 1.0);
            const double texel_i = (posts.i1 - page.i0) / posts_a_texel, texel_j = (posts.j1 - page.j0) / posts_a_texel;
            EXPECT_EQ((posts.i1 - posts.i0) * double{window[0]} + double{window[2]}, texel_i);
            EXPECT_EQ((posts.j1 - posts.j0) * double{window[1]} + double{window[3]}, texel_j);
            EXPECT_LE(texel_i, terrain::kAttributePosts - 1.0);
        }
    const PageOrigin origin = atlas_.origin(4);
    EXPECT_EQ(read<4>("page_origin"), (std::array<float, 4>{origin.map_x, origin.map_y, origin.horizon_x, origin.horizon_y}));
    EXPECT_EQ(read<2>("page_scale"), (std::array<float, 2>{atlas_.map_scale(), atlas_.horizon_scale()}));
}

/// Strokes on the ground go on over every border: what both sides say differs by whole periods.
TEST_F(TerrainUniformValues, StrokesMeetAtTheBordersOfChunks) {
    const glm::dvec3 lights[design::kMaxLights]{};
    const auto window = [&](const terrain::ChunkKey& key, const design::TerrainStyle& style) {
        const terrain::SelectedChunk selected = chunk(key);
        set_chunk_uniforms(at_.gl, program_, {selected, hills().lattice(), hills().position(0, 0), lights}, style);
        return read<4>("stroke_window");
    };
    const auto west = window({0, 0, 1}, style_), east = window({0, 1, 1}, style_), coarse = window({1, 0, 0}, style_);
    EXPECT_NEAR(double{west[2] + 32 * west[0]}, double{east[2]}, 0.01);
    EXPECT_NEAR(double{west[3]}, double{coarse[3] + 32 * coarse[1]}, 0.01);
    EXPECT_NEAR(double{west[0]}, 1 / 1200.0 * 111320 * std::cos(base::radians(47 - 64 / 1200.0)), 0.3) << "metres a post";
}

/// Lines by angle are the Earth's, wherever a database begins; lines by length begin at its first post.
TEST(GridStep, LinesByAngleLieAtWholeMinutes) {
    const terrain::Lattice& lattice = hills().lattice();
    design::GridSettings grid;
    grid.spacing_rad = base::radians(1.0 / 60);
    const GridStep step = grid_step(lattice, grid);
    for (const std::uint32_t post : {0u, 7u, 33u}) {
        EXPECT_NEAR(step.first_east + post * step.lines_east, base::degrees(lattice.longitude_rad(post)) * 60, 1e-6);
        EXPECT_NEAR(step.first_south + post * step.lines_south, -base::degrees(lattice.latitude_rad(post)) * 60, 1e-6);
    }
    const double latitude_rad = lattice.latitude_rad(lattice.rows() / 2);
    EXPECT_NEAR(step.south_m, 1852, 10) << "a minute of latitude is a nautical mile";
    EXPECT_NEAR(step.east_m / step.south_m, std::cos(latitude_rad), 0.01);
    grid = {};
    grid.spacing_m = 500;
    EXPECT_EQ(grid_step(lattice, grid).first_east, 0);
    EXPECT_EQ(grid_step(lattice, grid).east_m, 500);
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_uniforms
