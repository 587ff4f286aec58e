#include "render_core/raytrace/surface/surface_bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_surface_bounds {
namespace {

using test_support::Dice;
using test_support::HeldHeights;

constexpr SurfaceKind kKinds[] = {SurfaceKind::two_triangles, SurfaceKind::bilinear, SurfaceKind::bicubic,
                                  SurfaceKind::approximate_bicubic};

struct Violations {
    int of_bounds = 0, of_posts = 0;  ///< samples beyond the bound, and beyond the four posts
    double worst_beyond_posts = 0, slack = 0;
    int cells = 0;
};

template <class Height>
struct BoundedCells {
    std::vector<unsigned char> memory;
    base::Arena arena;
    HeightMipmap<Height> mipmap;
    BoundedCells(const HeightGrid<Height>& grid, const SurfaceSettings& settings, HeightBound bound)
        : memory(HeightMipmap<Height>::bytes_needed(grid.columns, grid.rows)),
          arena(memory.data(), memory.size()),
          mipmap(bound) {
        EXPECT_TRUE(mipmap.start(grid, arena, surface_bounds<Height>(settings)));
        base::SerialWorkers alone;
        mipmap.build(alone);
    }
    [[nodiscard]] Height at(std::uint32_t column, std::uint32_t row) const { return mipmap.level(0).at(column, row); }
};

/// 64 x 64 samples a cell, its sides included.
template <class Height>
Violations sampled(const HeightGrid<Height>& grid, const SurfaceSettings& settings, int samples = 64) {
    Violations found;
    const BoundedCells<Height> maxima(grid, settings, HeightBound::maximum), minima(grid, settings, HeightBound::minimum);
    for (std::uint32_t row = 0; row + 1 < grid.rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < grid.columns; ++column) {
            const Height highest = maxima.at(column, row), lowest = minima.at(column, row);
            const CellPatch patch = cell_patch(grid, settings, column, row);
            if (!patch.has_surface) {
                EXPECT_EQ(highest, no_surface<Height>(HeightBound::maximum));
                EXPECT_EQ(lowest, no_surface<Height>(HeightBound::minimum));
                continue;
            }
            const double most = std::max(std::max(grid.at(column, row), grid.at(column + 1, row)),
                                         std::max(grid.at(column, row + 1), grid.at(column + 1, row + 1)));
            double top = -1e30;
            for (int n = 0; n < samples * samples; ++n) {
                const CellPlace place{column, row, n % samples / (samples - 1.0), n / samples / (samples - 1.0)};
                const double height = surface_on(patch, settings.micro, place).height;
                top = std::max(top, height);
                found.of_bounds += height > highest || height < lowest ? 1 : 0;
            }
            found.of_posts += top > most ? 1 : 0;
            found.worst_beyond_posts = std::max(found.worst_beyond_posts, top - most);
            found.slack += highest - top;
            ++found.cells;
        }
    }
    return found;
}

TEST(SurfaceBounds, HoldForEverySurfaceOnGridsOfManySizes) {
    for (const auto& [columns, rows] :
         {std::pair(2u, 2u), std::pair(3u, 2u), std::pair(2u, 17u), std::pair(17u, 17u), std::pair(23u, 5u)})
        for (const SurfaceKind kind : kKinds) {
            SurfaceSettings settings;
            settings.kind = kind;
            EXPECT_EQ(sampled(test_support::dice_heights<std::int16_t>(columns, rows, columns).grid(), settings).of_bounds, 0);
            EXPECT_EQ(sampled(test_support::dice_heights<float>(columns, rows, rows).grid(), settings).of_bounds, 0);
        }
}

TEST(SurfaceBounds, HoldOnALongGridWithVoids) {
    auto heights = test_support::hilly_heights<std::int16_t>(1000, 3, 8);
    Dice dice(5);
    for (int n = 0; n < 150; ++n) heights.at(dice.below(1000), dice.below(3)) = HeightGrid<std::int16_t>::kVoid;
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    const Violations found = sampled(heights.grid(), settings);
    EXPECT_EQ(found.of_bounds, 0);
    EXPECT_GT(found.cells, 1000);
}

TEST(SurfaceBounds, FourPostsAreNoBoundOfASmoothSurface) {
    const auto heights = test_support::hilly_heights<std::int16_t>(60, 60, 9);
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    const Violations found = sampled(heights.grid(), settings);
    EXPECT_EQ(found.of_bounds, 0);
    EXPECT_GT(found.of_posts, found.cells / 20);
    EXPECT_GT(found.worst_beyond_posts, 1);
    EXPECT_LT(found.slack / found.cells, 2) << "bounds that are far off would be true as well";
}

