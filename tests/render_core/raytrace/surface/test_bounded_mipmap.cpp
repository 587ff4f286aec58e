// HeightMipmap over other surfaces than its posts'.
#include <gtest/gtest.h>

#include <vector>

#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/surface/average_mipmap.hpp"
#include "render_core/raytrace/surface/surface_bounds.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_bounded_mipmap {
namespace {

using test_support::Dice;

template <class Height>
struct BoundedMipmap {
    std::vector<unsigned char> memory;
    base::Arena arena;
    HeightMipmap<Height> mipmap;
    base::SerialWorkers alone;

    BoundedMipmap(const HeightGrid<Height>& grid, const CellBounds<Height>& cells, HeightBound bound)
        : memory(HeightMipmap<Height>::bytes_needed(grid.columns, grid.rows)),
          arena(memory.data(), memory.size()),
          mipmap(bound) {
        EXPECT_TRUE(mipmap.start(grid, arena, cells));
        mipmap.build(alone);
    }
};

TEST(BoundedMipmap, NodesOfEveryLevelBoundTheSurfaceBelow) {
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    for (const auto& [columns, rows] : {std::pair(2u, 2u), std::pair(3u, 17u), std::pair(40u, 23u), std::pair(1000u, 3u)}) {
        const auto heights = test_support::dice_heights<std::int16_t>(columns, rows, rows);
        const BoundedMipmap<std::int16_t> built(heights.grid(), surface_bounds<std::int16_t>(settings), HeightBound::maximum);
        const BoundedMipmap<std::int16_t> of_posts(heights.grid(), {}, HeightBound::maximum);
        int beyond_posts = 0;
        for (std::uint32_t row = 0; row + 1 < rows; ++row)
            for (std::uint32_t column = 0; column + 1 < columns; ++column) {
                const CellPatch patch = cell_patch(heights.grid(), settings, column, row);
                for (int n = 0; n < 81; ++n) {
                    const double height = patch.at(n % 9 / 8.0, n / 9 / 8.0).height;
                    beyond_posts += height > of_posts.mipmap.level(0).at(column, row) ? 1 : 0;
                    for (std::uint32_t level = 0; level < built.mipmap.levels(); ++level)
                        ASSERT_LE(height, built.mipmap.level(level).at(column >> level, row >> level));
                }
            }
        EXPECT_TRUE(columns == 2 || beyond_posts > 0);
    }
}

template <class Height>
void expect_equal_levels(const HeightMipmap<Height>& a, const HeightMipmap<Height>& b) {
    for (std::uint32_t n = 0; n < a.levels(); ++n) {
        const auto one = a.level(n), other = b.level(n);
        for (std::uint32_t row = 0; row < one.rows; ++row)
            for (std::uint32_t column = 0; column < one.columns; ++column)
                ASSERT_EQ(one.at(column, row), other.at(column, row)) << n;
    }
}

TEST(BoundedMipmap, AnUpdateReachesAsFarAsTheSurfaceDoes) {
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    Dice dice(4);
    for (int n = 0; n < 60; ++n) {
        auto heights = test_support::dice_heights<std::int16_t>(37, 29, 8);
        const HeightBound bound = n % 2 == 0 ? HeightBound::maximum : HeightBound::minimum;
        BoundedMipmap<std::int16_t> built(heights.grid(), surface_bounds<std::int16_t>(settings), bound);
        PostRegion region{dice.below(37), dice.below(29), 0, 0};
        region.end_column = std::min(region.first_column + 1 + dice.below(5), 37u);
        region.end_row = std::min(region.first_row + 1 + dice.below(5), 29u);
        for (std::uint32_t row = region.first_row; row < region.end_row; ++row)
            for (std::uint32_t column = region.first_column; column < region.end_column; ++column)
                heights.at(column, row) =
                    n % 5 == 0 ? HeightGrid<std::int16_t>::kVoid : static_cast<std::int16_t>(dice.between(-2000, 2000));
        built.mipmap.update(region);
        const BoundedMipmap<std::int16_t> anew(heights.grid(), surface_bounds<std::int16_t>(settings), bound);
        expect_equal_levels(built.mipmap, anew.mipmap);
    }
}

TEST(BoundedMipmap, AnUpdateReachesAsFarAsAverages) {
    auto heights = test_support::dice_heights<float>(70, 50, 9);
    std::vector<unsigned char> memory(AverageMipmap<float>::bytes_needed(70, 50));
    base::Arena arena(memory.data(), memory.size());
    AverageMipmap<float> averages;
    ASSERT_TRUE(averages.start(heights.grid(), arena, 4));
    base::SerialWorkers alone;
    averages.build(alone);
    BoundedMipmap<float> built(heights.grid(), average_bounds(averages), HeightBound::maximum);
    heights.at(31, 30) = 90000;
    averages.build(alone);
    built.mipmap.update({31, 30, 32, 31});
    const BoundedMipmap<float> anew(heights.grid(), average_bounds(averages), HeightBound::maximum);
    expect_equal_levels(built.mipmap, anew.mipmap);
}

}  // namespace
}  // namespace tedavis::raytrace::test_bounded_mipmap
