// What magnifiers move, drawn, against the same places moved one by one: a chequered image on the ground, whose every square must
// lie where the map of its middle does, however large the triangles are, and data over it.
#include "render_core/draw/drawers/magnified_uniforms.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/draw/drawers/data/solid_drawer.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/draped_database.hpp"
#include "tests/support/terrain/drawn_terrain.hpp"
#include "tests/support/terrain/raster_scene.hpp"

namespace tedavis::draw::test_magnified_uniforms {
namespace {

using test_support::pixel_of;
using test_support::RasterScene;
using test_support::Rgba;

constexpr std::uint32_t kWidth = RasterScene::kWidth, kHeight = RasterScene::kHeight, kPosts = 161;

/// Squares of 4 posts.
Rgba square_color(int i, int j) {
    const int x = i / 4, y = j / 4;
    return {static_cast<std::uint8_t>((x + y) % 2 == 0 ? 230 : 20), static_cast<std::uint8_t>(30 + 5 * x),
            static_cast<std::uint8_t>(30 + 5 * y), 255};
}

/// The image as it is, on a map, with a focus that is magnified.
design::DesignSettings image_design() {
    design::DesignSettings design = design::default_design_settings();
    design.sky.haze_distance_m = 0;
    design.view.mode = design::ViewMode::map;
    design.terrain.style.texture = design::TerrainTexture::image;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.sketch = {};
    design::FocusSettings focus;
    focus.power = 1;
    EXPECT_TRUE(design.foci.try_push_back(focus));
    return design;
}

RasterScene chequered(double relief_m) {
    const host_sim::Raster raster = test_support::make_raster(kPosts, kPosts, [=](std::uint32_t i, std::uint32_t j) {
        return static_cast<float>(400 + relief_m * std::sin(i * 0.05f) * std::cos(j * 0.06f));
    });
    const test_support::ImageFile image =
        test_support::image_over(raster, 2, [](int i, int j) { return square_color(i / 2, j / 2); });
    return {raster, test_support::draped_image(raster, image)};
}

earth::Magnifiers magnifiers_at(const RasterScene& scene, bool is_square, std::uint32_t power, double radius_m = 700) {
    earth::MagnifierSettings settings;
    const earth::Geodetic middle = scene.place(84.5, 78.25, 0);
    settings.latitude_rad = middle.latitude_rad;
    settings.longitude_rad = middle.longitude_rad;
    settings.is_square = is_square;
    settings.radius_m = radius_m;
    settings.power = power;
    settings.context_m = earth::Magnifier::context_needed_m(settings, 1);
    earth::Magnifier magnifier;
    earth::Magnifiers all;
    EXPECT_TRUE(earth::Magnifier::make(settings, magnifier));
    EXPECT_TRUE(all.add(magnifier));
    return all;
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] const std::uint8_t* at(double x, double y) const {
        return rgba.data() + ((kHeight - 1 - static_cast<std::size_t>(y)) * kWidth + static_cast<std::size_t>(x)) * 4;
    }
    [[nodiscard]] bool is(double x, double y, const Rgba& c) const {
        const std::uint8_t* p = at(x, y);
        return std::abs(p[0] - c[0]) <= 3 && std::abs(p[1] - c[1]) <= 3 && std::abs(p[2] - c[2]) <= 3;
    }
};

class Drawing {
public:
    Drawing(const RasterScene& scene, const char* device)
        : session_("egl", device, kWidth, kHeight),
          bytes_(scene.built.image),
          terrain_(bytes_, session_.device.max_chunk_slots, 0, 25) {
        const terrain::FileHeader& h = scene.built.database.header();
        detail_ = {base::radians(std::ldexp(h.step_lat_deg / 4, h.drape_level)) * 6371000, h.drape_level};
        const DrawnDesign only{&design_, output_of(design_, true)};
        EXPECT_EQ(only.output, TerrainOutput::color) << "codes have no borders";
        EXPECT_TRUE(indices_.start(terrain_.store(), staging_));
        EXPECT_EQ(drawer_.start(session_.gl, terrain_.store(), indices_, {&only, 1}, session_.device, staging_).message.view(),
                  "");
        base::Arena arena(block_.data(), block_.size());
        base::BudgetLine& line = *session_.device.budget.find(effects::kSceneSolidVertices);
        EXPECT_TRUE(solids_.start(session_.gl, line, arena, {4096, 8192, 64}, gl::BufferUse::streamed).message.empty());
        DataVariant variant;
        variant.magnified = true;
        EXPECT_TRUE(solid_drawer_.start(session_.gl, arena, 64, variant).message.empty());
        EXPECT_TRUE(mesh_.start(arena));
        session_.gl.seal();
    }
    ~Drawing() {
        session_.gl.retire();
        solid_drawer_.destroy(session_.gl);
        solids_.destroy(session_.gl);
        drawer_.destroy(session_.gl);
    }
    SolidMesh& mesh() { return mesh_; }
    SolidBatch& batch() { return solids_.batch(); }

