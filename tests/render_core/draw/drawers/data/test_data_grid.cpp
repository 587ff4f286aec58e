// Lines on plates over the Earth, pixel by pixel against what longitude, latitude and height of the place seen there say in
// double.
#include "render_core/draw/drawers/data/data_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/draw/drawers/data/solid_drawer.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/raster_scene.hpp"

namespace tedavis::draw::test_data_grid {
namespace {

constexpr std::uint32_t kSide_px = 96;
constexpr double kFocal_px = 400, kAway_m = 100;  // a pixel is a quarter of a metre wide
constexpr double kSpacing_m = 11, kHeights_m = 10;
constexpr double kHalf_m = 200;
constexpr std::uint8_t kFull = 255;

const terrain::TerrainDatabase& database() {
    static const test_support::RasterScene scene(
        test_support::make_raster(161, 161, [](std::uint32_t, std::uint32_t) { return 1000.0f; }));
    return scene.built.database;
}

/// Flat, `away_m` from its piece's anchor to the north-east.
struct Plate {
    double latitude_deg = 47, longitude_deg = 9.7, height_m = 1500;
    double faces_deg = 0;   ///< clockwise from north
    double rises_deg = 90;  ///< from the wall that faces so; 90 for a floor
    double away_m = 0;

    [[nodiscard]] earth::Geodetic middle() const {
        return {base::radians(latitude_deg), base::radians(longitude_deg), {height_m}};
    }
    [[nodiscard]] glm::dvec3 place() const { return earth::to_ecef(middle()); }
    /// Towards its eye, right of and down from it.
    [[nodiscard]] glm::dmat3 axes() const {
        return earth::body_axes(middle().latitude_rad, middle().longitude_rad, base::radians(faces_deg), base::radians(rises_deg),
                                0);
    }
    [[nodiscard]] glm::dvec3 anchor() const {
        const glm::dmat3 ned = earth::north_east_down(middle().latitude_rad, middle().longitude_rad);
        return place() - std::sqrt(0.5) * away_m * (ned[0] + ned[1]);
    }
};

/// Of a place, counted in lines east, south and up: by the middle latitude of the database, from its north-west corner.
glm::dvec3 lines_at(const glm::dvec3& at) {
    const earth::Geodetic place = earth::from_ecef(at);
    const terrain::Lattice& lattice = database().lattice();
    const double middle = lattice.latitude_rad(lattice.rows() / 2);
    const double east_m = earth::prime_vertical_radius_m(middle) * std::cos(middle), north_m = earth::meridian_radius_m(middle);
    const double turned = std::remainder(place.longitude_rad - lattice.longitude_rad(0), 2 * base::kPi);
    return {turned * east_m / kSpacing_m, (lattice.latitude_rad(0) - place.latitude_rad) * north_m / kSpacing_m,
            (place.height.m - database().undulation(place.latitude_rad, place.longitude_rad).m) / kHeights_m};
}

struct Picture {
    std::vector<std::uint8_t> rgba;
    [[nodiscard]] double ink(std::uint32_t x, std::uint32_t y) const {
        return 1 - rgba[(std::size_t{kSide_px - 1 - y} * kSide_px + x) * 4 + 1] / 255.0;
    }
    [[nodiscard]] double most_ink() const {
        double most = 0;
        for (std::uint32_t y = 0; y < kSide_px; ++y)
            for (std::uint32_t x = 0; x < kSide_px; ++x) most = std::max(most, ink(x, y));
        return most;
    }
};

/// White plates that no light shades, with black lines; one in a picture.
class Plates {
public:
    explicit Plates(const std::string& device = "es3-mid", bool has_grid = true)
        : session_("egl", device, kSide_px, kSide_px), block_(1u << 20) {
        base::Arena arena(block_.data(), block_.size());
        base::BudgetLine& line = *session_.device.budget.find(effects::kSceneSolidVertices);
        EXPECT_TRUE(solids_.start(session_.gl, line, arena, {64, 192, 4}, gl::BufferUse::streamed).message.empty());
        EXPECT_EQ(drawer_.start(session_.gl, arena, 4, {false, has_grid, false}).message.view(), "");
        EXPECT_TRUE(mesh_.start(arena));
        session_.gl.seal();
        frame.grid = {&settings, &database()};
    }
    ~Plates() {
        session_.gl.retire();
        drawer_.destroy(session_.gl);
        solids_.destroy(session_.gl);
    }

