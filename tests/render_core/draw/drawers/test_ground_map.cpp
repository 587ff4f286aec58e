#include "render_core/draw/drawers/ground_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/draw/ground_drawing.hpp"

namespace tedavis::draw::test_ground_map {
namespace {

using design::Color;
using design::IntrinsicUncertainty;
using scene::FieldValue;
using scene::ValueState;
using test_support::ChunkDrawing;
using Drawn = test_support::GroundDrawing;
using test_support::color_blend;
using test_support::color_difference;
using test_support::field_over;
using test_support::ground_design;
using test_support::kBareGround;
using test_support::level_ground;
using test_support::LoadedScene;
using test_support::RasterScene;

class GroundMapOf : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Lanes, GroundMapOf, ::testing::Values("es2-small", "es3-mid"));

TEST_P(GroundMapOf, EveryPixelHasTheColorOfTheInterpolatedValue) {
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
                EXPECT_EQ(color_difference(drawn.pixel(column, row), kBareGround), 0) << column << ", " << row;
                continue;
            }
            ++inside;
            EXPECT_LE(color_difference(drawn.pixel(column, row), design::scale_color(design.data.ground.scale, value.value)), 1)
                << column << ", " << row << ": " << value.value;
        }
    EXPECT_GT(inside, 20'000);
    EXPECT_GT(beside, 5'000);
}

TEST_P(GroundMapOf, ClassesHaveOneColorEach) {
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

TEST_P(GroundMapOf, KindsHaveTheColorsOfTheirNamesAndNeverMix) {
    const RasterScene ground = level_ground();
    host_sim::LayerDraft draft = field_over(ground, 9);
    host_sim::AttributeDraft& kind = draft.attributes[0];
    kind.scale = scene::AttributeScale::nominal;
    kind.classes = {"light", "nameless", "dark"};
    for (std::size_t n = 0; n < kind.values.size(); ++n) kind.values[n] = static_cast<float>(n % 3);
    design::DesignSettings design = ground_design(IntrinsicUncertainty::none);
    design.data.ground.opacity = 1;
    design.data.ground.scale.palette = test_support::kinds_palette();
    const LoadedScene loaded(draft);
    const Drawn drawn(ground, loaded, design, GetParam());
    const Color colors[] = {{210, 210, 210}, kBareGround, {40, 40, 40}}, missing = test_support::clear_design().data.missing;
    std::array<int, 3> compared{};
    int wrong = 0;
    for (int row = 2; row < 238; ++row)
        for (int column = 2; column < 318; ++column) {
            const Color color = drawn.pixel(column, row);
            const bool is_pure = color == colors[0] || color == colors[1] || color == colors[2] || color == missing;
            const FieldValue value = drawn.at(column, row), beside = drawn.at(column + 1, row), below = drawn.at(column, row + 1),
                             before = drawn.at(column - 1, row), above = drawn.at(column, row - 1);
            const bool at_border = value.value != beside.value || value.value != below.value || value.value != before.value ||
                                   value.value != above.value;
            wrong += is_pure ? 0 : 1;
            if (value.state == ValueState::missing || at_border) continue;
            const auto number = static_cast<std::size_t>(value.value);
            ++compared[number];
            wrong += color == colors[number] || (number == 1 && color == missing) ? 0 : 1;
        }
    EXPECT_EQ(wrong, 0);
    for (const int count : compared) EXPECT_GT(count, 3'000);
}

TEST_P(GroundMapOf, ValuesBelowTheLimitHaveNoColor) {
    const RasterScene ground = level_ground();
    const LoadedScene loaded(field_over(ground, 9));
    design::DesignSettings design = ground_design(IntrinsicUncertainty::none);
    design.data.ground.opacity = 1;
    design.data.ground.shown_from = 45;
    const Drawn drawn(ground, loaded, design, GetParam());
    int below = 0, above = 0;
    for (int row = 2; row < 238; row += 3)
        for (int column = 2; column < 318; column += 3) {
            const FieldValue value = drawn.at(column, row);
            if (value.state == ValueState::missing || std::fabs(value.value - 45) < 0.1) continue;
            const bool has_none = color_difference(drawn.pixel(column, row), kBareGround) == 0;
            EXPECT_EQ(has_none, value.value < 45) << column << ", " << row << ": " << value.value;
            ++(value.value < 45 ? below : above);
        }
    EXPECT_GT(below, 500);
    EXPECT_GT(above, 500);
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
                Color expected = color_blend(kBareGround, full, 0.8);
                if (technique == IntrinsicUncertainty::transparency) expected = color_blend(kBareGround, full, 0.8 * (1 - loss));
                if (technique == IntrinsicUncertainty::saturation)
                    expected = color_blend(kBareGround, color_blend(full, {level, level, level}, loss), 0.8);
                if (technique == IntrinsicUncertainty::bivariate)
                    expected = color_blend(kBareGround, color_blend(full, kBareGround, loss), 0.8);
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
                bare[quarter] += color_difference(drawn.pixel(column, row), kBareGround) == 0 ? 1 : 0;
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
                bare += color_difference(drawn.pixel(column, row), kBareGround) == 0 ? 1 : 0;
                magenta += color_difference(drawn.pixel(column, row), test_support::clear_design().data.missing) == 0 ? 1 : 0;
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
    EXPECT_LT(drawn.picture.count(kBareGround), 60'000u);
    EXPECT_TRUE(drawn.drawing.set_ground_data(nullptr));
    EXPECT_GT(drawn.drawing.draw(drawn.input, 0.1).count(kBareGround), 60'000u);
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
}  // namespace tedavis::draw::test_ground_map