    Picture draw(const terrain::View& view) {
        begin(view);
        gl::Gl& gl = session_.gl;
        TerrainDrawInput input;
        input.view = view;
        input.light_direction[0] = glm::normalize(view.eye);
        EXPECT_TRUE(drawer_.prepare(gl, terrain_.selected(), input));
        drawn_ = {};
        drawer_.draw(gl, terrain_.selected(), input, {view.near_m, view.far_m}, drawn_);
        gl->Disable(GL_CULL_FACE);
        if (!solids_.batch().pieces().empty()) {
            EXPECT_TRUE(solids_.upload(gl));
            const SolidBuffers* const all[] = {&solids_};
            DataFrame frame;
            frame.view = view;
            solid_drawer_.draw(gl, all, {frame, ~0u, 0, false}, {view.near_m, view.far_m});
        }
        EXPECT_EQ(gl.denied().total, 0u);
        EXPECT_EQ(gl.take_error(), GLenum{GL_NO_ERROR});
        return {session_.pixels()};
    }
    /// As fine as the data are, everywhere.
    void show_all_detail() { tau_px_ = 0.001; }
    [[nodiscard]] const TerrainDrawResult& drawn() const { return drawn_; }
    [[nodiscard]] std::size_t chunks() const { return terrain_.selected().size(); }

private:
    void begin(const terrain::View& view) {
        terrain::LodSettings settings;
        settings.max_chunks = session_.device.max_chunk_slots * 2 / 3;
        settings.drape = detail_;
        settings.tau_px = tau_px_;
        EXPECT_TRUE(terrain_.select(view, settings).within_budget);
        session_.gl.begin_frame();
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(0, 0, 0, 1);
        session_.gl->Enable(GL_DEPTH_TEST);
        session_.gl->Enable(GL_CULL_FACE);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    design::DesignSettings design_ = image_design();
    test_support::GlSession session_;
    test_support::MemoryBytes bytes_;
    test_support::DrawnTerrain terrain_;
    terrain::DrapeDetail detail_;
    std::vector<std::uint8_t> staging_memory_ = std::vector<std::uint8_t>(4 << 20);
    base::Arena staging_{staging_memory_.data(), staging_memory_.size()};
    std::vector<unsigned char> block_ = std::vector<unsigned char>(1u << 22);
    terrain::ChunkIndices indices_;
    TerrainDrawer drawer_;
    TerrainDrawResult drawn_;
    double tau_px_ = 1;
    test_support::FilledSolids solids_;
    SolidDrawer solid_drawer_;
    SolidMesh mesh_;
};

constexpr double kClear_m = 200;

/// No border of the scale within a few pixels.
bool is_clear_of_borders(const terrain::View& view, const glm::dvec3& place, double clear_m) {
    for (const earth::Magnifier& magnifier : view.magnifiers) {
        const glm::dvec2 at = magnifier.in_plane(place);
        for (const std::size_t n : {std::size_t{0}, magnifier.cell_count() - 1})
            if (std::fabs(magnifier.cell(n).inside_m(at)) < clear_m) return false;
    }
    return true;
}

struct Seen {
    int right = 0, wrong = 0, unmoved_right = 0, moved = 0;
};
/// Of the squares' middles in the picture.
Seen look(const RasterScene& scene, const terrain::View& view, const Picture& picture) {
    Seen seen;
    for (std::uint32_t j = 2; j < kPosts; j += 4)
        for (std::uint32_t i = 2; i < kPosts; i += 4) {
            const glm::dvec3 post = scene.post(i, j), shown = view.magnifiers.moved(post);
            const auto at = pixel_of(view, shown), unmoved = pixel_of(view, post);
            if (!at || glm::distance(post, view.eye) > 12'000 || !is_clear_of_borders(view, post, kClear_m)) continue;
            const Rgba here = square_color(static_cast<int>(i), static_cast<int>(j));
            ++(picture.is(at->x, at->y, here) ? seen.right : seen.wrong);
            if (!unmoved || glm::distance(*at, *unmoved) < 4) continue;
            ++seen.moved;
            seen.unmoved_right += picture.is(unmoved->x, unmoved->y, here) ? 1 : 0;
        }
    return seen;
}

class Magnified : public testing::TestWithParam<const char*> {};

TEST_P(Magnified, EverySquareOfTheGroundLiesWhereTheMapOfItsMiddleDoes) {
    for (const double relief_m : {0.0, 60.0}) {
        const RasterScene scene = chequered(relief_m);
        Drawing drawing(scene, GetParam());
        for (const bool is_square : {false, true})
            for (const std::uint32_t power : {1u, 2u})
                for (const double pitch_deg : {-90.0, -50.0}) {
                    terrain::View view =
                        pitch_deg < -80 ? scene.view(80, 80, 7000, 20, -90) : scene.view(80, 125, 6000, 5, pitch_deg);
                    view.magnifiers = magnifiers_at(scene, is_square, power, power == 1 ? 900 : 450);
                    const Seen seen = look(scene, view, drawing.draw(view));
                    EXPECT_GT(seen.right, 150) << is_square << power << pitch_deg;
                    EXPECT_LE(seen.wrong, seen.right / 200) << is_square << power << pitch_deg;
                    EXPECT_GT(seen.moved, 60);
                    EXPECT_LT(seen.unmoved_right, seen.moved / 10) << "control: unmoved they lie elsewhere";
                    EXPECT_GT(drawing.drawn().draws, drawing.chunks());
                }
    }
}

TEST_P(Magnified, BeyondTheReachThePictureIsTheSameBitForBit) {
    const RasterScene scene = chequered(60);
    Drawing drawing(scene, GetParam());
    drawing.show_all_detail();  // else a focus has its neighbours refined, too
    terrain::View view = scene.view(80, 80, 9000, 0, -90);
    const Picture plain = drawing.draw(view);
    const std::uint32_t draws = drawing.drawn().draws;
    EXPECT_EQ(draws, drawing.chunks()) << "without magnifiers one draw a chunk";
    view.magnifiers = magnifiers_at(scene, false, 1);
    const Picture magnified = drawing.draw(view);
    const earth::Magnifier& magnifier = *view.magnifiers.begin();
    const double px_per_m = view.focal_px / 8500, reach_px = magnifier.reach_m() * px_per_m * 1.03 + 4;
    const auto middle = pixel_of(view, magnifier.middle() + magnifier.up() * 400.0);
    ASSERT_TRUE(middle.has_value());
    int outside = 0, differ_outside = 0, differ_inside = 0;
    for (std::uint32_t y = 0; y < kHeight; ++y)
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const bool differs = !std::equal(plain.at(x, y), plain.at(x, y) + 4, magnified.at(x, y));
            const bool is_outside = std::hypot(x - middle->x, y - middle->y) > reach_px;
            outside += is_outside ? 1 : 0;
            differ_outside += is_outside && differs ? 1 : 0;
            differ_inside += !is_outside && differs ? 1 : 0;
        }
    EXPECT_GT(outside, 10'000);
    EXPECT_EQ(differ_outside, 0);
    EXPECT_GT(differ_inside, 2000);
}

TEST_P(Magnified, InTheFocusASquareIsAsManyTimesLarger) {
    const RasterScene scene = chequered(0);
    Drawing drawing(scene, GetParam());
    terrain::View view = scene.view(84.5, 78.25, 7000, 0, -90);
    const Rgba color = square_color(86, 78);
    const auto pixels_of_square = [&](const Picture& picture) {
        int count = 0;
        for (std::uint32_t y = 0; y < kHeight; ++y)
            for (std::uint32_t x = 0; x < kWidth; ++x) count += picture.is(x, y, color) ? 1 : 0;
        return count;
    };
    const int plain = pixels_of_square(drawing.draw(view));
    view.magnifiers = magnifiers_at(scene, true, 1, 900);
    const int doubled = pixels_of_square(drawing.draw(view));
    EXPECT_GT(plain, 40);
    EXPECT_NEAR(static_cast<double>(doubled) / plain, 4, 0.6);
}

/// One sheet over all the ground, of two triangles, coloured by where its places are.
TEST_P(Magnified, DataLieWhereTheGroundBelowThemDoes) {
    const RasterScene scene = chequered(60);
    Drawing drawing(scene, GetParam());
    const auto corner = [&](double i, double j) { return earth::to_ecef(scene.place(i, j, 700)); };
    drawing.mesh().begin(corner(80, 80));
    const glm::dvec3 none(0);
    const auto vertex = [&](double i, double j) {
        drawing.mesh().set_color({static_cast<std::uint8_t>(i * 1.5), static_cast<std::uint8_t>(j * 1.5), 90},
                                 scene::Uncertainty::from_level(0));
        return drawing.mesh().vertex(corner(i, j), none);
    };
    const std::uint16_t nw = vertex(0, 0), ne = vertex(160, 0), se = vertex(160, 160), sw = vertex(0, 160);
    drawing.mesh().triangle(nw, sw, se);
    drawing.mesh().triangle(nw, se, ne);
    SolidLook look;
    drawing.batch().set_look(look, 0);
    ASSERT_TRUE(drawing.mesh().add_to(drawing.batch()));
    for (const double pitch_deg : {-90.0, -50.0}) {
        terrain::View view = pitch_deg < -80 ? scene.view(80, 80, 7000, 20, -90) : scene.view(80, 125, 6000, 5, pitch_deg);
        view.magnifiers = magnifiers_at(scene, false, 2, 450);
        const Picture picture = drawing.draw(view);
        int seen = 0, moved = 0;
        for (int j = 4; j < 160; j += 4)
            for (int i = 4; i < 160; i += 4) {
                const auto at = pixel_of(view, view.magnifiers.moved(corner(i, j)));
                if (!at || glm::distance(corner(i, j), view.eye) > 12'000) continue;
                const std::uint8_t* p = picture.at(at->x, at->y);
                ++seen;
                moved += glm::distance(view.magnifiers.moved(corner(i, j)), corner(i, j)) > 100 ? 1 : 0;
                ASSERT_NEAR(p[0], i * 1.5, 3) << i << ' ' << j << ' ' << pitch_deg;
                ASSERT_NEAR(p[1], j * 1.5, 3) << i << ' ' << j << ' ' << pitch_deg;
            }
        EXPECT_GT(seen, 300);
        EXPECT_GT(moved, 100);
    }
}

/// A glyph's foot, a sign's spot and the square that they stand on: the same pixel.
TEST_P(Magnified, SignsAndGlyphsStandOnTheMovedGround) {
    const RasterScene scene = chequered(60);
    Drawing drawing(scene, GetParam());
    terrain::View view = scene.view(80, 125, 6000, 5, -50);
    view.magnifiers = magnifiers_at(scene, true, 1);
    const Picture picture = drawing.draw(view);
    std::vector<GlyphInstance> room(1);
    int stood = 0, beside = 0;
    for (std::uint32_t j = 2; j < kPosts; j += 4)
        for (std::uint32_t i = 2; i < kPosts; i += 4) {
            const glm::dvec3 foot = scene.post(i, j);
            if (!is_clear_of_borders(view, foot, kClear_m) || glm::distance(foot, view.eye) > 12'000) continue;
            GlyphBatch batch({room.data(), room.size()});
            const GlyphInstance glyph = make_glyph(glm::vec3(foot - view.eye), glm::vec3(100), glm::dvec3(0), {});
            batch.add(GlyphShape::arrow, GlyphFacing::up, false, 1)[0] = glyph;
            batch.move_to_shown(0, view.magnifiers, view.eye);
            const glm::dvec3 shown = view.eye + glm::dvec3(batch.instances()[0].place);
            EXPECT_LT(glm::distance(shown, view.magnifiers.moved(foot)), 0.01);
            const auto at = pixel_of(view, shown);
            if (!at) continue;
            const Rgba here = square_color(static_cast<int>(i), static_cast<int>(j));
            ++(picture.is(at->x, at->y, here) ? stood : beside);
        }
    EXPECT_GT(stood, 150);
    EXPECT_LE(beside, stood / 200);
}

INSTANTIATE_TEST_SUITE_P(Lanes, Magnified, testing::Values("es2-small", "es3-mid"),
                         [](const auto& of) { return std::string(of.param) == "es2-small" ? "es2" : "es3"; });

}  // namespace
}  // namespace tedavis::draw::test_magnified_uniforms
