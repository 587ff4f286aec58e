#include "render_core/draw/ground_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/chunk_drawing.hpp"
#include "tests/support/loaded_scene.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis::draw {
namespace {

using design::Color;
using design::IntrinsicUncertainty;
using scene::FieldValue;
using scene::ValueState;
using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::color_blend;
using test_support::color_difference;
using test_support::LoadedScene;
using test_support::RasterScene;

constexpr Color kGround{200, 190, 170};
constexpr double kLowest = 0, kHighest = 100;

/// Level ground, so that places of pixels are known without a mesh.
RasterScene level_ground() {
    host_sim::Raster raster = test_support::eastward_ramp();
    for (float& height_m : raster.height_m) height_m = 500;
    return RasterScene(raster);
}

/// A field over the middle of the ground, smooth, with uncertainty from west to east.
host_sim::LayerDraft field_over(const RasterScene& ground, int side) {
    host_sim::LayerDraft layer;
    layer.name = "field";
    layer.shape = scene::LayerShape::grid;
    const earth::Geodetic corner = ground.place(20, 20, 0), opposite = ground.place(140, 140, 0);
    const auto count = static_cast<std::uint32_t>(side);
    layer.grid = {corner.longitude_rad,
                  corner.latitude_rad,
                  (opposite.longitude_rad - corner.longitude_rad) / (side - 1),
                  (corner.latitude_rad - opposite.latitude_rad) / (side - 1),
                  count,
                  count,
                  1,
                  1};
    host_sim::AttributeDraft value;
    value.name = "value";
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            value.values.push_back(static_cast<float>(50 + 49 * std::sin(0.9 * i) * std::cos(0.7 * j)));
            value.uncertainties.push_back(scene::Uncertainty::from_level(i / (side - 1.0)));
        }
    layer.attributes = {value};
    return layer;
}

design::Palette greens() {
    design::Palette palette;
    palette.name = "greens";
    palette.kind = design::PaletteKind::sequential;
    palette.unit = design::PaletteUnit::one;
    EXPECT_TRUE(palette.stops.try_push_back({kLowest, {240, 250, 230}}));
    EXPECT_TRUE(palette.stops.try_push_back({40, {120, 190, 140}}));
    EXPECT_TRUE(palette.stops.try_push_back({kHighest, {10, 60, 50}}));
    return palette;
}

/// Plain ground without light, coloured by the field.
design::DesignSettings ground_design(IntrinsicUncertainty technique) {
    design::DesignSettings design = test_support::clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = kGround;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.data.ground.is_shown = true;
    design.data.ground.scale.palette = greens();
    design.data.ground.opacity = 0.8;
    design.data.ground.uncertainty = {technique, 0.75, 0};
    return design;
}

/// Where a pixel's middle looks at ground of a height above MSL, seen from above.
earth::Geodetic place_of(const terrain::View& view, int column, int row, double ellipsoid_m) {
    const glm::dvec3 way = view.forward + view.right * ((column + 0.5 - 0.5 * view.width) / view.focal_px) +
                           view.down * ((row + 0.5 - 0.5 * view.height) / view.focal_px);
    double near_m = 0, far_m = 1e5;
    for (int n = 0; n < 60; ++n) {
        const double middle_m = 0.5 * (near_m + far_m);
        (earth::from_ecef(view.eye + way * middle_m).height.m > ellipsoid_m ? near_m : far_m) = middle_m;
    }
    return earth::from_ecef(view.eye + way * near_m);
}

/// A slice of the field, drawn from above.
struct Drawn {
    Drawn(const RasterScene& ground, const LoadedScene& loaded, const design::DesignSettings& design, const std::string& device)
        : drawing(ground, design, "egl", device), field(loaded.layer(), loaded.attribute()) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(slice.start(128 * 128, arena));
        EXPECT_TRUE(slice.set_field(loaded.layer(), loaded.attribute()));
        EXPECT_TRUE(slice.show(0, 0));
        EXPECT_TRUE(drawing.set_ground_data(&slice));
        input = test_support::lit_from_above(ground.view(80, 80, 9000, 0, -90));
        ellipsoid_m = ground.place(80, 80, 500).height.m;
        picture = drawing.draw(input, 0.1);
    }
    [[nodiscard]] FieldValue at(int column, int row) const {
        const earth::Geodetic place = place_of(input.view, column, row, ellipsoid_m);
        return field.at(place.latitude_rad, place.longitude_rad, 0, 0);
    }
    [[nodiscard]] Color pixel(int column, int row) const { return picture.at(column + 0.5, row + 0.5); }

    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(1 << 18);
    ChunkDrawing drawing;
    scene::GridField field;
    scene::GridSlice slice;
    TerrainDrawInput input;
    double ellipsoid_m = 0;
    ChunkPicture picture;
};

