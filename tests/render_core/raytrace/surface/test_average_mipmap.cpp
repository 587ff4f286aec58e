#include "render_core/raytrace/surface/average_mipmap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_average_mipmap {
namespace {

using test_support::Dice;
using test_support::HeldHeights;

template <class Height>
struct BuiltAverages {
    HeightGrid<Height> grid;
    std::vector<unsigned char> memory;
    base::Arena arena;
    AverageMipmap<Height> pyramid;

    explicit BuiltAverages(const HeldHeights<Height>& heights, std::uint32_t levels = 17)
        : grid(heights.grid()), memory(AverageMipmap<Height>::bytes_needed(grid.columns, grid.rows) + 1) {
        base::SerialWorkers alone;
        build(alone, levels);
    }
    void build(base::Workers& workers, std::uint32_t levels = 17) {
        arena = base::Arena(memory.data(), memory.size());
        EXPECT_TRUE(pyramid.start(grid, arena, levels));
        pyramid.build(workers);
    }
};

TEST(AverageMipmap, FlatStaysFlatOfEverySize) {
    for (const auto& [columns, rows] :
         {std::pair(2u, 2u), std::pair(3u, 2u), std::pair(17u, 17u), std::pair(1000u, 3u), std::pair(33u, 20u)}) {
        const HeldHeights<std::int16_t> heights(columns, rows, -7);
        const BuiltAverages<std::int16_t> built(heights);
        const auto& top = built.pyramid.level(built.pyramid.levels() - 1);
        EXPECT_EQ(top.columns, 2u);
        EXPECT_EQ(top.rows, 2u);
        for (double footprint = 0.3; footprint < 3000; footprint *= 1.7) {
            SurfacePoint point;
            ASSERT_TRUE(built.pyramid.find_surface(columns - 1, rows - 1, footprint, point));
            EXPECT_EQ(point.height, -7);
            EXPECT_EQ(point.slope_x, 0);
        }
    }
}

TEST(AverageMipmap, ALevelIsTheWeightedMeanOfTheOneBelow) {
    const auto heights = test_support::dice_heights<float>(9, 9, 1);
    const BuiltAverages<float> built(heights);
    double sum = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) sum += (2 - std::abs(i)) * (2 - std::abs(j)) * heights.grid().at(4 + i, 6 + j);
    EXPECT_NEAR(built.pyramid.level(1).at(2, 3), sum / 16, 1e-3);
}

TEST(AverageMipmap, APlaneKeepsItsSlopeAwayFromTheBorder) {
    const auto heights = HeldHeights<float>(65, 65).fill([](float x, float y) { return 3 * x - 2 * y; });
    const BuiltAverages<float> built(heights);
    for (double footprint = 1; footprint < 4.5; footprint += 0.37) {
        SurfacePoint point;
        ASSERT_TRUE(built.pyramid.find_surface(31.3, 29.8, footprint, point));
        EXPECT_NEAR(point.slope_x, 3, 1e-4);
        EXPECT_NEAR(point.slope_y, -2, 1e-4);
        EXPECT_NEAR(point.height, 3 * 31.3 - 2 * 29.8, 1e-3);
    }
}

TEST(AverageMipmap, BelowAPostItIsTheBilinearSurface) {
    const auto heights = test_support::dice_heights<std::int16_t>(20, 20, 2);
    const BuiltAverages<std::int16_t> built(heights);
    Dice dice(1);
    for (int n = 0; n < 1000; ++n) {
        const double x = dice.between(0, 19), y = dice.between(0, 19);
        SurfacePoint average, surface;
        ASSERT_TRUE(built.pyramid.find_surface(x, y, dice.unit(), average));
        ASSERT_TRUE(find_surface(heights.grid(), SurfaceSettings{}, x, y, surface));
        ASSERT_EQ(average.height, surface.height);
    }
}

TEST(AverageMipmap, GoesContinuouslyFromLevelToLevel) {
    const auto heights = test_support::dice_heights<float>(40, 40, 3);
    const BuiltAverages<float> built(heights);
    for (const double footprint : {1.0, 2.0, 4.0, 8.0}) {
        SurfacePoint below, above;
        ASSERT_TRUE(built.pyramid.find_surface(13.3, 22.2, footprint * (1 - 1e-9), below));
        ASSERT_TRUE(built.pyramid.find_surface(13.3, 22.2, footprint * (1 + 1e-9), above));
        EXPECT_NEAR(below.height, above.height, 1e-4);
    }
}

