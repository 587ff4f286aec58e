#include "host_sim/scene_builder/area_raster.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_area_raster {
namespace {

using test_support::expect_user_error;

using Corners = std::vector<std::array<double, 2>>;  // degrees east and north

/// Areas of one kind each; the first is 0.
LayerDraft areas_of(const std::vector<Corners>& rings) {
    LayerDraft layer;
    layer.name = "cover";
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::land_cover;
    layer.starts = {0};
    layer.names = std::vector<std::string>(rings.size(), "A");
    AttributeDraft kind;
    kind.name = "kind";
    kind.scale = scene::AttributeScale::nominal;
    kind.of = scene::AttributeOf::feature;
    for (const Corners& ring : rings) {
        for (const auto& [east, north] : ring) layer.points.push_back(test_support::scene_point(north, east, 0));
        layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
        kind.values.push_back(static_cast<float>(kind.classes.size()));
        kind.uncertainties.push_back(scene::Uncertainty::from_level(0.1 * static_cast<double>(kind.classes.size())));
        kind.classes.push_back("k" + std::to_string(kind.classes.size()));
    }
    layer.attributes = {kind};
    return layer;
}

/// By the angles under which a place sees the sides: whole turns are inside (Hormann, Agathos 2001, another rule than the code's;
/// the same for simple rings).
bool is_inside(const Corners& ring, double east, double north) {
    double turned = 0;
    for (std::size_t n = 0; n < ring.size(); ++n) {
        const auto &a = ring[n], &b = ring[(n + 1) % ring.size()];
        turned += std::remainder(std::atan2(b[1] - north, b[0] - east) - std::atan2(a[1] - north, a[0] - east), 2 * base::kPi);
    }
    return std::fabs(turned) > 3;
}

TEST(AreaRaster, PostsHaveTheKindOfTheLastAreaThatCoversThem) {
    const std::vector<Corners> rings = {{{9.5, 46.5}, {9.62, 46.52}, {9.6, 46.6}, {9.56, 46.54}, {9.51, 46.61}},  // not convex
                                        {{9.55, 46.51}, {9.7, 46.55}, {9.54, 46.58}}};
    const LayerDraft grid = rasterized(areas_of(rings), 250, {});
    EXPECT_EQ(grid.shape, scene::LayerShape::grid);
    EXPECT_TRUE(grid.points.empty() && grid.starts.empty() && grid.names.empty());
    const scene::GridShape& g = grid.grid;
    EXPECT_NEAR(g.step_lat_rad * 6.371e6, 250, 1e-6);
    EXPECT_NEAR(g.step_lon_rad * std::cos(base::radians(46.555)) * 6.371e6, 250, 0.01);
    const AttributeDraft& kind = grid.attributes[0];
    EXPECT_EQ(kind.of, scene::AttributeOf::point);
    ASSERT_EQ(kind.values.size(), std::size_t{g.columns} * g.rows);
    std::array<int, 3> found{};
    for (std::uint32_t j = 0; j < g.rows; ++j)
        for (std::uint32_t i = 0; i < g.columns; ++i) {
            const double east = base::degrees(g.west_rad + i * g.step_lon_rad),
                         north = base::degrees(g.north_rad - j * g.step_lat_rad);
            const std::size_t post = std::size_t{j} * g.columns + i;
            const int expected = is_inside(rings[1], east, north) ? 1 : is_inside(rings[0], east, north) ? 0 : -1;
            ++found[expected < 0 ? 0 : expected == 0 ? 1 : 2];
            if (expected < 0) {
                EXPECT_TRUE(std::isnan(kind.values[post])) << east << " " << north;
                EXPECT_FALSE(kind.uncertainties[post].is_known());
            } else {
                EXPECT_EQ(kind.values[post], expected) << east << " " << north;
                EXPECT_EQ(kind.uncertainties[post], scene::Uncertainty::from_level(0.1 * expected));
            }
        }
    for (const int count : found) EXPECT_GT(count, 200);
}

TEST(AreaRaster, ARingThatGoesToAHoleAndBackLeavesItOpen) {
    const Corners holed = {{9.5, 46.5},   {9.6, 46.5},   {9.6, 46.6},   {9.5, 46.6},  // outside
                           {9.53, 46.53}, {9.53, 46.57}, {9.57, 46.57}, {9.57, 46.53}, {9.53, 46.53}, {9.5, 46.6}};
    const LayerDraft grid = rasterized(areas_of({holed}), 400, {});
    int open = 0, covered = 0, edge = 0;
    for (std::uint32_t j = 0; j < grid.grid.rows; ++j)
        for (std::uint32_t i = 0; i < grid.grid.columns; ++i) {
            const double east = base::degrees(grid.grid.west_rad + i * grid.grid.step_lon_rad),
                         north = base::degrees(grid.grid.north_rad - j * grid.grid.step_lat_rad);
            const double from_middle = std::fmax(std::fabs(east - 9.55), std::fabs(north - 46.55));
            const bool is_open = std::isnan(grid.attributes[0].values[std::size_t{j} * grid.grid.columns + i]);
            if (std::fabs(from_middle - 0.02) < 1e-6 || from_middle > 0.0499) {
                ++edge;
            } else {
                EXPECT_EQ(is_open, from_middle < 0.02) << east << " " << north;
                ++(is_open ? open : covered);
            }
        }
    EXPECT_GT(open, 50);
    EXPECT_GT(covered, 300);
    EXPECT_LT(edge, 150);
}

TEST(AreaRaster, ARegionCutsIt) {
    const LayerDraft areas = areas_of({{{9.5, 46.5}, {9.6, 46.5}, {9.6, 46.6}, {9.5, 46.6}}});
    const scene::GridShape grid = rasterized(areas, 100, RegionRecipe{9.55, 46.4, 9.58, 46.55}).grid;
    EXPECT_NEAR(base::degrees(grid.west_rad), 9.55, 1e-9);
    EXPECT_NEAR(base::degrees(grid.north_rad), 46.55, 1e-9);
    EXPECT_LE(base::degrees(grid.west_rad + grid.step_lon_rad * (grid.columns - 1)), 9.58);
    EXPECT_GE(base::degrees(grid.north_rad - grid.step_lat_rad * (grid.rows - 1)), 46.5 - 1e-9);
}

TEST(AreaRaster, WhatCannotBeIsSaid) {
    const LayerDraft areas = areas_of({{{9.5, 46.5}, {9.6, 46.5}, {9.6, 46.6}, {9.5, 46.6}}});
    expect_user_error([&] { (void)rasterized(areas, 1, {}); }, "is too large; give a larger 'raster_m'");
    expect_user_error([&] { (void)rasterized(areas, 100, RegionRecipe{1, 2, 3, 4}); }, "no areas to make a raster of");
    expect_user_error([] { (void)rasterized(areas_of({}), 100, {}); }, "no areas to make a raster of");
    expect_user_error([] { (void)rasterized(areas_of({{{-170, 10}, {170, 10}, {170, 11}}}), 50'000, {}); }, "choose a region");
    expect_user_error([] { (void)rasterized(test_support::small_points(), 100, {}); }, "'raster_m' is for areas");
    LayerDraft bare = areas, by_point = areas;
    bare.attributes.clear();
    expect_user_error([&] { (void)rasterized(bare, 100, {}); }, "bind one");
    by_point.attributes[0].of = scene::AttributeOf::point;
    expect_user_error([&] { (void)rasterized(by_point, 100, {}); }, "has values by point");
}

}  // namespace
}  // namespace tedavis::host_sim::test_area_raster