TEST(SurfaceBounds, ARidgeOvershootsByTheKnownShare) {
    // 1-D: 0 1 1 0 rises to 1.125 between the two; both ways 1.265625 above the range 0..1.
    const auto heights = HeldHeights<float>(4, 4).fill([](int x, int y) { return x % 3 != 0 && y % 3 != 0 ? 1000 : 0; });
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    EXPECT_NEAR(cell_patch(heights.grid(), settings, 1, 1).at(0.5, 0.5).height, 1265.625, 1e-9);
    float bound = 0;
    surface_bounds<float>(settings).row(&settings, heights.grid(), HeightBound::maximum, 1, 1, 2, &bound - 1);
    EXPECT_GT(bound, 1265.625f);
    EXPECT_LT(bound, 1400.f);
}

TEST(SurfaceBounds, HoldWithMicroStructure) {
    HeldHeights<std::int16_t> tile = test_support::dice_heights<std::int16_t>(16, 16, 11, 900);
    for (const SurfaceKind kind : kKinds)
        for (const MicroKind micro : {MicroKind::noise, MicroKind::relief}) {
            SurfaceSettings settings;
            settings.kind = kind;
            settings.micro.kind = micro;
            settings.micro.noise.amplitude = settings.micro.relief.amplitude = 7.3;
            settings.micro.noise.frequency = 5;
            settings.micro.relief.tile = tile.grid();
            settings.micro.relief.full_scale = 600;  // some of it is cut
            const Violations found = sampled(test_support::dice_heights<float>(12, 9, 12, 50).grid(), settings);
            EXPECT_EQ(found.of_bounds, 0);
            EXPECT_GT(found.of_posts, 0);
        }
}

TEST(SurfaceBounds, RoundOutwards) {
    EXPECT_EQ(rounded_up<std::int16_t>(3.0), 3);
    EXPECT_EQ(rounded_up<std::int16_t>(3.0000001), 4);
    EXPECT_EQ(rounded_down<std::int16_t>(-3.0000001), -4);
    EXPECT_EQ(rounded_up<std::int16_t>(-40000), -32767) << "never what stands for no height";
    Dice dice(6);
    for (int n = 0; n < 10000; ++n) {
        const double height = dice.between(-9000, 9000);
        const float up = rounded_up<float>(height), down = rounded_down<float>(height);
        ASSERT_GE(double{up}, height);
        ASSERT_LE(double{down}, height);
        ASSERT_LE(up, std::nextafter(down, 1e9f));
    }
}

TEST(SurfaceBounds, WhatLeavesTheRangeOfHeightsIsToldBefore) {
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    const auto high = test_support::dice_heights<std::int16_t>(8, 8, 2, 32000);
    EXPECT_FALSE(surface_fits(high.grid(), settings));
    EXPECT_TRUE(surface_fits(test_support::dice_heights<float>(8, 8, 2, 32000).grid(), settings));
    EXPECT_TRUE(surface_fits(test_support::dice_heights<std::int16_t>(8, 8, 2, 9000).grid(), settings));
    settings.kind = SurfaceKind::bilinear;
    EXPECT_TRUE(surface_fits(high.grid(), settings));
    settings.micro.kind = MicroKind::noise;
    settings.micro.noise.amplitude = 3000;
    EXPECT_FALSE(surface_fits(high.grid(), settings));
    const HeldHeights<std::int16_t> nothing(3, 3, HeightGrid<std::int16_t>::kVoid);
    EXPECT_TRUE(surface_fits(nothing.grid(), settings));
}

TEST(SurfaceBounds, ControlHeightsKeepWithinTheToldRange) {
    // Random corners, borders and voids of the two heights 0 and 1: the extremes of what posts can do.
    Dice dice(7);
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    double highest = 0;
    for (int n = 0; n < 200000; ++n) {
        const auto heights = HeldHeights<float>(4, 4).fill([&](std::uint32_t, std::uint32_t) {
            const std::uint32_t face = dice.below(9);
            return face == 8 ? HeightGrid<float>::kVoid : static_cast<float>(face % 2);
        });
        const CellPatch patch = cell_patch(heights.grid(), settings, dice.below(3), dice.below(3));
        if (patch.has_surface) highest = std::max(highest, patch.range().highest);
    }
    EXPECT_GT(highest, 1.3);
    EXPECT_LE(highest, 1.5);
}

}  // namespace
}  // namespace tedavis::raytrace::test_surface_bounds
