#include "host_sim/scene_builder/grid_window.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_grid_window {
namespace {

using Numbers = std::vector<int>;

GridPlaces places(double west_deg, double north_deg, double step_deg, int columns, int rows) {
    return {west_deg, north_deg, step_deg, step_deg, columns, rows};
}

TEST(GridWindow, WithoutARegionItIsAll) {
    const GridWindow window = window_of(places(5, 48, 0.5, 3, 2), {});
    EXPECT_EQ(window.columns, (Numbers{0, 1, 2}));
    EXPECT_EQ(window.rows, (Numbers{0, 1}));
    EXPECT_EQ(window.west_deg, 5);
    EXPECT_EQ(window.north_deg, 48);
}

TEST(GridWindow, TheRegionLiesBetweenItsPosts) {
    const GridPlaces grid = places(5, 48, 0.5, 10, 10);
    GridWindow window = window_of(grid, RegionRecipe{6.2, 46.6, 7.1, 47.1});
    EXPECT_EQ(window.columns, (Numbers{2, 3, 4, 5}));
    EXPECT_EQ(window.rows, (Numbers{1, 2, 3}));
    EXPECT_EQ(window.west_deg, 6);
    EXPECT_EQ(window.north_deg, 47.5);
    window = window_of(grid, RegionRecipe{6, 46.5, 7, 47});
    EXPECT_EQ(window.columns, (Numbers{2, 3, 4})) << "sides on posts need no more";
    EXPECT_EQ(window.rows, (Numbers{2, 3}));
    window = window_of(grid, RegionRecipe{0, 40, 5.4, 60});
    EXPECT_EQ(window.columns, (Numbers{0, 1})) << "what lies beside the grid is not there";
    EXPECT_EQ(window.rows.size(), 10u);
    EXPECT_TRUE(window_of(grid, RegionRecipe{20, 46, 21, 47}).columns.empty());
    EXPECT_TRUE(window_of(grid, RegionRecipe{6, 10, 7, 20}).rows.empty());
}

TEST(GridWindow, GoesRoundTheEarth) {
    const GridPlaces grid = places(-180, 90, 30, 12, 7);
    const GridWindow window = window_of(grid, RegionRecipe{160, -10, -160, 10});
    EXPECT_EQ(window.columns, (Numbers{11, 0, 1}));
    EXPECT_EQ(window.west_deg, 150);
    const GridWindow turned = window_of(places(0, 90, 30, 12, 7), RegionRecipe{-20, -10, 20, 10});
    EXPECT_EQ(turned.columns, (Numbers{11, 0, 1})) << "a grid that begins at Greenwich";
    EXPECT_EQ(turned.west_deg, -30);
    const GridWindow beyond = window_of(places(170, 10, 5, 5, 3), RegionRecipe{-179, -10, -176, 10});
    EXPECT_EQ(beyond.columns, (Numbers{2, 3})) << "a grid that reaches over the antimeridian";
    EXPECT_EQ(beyond.west_deg, -180);
}

TEST(GridWindow, CutsPlanes) {
    const GridPlaces grid = places(0, 10, 1, 4, 3);
    std::vector<float> plane(12);
    for (std::size_t n = 0; n < 12; ++n) plane[n] = static_cast<float>(n);
    EXPECT_EQ(cut(plane, grid, {{2, 0}, {1, 2}, 0, 0}), (std::vector<float>{6, 4, 10, 8}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_window
