#include "host_sim/terrain_builder/fractal_terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render_core/base/hash.hpp"
#include "tests/support/terrain/fractal_square.hpp"

namespace tedavis::host_sim::test_fractal_terrain {
namespace {

using test_support::fractal_square;
using test_support::FractalSquare;

TEST(FractalTerrain, APostHasOneHeightWhateverIsAskedWithIt) {
    const FractalTerrain terrain(7);
    for (const std::int32_t origin : {0, 100'000, -5'000, 1 << 24}) {
        const FractalSquare whole = fractal_square(97, 7, origin, origin / 2);
        for (const std::uint32_t width : {1u, 13u, 96u}) {
            for (std::uint32_t j = 0; j < 97; j += 5) {
                for (std::uint32_t i = 0; i + width <= 97; i += width) {
                    std::vector<float> part(width);
                    terrain.read(origin + static_cast<std::int32_t>(i), origin / 2 + static_cast<std::int32_t>(j), width, 1,
                                 part);
                    for (std::uint32_t n = 0; n < width; ++n)
                        ASSERT_EQ(part[n], whole.at(i + n, j)) << origin << " " << i << "," << j;
                }
            }
        }
    }
}

/// What the first machine computed; the same operations in the same order give it everywhere.
TEST(FractalTerrain, HasTheSameBitsOnEveryMachine) {
    const FractalSquare s = fractal_square(64, 1, 1000, 2000);
    base::Fnv1a64 hash;
    hash.add(s.height_m.data(), s.height_m.size() * sizeof(float));
    EXPECT_EQ(hash.value(), 204170924434169886u);
}

TEST(FractalTerrain, SeedsGiveOtherTerrainOfTheSameKind) {
    const FractalSquare a = fractal_square(400, 1, 0, 0), b = fractal_square(400, 2, 0, 0);
    double sum_a = 0, sum_b = 0, sum_ab = 0, sum_aa = 0, sum_bb = 0;
    for (std::size_t n = 0; n < a.height_m.size(); ++n) {
        const double x = a.height_m[n], y = b.height_m[n];
        sum_a += x, sum_b += y, sum_ab += x * y, sum_aa += x * x, sum_bb += y * y;
    }
    const auto count = static_cast<double>(a.height_m.size());
    const double covariance = sum_ab / count - sum_a / count * sum_b / count;
    const double spread =
        std::sqrt((sum_aa / count - sum_a * sum_a / count / count) * (sum_bb / count - sum_b * sum_b / count / count));
    EXPECT_LT(std::abs(covariance) / spread, 0.5);
    EXPECT_GT(spread, 100 * 100);
}

TEST(FractalTerrain, LiesBetweenTheSeaAndTheHighestHeight) {
    const FractalTerrain terrain(3);
    std::size_t sea = 0, high = 0, posts = 0;
    float height_m[1];
    for (std::int32_t j = 0; j < 300; ++j) {
        for (std::int32_t i = 0; i < 300; ++i, ++posts) {
            terrain.read(i * 97, j * 89, 1, 1, height_m);
            ASSERT_GE(height_m[0], 0);
            ASSERT_LT(height_m[0], 4000);
            sea += height_m[0] == 0 ? 1 : 0;
            high += height_m[0] > 2500 ? 1 : 0;
        }
    }
    EXPECT_GT(sea, posts / 100);
    EXPECT_LT(sea, posts / 5);
    EXPECT_GT(high, posts / 100);
}

/// Mean square of the second difference over a distance, on land.
double bending(const FractalSquare& s, std::uint32_t distance) {
    double sum = 0;
    int count = 0;
    for (std::uint32_t j = 0; j < s.posts; ++j) {
        for (std::uint32_t i = distance; i + distance < s.posts; ++i) {
            const double west = s.at(i - distance, j), here = s.at(i, j), east = s.at(i + distance, j);
            if (west == 0 || here == 0 || east == 0) continue;
            sum += (west + east - 2 * here) * (west + east - 2 * here);
            ++count;
        }
    }
    return sum / count;
}

// Amplitudes proportional to wavelengths make a surface whose bending grows with the distance squared: its Hurst exponent
// is about one, as that of the Alps at these distances. White noise (the control) bends equally at every distance.
TEST(FractalTerrain, BendsMoreOverLongerDistancesAsAFractionalSurfaceDoes) {
    FractalSquare terrain = fractal_square(700, 3, 0, 0);
    for (std::uint32_t distance = 2; distance <= 32; distance *= 2) {
        const double growth = bending(terrain, 2 * distance) / bending(terrain, distance);
        EXPECT_GT(growth, 3.0) << distance;
        EXPECT_LT(growth, 6.5) << distance;
    }
    std::uint64_t state = 1;
    for (float& h : terrain.height_m) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        h = static_cast<float>(1 + (state >> 40));
    }
    EXPECT_NEAR(bending(terrain, 16) / bending(terrain, 8), 1.0, 0.1);
}

// No direction and no row is special: lattices that coincide would show as posts that are smoother than others.
TEST(FractalTerrain, EveryRowAndColumnIsEquallyRough) {
    const FractalSquare s = fractal_square(512, 5, 0, 0);
    double even = 0, odd = 0, along = 0, across = 0;
    for (std::uint32_t j = 1; j < 511; ++j) {
        for (std::uint32_t i = 1; i < 511; ++i) {
            const double x = double{s.at(i - 1, j)} + s.at(i + 1, j) - 2.0 * s.at(i, j),
                         y = double{s.at(i, j - 1)} + s.at(i, j + 1) - 2.0 * s.at(i, j);
            (i % 2 == 0 ? even : odd) += x * x;
            along += x * x;
            across += y * y;
        }
    }
    EXPECT_NEAR(even / odd, 1, 0.1);
    EXPECT_NEAR(along / across, 1, 0.25);
}

}  // namespace
}  // namespace tedavis::host_sim::test_fractal_terrain
