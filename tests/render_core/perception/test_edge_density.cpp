#include "render_core/perception/edge_density.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::perception::test_edge_density {
namespace {

struct Edges {
    Edges(int width_, int height_) : width(width_), height(height_), bytes(pixels_of(width, height)) {
        for (std::size_t n = 0; n < bytes.size(); ++n)
            bytes[n] = test_support::scrambled(static_cast<std::uint32_t>(n), 3, 1) % 5 == 0 ? 255 : 0;
    }
    [[nodiscard]] EdgeView view() const { return {bytes, width, height}; }
    int width, height;
    std::vector<std::uint8_t> bytes;
};

TEST(EdgeDensity, IsTheShareOfInnerPixels) {
    Edges edges(5, 4);
    edges.bytes.assign(edges.bytes.size(), 0);
    edges.bytes[2 * 5 + 3] = 1;
    EXPECT_DOUBLE_EQ(edge_density(edges.view()), 1.0 / 6);
    edges.bytes[0] = edges.bytes[4] = edges.bytes[19] = 255;
    EXPECT_DOUBLE_EQ(edge_density(edges.view()), 1.0 / 6) << "the outermost pixels do not count";
    edges.bytes.assign(edges.bytes.size(), 255);
    EXPECT_DOUBLE_EQ(edge_density(edges.view()), 1);
}

TEST(EdgeDensity, PicturesWithoutInnerPixelsHaveNone) {
    for (const int width : {1, 2, 3})
        for (const int height : {1, 2}) {
            Edges edges(width, height);
            edges.bytes.assign(edges.bytes.size(), 255);
            EXPECT_EQ(edge_density(edges.view()), 0);
            std::vector<double> densities(48, 7);
            ASSERT_TRUE(region_densities(edges.view(), {}, densities));
            EXPECT_EQ(densities, std::vector<double>(48, 0));
        }
}

TEST(EdgeDensity, RegionsPartTheInnerPixels) {
    for (const RegionGrid grid : {RegionGrid{8, 6}, RegionGrid{1, 1}, RegionGrid{64, 64}, RegionGrid{7, 3}}) {
        const int width = 203, height = 101;
        std::vector<int> times(pixels_of(width, height), 0);
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const PixelRegion region = region_of(grid, column, row, width, height);
                for (int y = region.top; y < region.bottom; ++y)
                    for (int x = region.left; x < region.right; ++x) ++times[pixels_of(width, y) + static_cast<std::size_t>(x)];
            }
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_EQ(times[pixels_of(width, y) + static_cast<std::size_t>(x)],
                          x > 0 && y > 0 && x < width - 1 && y < height - 1 ? 1 : 0);
    }
}

TEST(EdgeDensity, CountsOfPartsAddUpToTheWhole) {
    const Edges edges(211, 97);
    const RegionGrid grid{9, 5};
    std::uint64_t parts = 0;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            parts += count_edges(edges.view(), region_of(grid, column, row, edges.width, edges.height));
    EXPECT_EQ(parts, count_edges(edges.view(), inner_region(edges.width, edges.height)));
    EXPECT_GT(parts, 3000u);
}

TEST(EdgeDensity, ARegionIsMeasuredAlone) {
    Edges edges(82, 62);
    edges.bytes.assign(edges.bytes.size(), 0);
    for (int y = 21; y < 31; ++y)
        for (int x = 31; x < 36; ++x) edges.bytes[pixels_of(82, y) + static_cast<std::size_t>(x)] = 255;
    std::vector<double> densities(48, 7);
    ASSERT_TRUE(region_densities(edges.view(), {}, densities));
    EXPECT_DOUBLE_EQ(densities[2 * 8 + 3], 0.5);
    EXPECT_DOUBLE_EQ(std::accumulate(densities.begin(), densities.end(), 0.0), 0.5);
}

TEST(EdgeDensity, RefusesGridsThatDoNotFit) {
    const Edges edges(20, 20);
    std::vector<double> densities(48, 7);
    EXPECT_FALSE(region_densities(edges.view(), {0, 6}, densities));
    EXPECT_FALSE(region_densities(edges.view(), {65, 1}, densities));
    EXPECT_FALSE(region_densities(edges.view(), {7, 7}, densities));
    EXPECT_EQ(densities, std::vector<double>(48, 7));
}

TEST(EdgeDensity, RegionsBeyondThePictureAreCut) {
    const Edges edges(20, 20);
    EXPECT_EQ(count_edges(edges.view(), {-5, -5, 25, 25}), count_edges(edges.view(), {0, 0, 20, 20}));
    EXPECT_EQ(count_edges(edges.view(), {30, 30, 40, 40}), 0u);
}

}  // namespace
}  // namespace tedavis::perception::test_edge_density
