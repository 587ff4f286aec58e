#include "host_sim/terrain_builder/fractal_terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/terrain_builder/raster.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tedavis::host_sim {
namespace {

TEST(FractalTerrain, HasTheSizeThatWasAskedForAndRisesFromZero) {
    for (const std::uint32_t posts : {3u, 4u, 17u, 100u, 257u, 300u}) {
        const FractalTerrain terrain = make_fractal_terrain(posts, 7);
        ASSERT_EQ(terrain.posts, posts);
        ASSERT_EQ(terrain.height_m.size(), std::size_t{posts} * posts);
        const auto [lowest, highest] = std::minmax_element(terrain.height_m.begin(), terrain.height_m.end());
        EXPECT_EQ(*lowest, 0);
        EXPECT_GT(*highest, 0);
        EXPECT_LE(*highest, 4000.01f);
    }
}

TEST(FractalTerrain, EqualSeedsGiveEqualBitsAndOthersDoNot) {
    EXPECT_EQ(make_fractal_terrain(129, 1).height_m, make_fractal_terrain(129, 1).height_m);
    EXPECT_NE(make_fractal_terrain(129, 1).height_m, make_fractal_terrain(129, 2).height_m);
}

/// Mean square of the second difference over a distance, away from the border.
double bending(const FractalTerrain& terrain, std::uint32_t distance) {
    double sum = 0;
    int count = 0;
    for (std::uint32_t j = 0; j < terrain.posts; ++j) {
        for (std::uint32_t i = distance; i + distance < terrain.posts; ++i, ++count) {
            const double bend = double{terrain.at(i - distance, j)} + terrain.at(i + distance, j) - 2.0 * terrain.at(i, j);
            sum += bend * bend;
        }
    }
    return sum / count;
}

// Halving displacements with halved steps make a surface whose bending grows with the distance squared: its Hurst exponent
// is one. White noise (the control) bends equally at every distance.
TEST(FractalTerrain, BendsMoreOverLongerDistancesAsAFractionalSurfaceDoes) {
    const FractalTerrain terrain = make_fractal_terrain(513, 3);
    for (std::uint32_t distance = 2; distance <= 32; distance *= 2) {
        const double growth = bending(terrain, 2 * distance) / bending(terrain, distance);
        EXPECT_GT(growth, 2.0) << distance;
        EXPECT_LT(growth, 6.0) << distance;
    }
    FractalTerrain noise = terrain;
    std::uint64_t state = 1;
    for (float& h : noise.height_m) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        h = static_cast<float>(state >> 40);
    }
    EXPECT_NEAR(bending(noise, 16) / bending(noise, 8), 1.0, 0.1);
}

TEST(FractalTerrain, SaysHowFarItIsAndStopsWhenToldTo) {
    std::uint64_t last = 0, total = 0;
    (void)make_fractal_terrain(129, 1, [&](std::uint64_t done, std::uint64_t all) {
        EXPECT_GT(done, last);
        last = done;
        total = all;
    });
    EXPECT_LE(last, total);
    struct Stop {};
    EXPECT_THROW((void)make_fractal_terrain(129, 1, [](std::uint64_t, std::uint64_t) { throw Stop{}; }), Stop);
}

// Oracle: the reader of any raster.
TEST(FractalTerrain, TheRasterFileHoldsItsPostsAtTheirPlace) {
    const FractalTerrain terrain = make_fractal_terrain(100, 5);
    const test_support::TemporaryFolder folder;
    const Raster raster = load_rasters({folder.write("f.tif", fractal_geotiff(terrain))}, {});
    ASSERT_EQ(raster.columns, 100u);
    ASSERT_EQ(raster.rows, 100u);
    EXPECT_FALSE(raster.resampled);
    EXPECT_NEAR(raster.west_deg, kFractalWest_deg, 1e-12);
    EXPECT_NEAR(raster.north_deg, kFractalNorth_deg, 1e-12);
    EXPECT_NEAR(raster.step_lon_deg, kFractalStep_deg, 1e-15);
    for (std::uint32_t j = 0; j < 100; ++j)
        for (std::uint32_t i = 0; i < 100; ++i) ASSERT_EQ(raster.height_m[raster.at(i, j)], terrain.at(i, j));
}

}  // namespace
}  // namespace tedavis::host_sim