class GroundMapOf : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Lanes, GroundMapOf, ::testing::Values("es2-small", "es3-mid"));

TEST_P(GroundMapOf, EveryPixelHasTheColourOfTheInterpolatedValue) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    design::DesignSettings design = ground_design(IntrinsicUncertainty::none);
    design.data.ground.opacity = 1;
    const Drawn drawn(ground, loaded, design, GetParam());
    int inside = 0, beside = 0;
    for (int row = 2; row < 238; ++row)
        for (int column = 2; column < 318; ++column) {
            const FieldValue value = drawn.at(column, row);
            if (value.state == ValueState::missing) {
                ++beside;
                EXPECT_EQ(color_difference(drawn.pixel(column, row), kGround), 0) << column << ", " << row;
                continue;
            }
            ++inside;
            EXPECT_LE(color_difference(drawn.pixel(column, row), design::scale_color(design.data.ground.scale, value.value)), 1)
                << column << ", " << row << ": " << value.value;
        }
    EXPECT_GT(inside, 20'000);
    EXPECT_GT(beside, 5'000);
}

TEST_P(GroundMapOf, ClassesHaveOneColourEach) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    design::DesignSettings design = ground_design(IntrinsicUncertainty::none);
    design.data.ground.opacity = 1;
    for (const double limit : {20.0, 45.0, 70.0}) EXPECT_TRUE(design.data.ground.scale.breaks.try_push_back(limit));
    const Drawn drawn(ground, loaded, design, GetParam());
    int compared = 0, at_limits = 0;
    for (int row = 2; row < 238; row += 2)
        for (int column = 2; column < 318; column += 2) {
            const FieldValue value = drawn.at(column, row);
            if (value.state == ValueState::missing) continue;
            const design::DataScale& scale = design.data.ground.scale;
            if (design::class_of(scale, value.value - 0.1) !=
                design::class_of(scale, value.value + 0.1)) {  // a few hundredths of a pixel
                ++at_limits;
                continue;
            }
            ++compared;
            EXPECT_EQ(color_difference(drawn.pixel(column, row), design::scale_color(scale, value.value)), 0)
                << column << ", " << row << ": " << value.value;
        }
    EXPECT_GT(compared, 4'000);
    EXPECT_LT(at_limits, 400);
}

TEST_P(GroundMapOf, TransparencySaturationAndBivariateTakeAwayWithTheLevel) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    for (const IntrinsicUncertainty technique :
         {IntrinsicUncertainty::transparency, IntrinsicUncertainty::saturation, IntrinsicUncertainty::bivariate}) {
        const design::DesignSettings design = ground_design(technique);
        const Drawn drawn(ground, loaded, design, GetParam());
        int compared = 0;
        for (int row = 3; row < 238; row += 5)
            for (int column = 3; column < 318; column += 5) {
                const FieldValue value = drawn.at(column, row);
                if (value.state == ValueState::missing) continue;
                const Color full = design::scale_color(design.data.ground.scale, value.value);
                const double loss = 0.75 * value.uncertainty.level(),
                             grey = 0.2126 * full.red + 0.7152 * full.green + 0.0722 * full.blue;
                const auto level = static_cast<std::uint8_t>(std::lround(grey));
                Color expected = color_blend(kGround, full, 0.8);
                if (technique == IntrinsicUncertainty::transparency) expected = color_blend(kGround, full, 0.8 * (1 - loss));
                if (technique == IntrinsicUncertainty::saturation)
                    expected = color_blend(kGround, color_blend(full, {level, level, level}, loss), 0.8);
                if (technique == IntrinsicUncertainty::bivariate)
                    expected = color_blend(kGround, color_blend(full, kGround, loss), 0.8);
                EXPECT_LE(color_difference(drawn.pixel(column, row), expected), 2) << column << ", " << row;
                ++compared;
            }
        EXPECT_GT(compared, 700);
    }
}