    /// `turned_deg`: the eye stands aside by so much.
    Picture of(const Plate& plate, double turned_deg = 0) {
        add(plate);
        const glm::dmat3 axes = plate.axes();
        const double turn = base::radians(turned_deg);
        const glm::dvec3 to_eye = std::cos(turn) * axes[0] + std::sin(turn) * axes[1];
        const glm::dvec3 right = std::sin(turn) * axes[0] - std::cos(turn) * axes[1];
        frame.view = test_support::free_view(plate.place() + kAway_m * to_eye, {-to_eye, right, axes[2]}, kSide_px, kSide_px, 1);
        frame.view.focal_px = kFocal_px;
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(1, 1, 1, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        session_.gl->Enable(GL_DEPTH_TEST);
        EXPECT_TRUE(solids_.upload(session_.gl));
        const SolidBuffers* const all[] = {&solids_};
        EXPECT_GT(drawer_.draw(session_.gl, all, {frame}, {1, 10'000}), 0u);
        EXPECT_EQ(session_.gl.take_error(), 0u);
        EXPECT_EQ(session_.gl.denied().total, 0u);
        return {session_.pixels()};
    }

    design::GridSettings settings{kSpacing_m, 0, {0, 0, 0}, 1, kHeights_m};
    SolidLook look = [] {
        SolidLook asks;
        asks.has_grid = true;
        return asks;
    }();
    DataFrame frame;
    design::Color color{kFull, kFull, kFull};

private:
    void add(const Plate& plate) {
        const glm::dmat3 axes = plate.axes();
        const glm::dvec3 middle = plate.place(), right = -kHalf_m * axes[1], down = kHalf_m * axes[2];
        solids_.batch().clear();
        solids_.batch().set_look(look, 0);
        mesh_.begin(plate.anchor());
        mesh_.set_color(color);
        const auto corner = [&](double x, double y) { return mesh_.vertex(middle + x * right + y * down, kUnshaded * axes[0]); };
        const std::uint16_t a = corner(-1, 1), b = corner(1, 1), c = corner(1, -1), d = corner(-1, -1);
        mesh_.triangle(a, b, c);
        mesh_.triangle(a, c, d);
        EXPECT_TRUE(mesh_.add_to(solids_.batch()));
    }

    test_support::GlSession session_;
    std::vector<unsigned char> block_;
    test_support::FilledSolids solids_;
    SolidDrawer drawer_;
    SolidMesh mesh_;
};

glm::dvec3 seen_at(const Plates& plates, const Plate& plate, double x, double y) {
    const terrain::View& view = plates.frame.view;
    const glm::dvec3 ray =
        view.forward + (x - kSide_px * 0.5) / kFocal_px * view.right + (y - kSide_px * 0.5) / kFocal_px * view.down;
    const glm::dvec3 normal = plate.axes()[0];
    return view.eye + ray * (glm::dot(plate.place() - view.eye, normal) / glm::dot(ray, normal));
}

struct Agreement {
    int on_lines = 0, beside = 0, wrong = 0;
};

/// Of a picture with where lines of these axes (east, south, up) are; what is between on and beside is not looked at. A line a
/// fifth of a pixel from its place is wrong.
Agreement agreement(const Picture& picture, const Plates& plates, const Plate& plate, const bool (&axes)[3], double off_m = 0) {
    Agreement found;
    for (std::uint32_t y = 0; y < kSide_px; ++y)
        for (std::uint32_t x = 0; x < kSide_px; ++x) {
            const auto lines = [&](double dx, double dy) {
                return lines_at(seen_at(plates, plate, x + 0.5 + dx, y + 0.5 + dy)) + off_m / kSpacing_m;
            };
            const glm::dvec3 here = lines(0, 0), across = lines(1, 0) - here, down = lines(0, 1) - here;
            double away_px = 1e9;
            for (int n = 0; n < 3; ++n)
                if (axes[n])
                    away_px = std::min(away_px, std::fabs(here[n] - std::round(here[n])) / std::hypot(across[n], down[n]));
            const double ink = picture.ink(x, y);
            const bool is_on = away_px<0.6, is_beside = away_px> 1.5;
            found.on_lines += is_on ? 1 : 0;
            found.beside += is_beside ? 1 : 0;
            found.wrong += (is_on && ink < 0.5) || (is_beside && ink > 0.02) ? 1 : 0;
        }
    return found;
}

void expect_lines(Plates& plates, const Plate& plate, const bool (&axes)[3], double turned_deg = 0) {
    const Picture picture = plates.of(plate, turned_deg);
    const Agreement found = agreement(picture, plates, plate, axes);
    EXPECT_GT(found.on_lines, 100);
    EXPECT_GT(found.beside, 4000);
    EXPECT_EQ(found.wrong, 0);
}

constexpr bool kLevel[3] = {true, true, false}, kAll[3] = {true, true, true};

TEST(DataGrid, OnALevelPlateLinesStandOverThoseOfTheGround) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        Plates plates(device);
        for (const double away_m : {0.0, 3000.0, 30'000.0}) {
            SCOPED_TRACE(std::string(device) + ", m from the anchor: " + std::to_string(away_m));
            expect_lines(plates, {47, 9.7, 1500, 20, 90, away_m}, kLevel);
        }
    }
}

TEST(DataGrid, NorthAndSouthOfTheEquatorAndFarFromTheDatabase) {
    Plates plates;
    for (const auto& [latitude_deg, longitude_deg] : {std::pair(0.01, 12.0), {-33.9, 151.2}, {69.9, -20.4}, {80.0, 9.6}}) {
        SCOPED_TRACE(latitude_deg);
        for (const double away_m : {0.0, 20'000.0})
            expect_lines(plates, {latitude_deg, longitude_deg, 900, 0, 90, away_m}, kLevel);
    }
}

TEST(DataGrid, OnAWallLinesOfEqualHeightAreThoseAboveTheSea) {
    const double undulation_m = database().undulation(base::radians(47), base::radians(9.7)).m;
    EXPECT_GT(undulation_m, 40) << "control: heights over the ellipsoid are others";
    for (const char* device : {"es2-small", "es3-mid"}) {
        Plates plates(device);
        for (const double faces_deg : {30.0, 120.0, 250.0})
            for (const double away_m : {0.0, 3000.0}) {
                SCOPED_TRACE(std::string(device) + ", " + std::to_string(faces_deg) + ", " + std::to_string(away_m));
                expect_lines(plates, {47, 9.7, 1500, faces_deg, 0, away_m}, kAll);
                expect_lines(plates, {47, 9.7, 1500, faces_deg, 0, away_m}, kAll, 50);
            }
    }
}

/// The sea's level is taken to be even round an anchor.
TEST(DataGrid, TheGeoidBendsLittleOverAPiece) {
    const design::GridSettings settings{kSpacing_m, 0, {0, 0, 0}, 1, kHeights_m};
    const earth::Geodetic anchor{base::radians(47), base::radians(9.7), {1500}};
    const GridPlace place = grid_place({&settings, &database()}, earth::to_ecef(anchor), true);
    const auto level_m = [](double latitude_rad, double longitude_rad) {
        return database().undulation(latitude_rad, longitude_rad).m;
    };
    const double here_m = level_m(anchor.latitude_rad, anchor.longitude_rad);
    double bends_m = 0, climbs_m = 0;
    for (int n = 0; n < 16; ++n) {
        const double way = base::kPi * n / 8, rad = 15'000 / earth::kMeanRadius_m;
        const glm::dvec2 moved(rad * std::sin(way) / std::cos(anchor.latitude_rad), rad * std::cos(way));
        const double there_m = level_m(anchor.latitude_rad + moved.y, anchor.longitude_rad + moved.x) - here_m;
        bends_m = std::max(bends_m, std::fabs(there_m - glm::dot(glm::dvec2(place.climb), moved)));
        climbs_m = std::max(climbs_m, std::fabs(there_m));
    }
    EXPECT_LT(bends_m, 0.5) << "between the Alps and the plain, 15 km away";
    EXPECT_GT(climbs_m, 0.5) << "control: it is not level";
}

TEST(DataGrid, OnASlopeSeenAslantAllStandWhereTheyAre) {
    Plates plates;
    for (const double rises_deg : {35.0, 70.0, 85.0}) {
        SCOPED_TRACE(rises_deg);
        expect_lines(plates, {47, 9.7, 1500, 40, rises_deg, 1000}, kAll, -40);
    }
}

/// A plate in the very plane of a line would be filled by it.
TEST(DataGrid, LinesOfAnAxisDoNotFillWhatLiesAlongThem) {
    const terrain::Lattice& lattice = database().lattice();
    const double middle = lattice.latitude_rad(lattice.rows() / 2);
    const double line_rad = kSpacing_m / (earth::prime_vertical_radius_m(middle) * std::cos(middle));
    const double along_deg = base::degrees(lattice.longitude_rad(0) + std::round(0.05 * base::kPi / 180 / line_rad) * line_rad);
    const double undulation_m = database().undulation(base::radians(47), base::radians(along_deg)).m;
    Plates plates;
    constexpr bool kAcross[3] = {false, true, true};
    expect_lines(plates, {47, along_deg, 1500, 90, 0}, kAcross);
    expect_lines(plates, {47, along_deg, 1500, 90, 0, 10'000}, kAcross, 30);
    expect_lines(plates, {47, along_deg, 150 * kHeights_m + undulation_m, 0, 90}, kLevel);
    // The control: turned out of it a little, the line is there.
    const Plate turned{47, along_deg, 1500, 84, 0};
    const Picture picture = plates.of(turned);
    EXPECT_EQ(agreement(picture, plates, turned, kAll).wrong, 0);
    EXPECT_GT(agreement(picture, plates, turned, kAcross).wrong, 50) << "a line that is not expected is noticed";
}

TEST(DataGrid, ALineOutOfItsPlaceIsNoticed) {
    Plates plates;
    const Plate plate{47, 9.7, 1500, 20, 90, 3000};
    const Picture picture = plates.of(plate);
    EXPECT_EQ(agreement(picture, plates, plate, kLevel).wrong, 0);
    EXPECT_GT(agreement(picture, plates, plate, kLevel, 0.1).wrong, 20) << "a tenth of a metre, two fifths of a pixel";
}

TEST(DataGrid, BothLanesDrawTheSame) {
    const auto drawn = [](const std::string& device) { return Plates(device).of({47, 9.7, 1500, 40, 50, 1000}, 20); };
    const Picture a = drawn("es2-small"), b = drawn("es3-mid");
    EXPECT_GT(a.most_ink(), 0.9);
    int off = 0;
    for (std::size_t n = 0; n < a.rgba.size(); ++n) off += std::abs(a.rgba[n] - b.rgba[n]) > 1 ? 1 : 0;
    EXPECT_LT(off, 4);
}

TEST(DataGrid, WhatDoesNotAskHasNoLines) {
    const Plate plate;
    Plates plates;
    EXPECT_GT(plates.of(plate).most_ink(), 0.9) << "control";
    plates.look.has_grid = false;
    EXPECT_EQ(plates.of(plate).most_ink(), 0);
    plates.look.has_grid = true;
    plates.frame.grid = {};
    EXPECT_EQ(plates.of(plate).most_ink(), 0) << "nor a frame without a grid";
    plates.settings.spacing_m = 0;
    plates.frame.grid = {&plates.settings, &database()};
    EXPECT_EQ(plates.of(plate).most_ink(), 0);
}

TEST(DataGrid, WithoutTheVariantNothingOfItIsThere) {
    Plates plates("es3-mid", false);
    EXPECT_EQ(plates.of(Plate()).most_ink(), 0);
}

TEST(DataGrid, LinesFadeBeforeTheyRunTogether) {
    Plates plates;
    const auto ink_of = [&](double spacing_px) {
        plates.settings.spacing_m = spacing_px * kAway_m / kFocal_px;
        return plates.of(Plate()).most_ink();
    };
    EXPECT_GT(ink_of(12), 0.9);
    EXPECT_GT(ink_of(6), 0.1);
    EXPECT_LT(ink_of(6), 0.7);
    EXPECT_EQ(ink_of(3.5), 0);
}

TEST(DataGrid, WhatLiesOnTheGroundHasNoLinesOfEqualHeight) {
    Plates plates;
    const Plate slope{47, 9.7, 1500, 40, 50, 1000};
    EXPECT_EQ(agreement(plates.of(slope), plates, slope, kAll).wrong, 0) << "control";
    plates.look.raised_px = 0.01f;
    EXPECT_EQ(agreement(plates.of(slope), plates, slope, kLevel).wrong, 0);
}

TEST(DataGrid, LinesAreAsFaintAsWhatTheyStandOn) {
    Plates plates;
    plates.look.is_mixed = true;
    plates.look.is_hollow = true;
    plates.look.opacity = 0.4f;
    EXPECT_NEAR(plates.of(Plate()).most_ink(), 0.4 * 1.6, 0.02) << "over white, lines take more";
    plates.look.opacity = 0;
    EXPECT_EQ(plates.of(Plate()).most_ink(), 0);
}

TEST(DataGrid, ItsUniformsAreThoseOfItsShader) {
    const std::string text(shader_text(k_data_grid_frag));
    std::size_t declared = 0;
    for (std::size_t at = text.find("uniform "); at != std::string::npos; at = text.find("uniform ", at + 1)) ++declared;
    EXPECT_EQ(declared, kGridUniforms);
    for (const char* name : kGridUniformNames) EXPECT_NE(text.find(" " + std::string(name) + ";"), std::string::npos) << name;
}

TEST(DataGrid, BesideThePolesThereIsNone) {
    design::GridSettings settings{kSpacing_m, 0, {10, 20, 30}, 0.5, kHeights_m};
    const DataGrid grid{&settings, &database()};
    const auto strength = [&](double latitude_deg) {
        return grid_place(grid, earth::to_ecef({base::radians(latitude_deg), 0.2, {500}}), true).look.w;
    };
    EXPECT_EQ(strength(88.5), 0.5f);
    EXPECT_EQ(strength(-88.5), 0.5f);
    for (const double latitude_deg : {89.5, -89.5, 90.0, -90.0}) EXPECT_EQ(strength(latitude_deg), 0);
}

}  // namespace
}  // namespace tedavis::draw::test_data_grid