template <class Height>
void expect_bounds_hold(const HeldHeights<Height>& heights, int& beyond_posts) {
    const BuiltAverages<Height> built(heights);
    const CellBounds<Height> bounds = average_bounds(built.pyramid);
    std::vector<Height> highest(heights.columns), lowest(heights.columns);
    for (std::uint32_t row = 0; row + 1 < heights.rows; ++row) {
        bounds.row(bounds.context, built.grid, HeightBound::maximum, row, 0, heights.columns - 1, highest.data());
        bounds.row(bounds.context, built.grid, HeightBound::minimum, row, 0, heights.columns - 1, lowest.data());
        for (std::uint32_t column = 0; column + 1 < heights.columns; ++column) {
            Height most = HeightGrid<Height>::kVoid;
            for (std::uint32_t k = 0; k < 4; ++k) most = std::max(most, built.grid.at(column + k % 2, row + k / 2));
            for (int n = 0; n < 5 * 5 * 10; ++n) {
                SurfacePoint point;
                const double footprint = 0.7 * std::pow(1.9, n / 25);
                if (!built.pyramid.find_surface(column + n % 5 / 4.0, row + n / 5 % 5 / 4.0, footprint, point)) continue;
                if (highest[column] == no_surface<Height>(HeightBound::maximum)) continue;  // of a neighbour's side
                ASSERT_LE(point.height, highest[column]) << column << ' ' << row << ' ' << footprint;
                ASSERT_GE(point.height, lowest[column]);
                beyond_posts += point.height > most ? 1 : 0;
            }
        }
    }
}

TEST(AverageMipmap, BoundsHoldAtEveryFootprintWhereTheCellsOwnPostsDoNot) {
    int beyond_posts = 0;
    for (const auto& [columns, rows] :
         {std::pair(2u, 2u), std::pair(3u, 5u), std::pair(17u, 17u), std::pair(30u, 21u), std::pair(1000u, 3u)}) {
        auto heights = test_support::dice_heights<std::int16_t>(columns, rows, columns);
        Dice dice(rows);
        if (columns > 5)
            for (std::uint32_t n = 0; n < columns; ++n)
                heights.at(dice.below(columns), dice.below(rows)) = HeightGrid<std::int16_t>::kVoid;
        expect_bounds_hold(heights, beyond_posts);
        expect_bounds_hold(test_support::hilly_heights<float>(columns, rows, 4), beyond_posts);
    }
    EXPECT_GT(beyond_posts, 1000) << "a pyramid of maxima of the posts would let rays through";
}

TEST(AverageMipmap, AHoleStaysAHoleOfItsSize) {
    HeldHeights<float> heights(33, 33, 100.f);
    heights.at(16, 16) = HeightGrid<float>::kVoid;
    const BuiltAverages<float> built(heights);
    for (double footprint = 0.5; footprint < 40; footprint *= 1.5)
        for (double x = 14.25; x < 19; x += 0.5) {
            SurfacePoint point;
            const bool is_hole = x > 15 && x < 17;
            EXPECT_EQ(built.pyramid.find_surface(x, 16.4, footprint, point), !is_hole);
            if (is_hole) continue;
            EXPECT_EQ(point.height, 100) << "a void must not pull heights down";
        }
}

TEST(AverageMipmap, AnyNumberOfWorkersMakesTheSame) {
    const auto heights = test_support::dice_heights<std::int16_t>(130, 77, 5);
    const BuiltAverages<std::int16_t> alone(heights);
    for (const std::uint32_t count : {2u, 3u}) {
        platform::ThreadWorkersSettings settings;
        settings.concurrency = count;
        auto workers = platform::make_thread_workers(settings);
        BuiltAverages<std::int16_t> shared(heights);
        shared.build(*workers.value());
        EXPECT_EQ(alone.memory, shared.memory);
    }
}

TEST(AverageMipmap, SaysWhereTheArenaHasNoRoom) {
    const HeldHeights<float> heights(50, 50);
    std::vector<unsigned char> memory(AverageMipmap<float>::bytes_needed(50, 50) / 2);
    base::Arena arena(memory.data(), memory.size());
    AverageMipmap<float> pyramid;
    EXPECT_FALSE(pyramid.start(heights.grid(), arena));
}

}  // namespace
}  // namespace tedavis::raytrace::test_average_mipmap