/// Grains and strokes are all or nothing in a pixel; how many of them are ground follows the level.
TEST_P(GroundMapOf, NoiseAndStrokesLeaveMoreGroundTheLessSure) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    for (const IntrinsicUncertainty technique : {IntrinsicUncertainty::noise, IntrinsicUncertainty::strokes}) {
        const Drawn drawn(ground, loaded, ground_design(technique), GetParam());
        int bare[4]{}, all[4]{};
        for (int row = 2; row < 238; ++row)
            for (int column = 2; column < 318; ++column) {
                const FieldValue value = drawn.at(column, row);
                if (value.state == ValueState::missing) continue;
                const int quarter = std::min(static_cast<int>(value.uncertainty.level() * 4), 3);
                ++all[quarter];
                bare[quarter] += color_difference(drawn.pixel(column, row), kGround) == 0 ? 1 : 0;
            }
        double last = -1;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double share = static_cast<double>(bare[quarter]) / all[quarter];
            EXPECT_GT(share, last) << quarter;
            EXPECT_NEAR(share, 0.75 * (quarter + 0.5) / 4, 0.12) << quarter;
            last = share;
        }
    }
}

TEST_P(GroundMapOf, WhatIsMissingUnknownOrInterpolatedHasASignOfItsOwn) {
    const RasterScene ground = level_ground();
    const auto bare_share = [&](const host_sim::LayerDraft& draft) {
        const LoadedScene loaded(draft);
        const Drawn drawn(ground, loaded, ground_design(IntrinsicUncertainty::none), GetParam());
        int bare = 0, magenta = 0, all = 0;
        for (int row = 60; row < 180; ++row)
            for (int column = 100; column < 220; ++column, ++all) {
                bare += color_difference(drawn.pixel(column, row), kGround) == 0 ? 1 : 0;
                magenta += color_difference(drawn.pixel(column, row), test_support::clear_design().terrain.unknown) == 0 ? 1 : 0;
            }
        return std::pair{static_cast<double>(bare) / all, static_cast<double>(magenta) / all};
    };
    host_sim::LayerDraft draft = field_over(ground, 9);
    host_sim::AttributeDraft& value = draft.attributes[0];
    EXPECT_EQ(bare_share(draft).first, 0) << "known and valid: all of it has colour";
    value.states.assign(81, ValueState::interpolated);
    const double filled = bare_share(draft).first;
    EXPECT_GT(filled, 0.2);
    EXPECT_LT(filled, 0.5);
    value.states.clear();
    value.uncertainties.assign(81, scene::Uncertainty());
    EXPECT_NEAR(bare_share(draft).first, 1 / 3.0, 0.03) << "stripes, whatever the technique";
    value.values.assign(81, std::nanf(""));
    const auto [bare, magenta] = bare_share(draft);
    EXPECT_GT(bare, 0.85);
    EXPECT_NEAR(bare + magenta, 1, 1e-9);
    EXPECT_GT(magenta, 0.02) << "dots";
}

TEST_P(GroundMapOf, WithoutDataTheGroundIsAsItIs) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    Drawn drawn(ground, loaded, ground_design(IntrinsicUncertainty::transparency), GetParam());
    EXPECT_LT(drawn.picture.count(kGround), 60'000u);
    EXPECT_TRUE(drawn.drawing.set_ground_data(nullptr));
    EXPECT_GT(drawn.drawing.draw(drawn.input, 0.1).count(kGround), 60'000u);
}

TEST_P(GroundMapOf, ADesignThatAsksForNoneHasNoMap) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    design::DesignSettings nothing = ground_design(IntrinsicUncertainty::none);
    nothing.data.ground.is_shown = false;
    ChunkDrawing drawing(ground, nothing, "egl", GetParam());
    scene::GridSlice slice;
    EXPECT_FALSE(drawing.set_ground_data(&slice));
    EXPECT_TRUE(drawing.set_ground_data(nullptr));
}

TEST(GridWindow, LeadsFromPlacesOfChunksToPostsOfTheGrid) {
    const RasterScene ground = level_ground();
    const terrain::Lattice& lattice = ground.built.database.lattice();
    const host_sim::LayerDraft draft = field_over(ground, 9);
    for (const terrain::ChunkKey key : {terrain::ChunkKey{0, 0, 0}, {0, 3, 2}, {1, 1, 1}}) {
        const GridWindow window = grid_window(lattice, key, draft.grid);
        const terrain::PostRange posts = lattice.posts_of(key);
        for (const std::uint32_t i : {posts.i0, posts.i1})
            for (const std::uint32_t j : {posts.j0, posts.j1}) {
                const double east = (lattice.longitude_rad(i) - draft.grid.west_rad) / draft.grid.step_lon_rad;
                const double south = (draft.grid.north_rad - lattice.latitude_rad(j)) / draft.grid.step_lat_rad;
                EXPECT_NEAR((i - posts.i0) * window.scale_i + window.offset_i, east, 1e-9);
                EXPECT_NEAR((j - posts.j0) * window.scale_j + window.offset_j, south, 1e-9);
            }
    }
}

}  // namespace
}  // namespace tedavis::draw
