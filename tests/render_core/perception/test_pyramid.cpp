#include "render_core/perception/pyramid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/render_core/perception/held_plane.hpp"

namespace tedavis::perception::test_pyramid {
namespace {

using test_support::Field;
using test_support::HeldPlane;
using test_support::noise_plane;

const std::pair<int, int> kSizes[] = {{1, 1}, {2, 3}, {1, 9}, {16, 16}, {17, 12}, {63, 5}};

TEST(Pyramid, AReducedLevelIsTheWeightedMean) {
    for (const auto& [width, height] : kSizes) {
        const HeldPlane fine = noise_plane(width, height, 1);
        HeldPlane coarse((width + 1) / 2, (height + 1) / 2, 99);
        std::vector<float> scratch(reduction_scratch(width));
        halve(fine.plane, coarse.plane, scratch);
        const Field expected = test_support::reference_halved(fine.field());
        for (std::size_t n = 0; n < coarse.values.size(); ++n) ASSERT_NEAR(coarse.values[n], expected.values[n], 1e-6) << width;
    }
}

TEST(Pyramid, AnExpandedRowIsInterpolated) {
    for (const auto& [width, height] : kSizes)
        for (int levels = 1; levels <= kMaxExpansion; ++levels) {
            const HeldPlane coarse = noise_plane(level_side(width, levels), level_side(height, levels), 2);
            const Field field = coarse.field();
            std::vector<float> scratch(expansion_scratch(width));
            for (int y = 0; y < height; ++y) {
                const float* row = expanded_row(coarse.plane, levels, y, width, scratch);
                for (int x = 0; x < width; ++x) {
                    const double scale = 1 << levels;
                    ASSERT_NEAR(row[x], field.between((x + 0.5) / scale, (y + 0.5) / scale), 1e-6) << width << ' ' << levels;
                }
            }
        }
}

TEST(Pyramid, WhatIsFlatStaysFlat) {
    const HeldPlane flat(37, 23, 0.3f);
    HeldPlane coarse(19, 12);
    std::vector<float> scratch(reduction_scratch(37) + expansion_scratch(37));
    halve(flat.plane, coarse.plane, scratch);
    for (const float value : coarse.values) EXPECT_NEAR(value, 0.3f, 1e-7);
    EXPECT_NEAR(expanded_row(coarse.plane, 1, 5, 37, scratch)[36], 0.3f, 1e-7);
    HeldPlane softened(37, 23, 0.3f);
    soften(softened.plane, 5.0f / 64, scratch);
    for (const float value : softened.values) EXPECT_NEAR(value, 0.3f, 1e-7);
}

TEST(Pyramid, SofteningIsAMeanOfNeighbours) {
    for (const auto& [width, height] : kSizes) {
        HeldPlane plane = noise_plane(width, height, 4);
        const Field before = plane.field();
        std::vector<float> scratch(softening_scratch(width));
        soften(plane.plane, 0.1f, scratch);
        const double weights[3] = {0.1, 0.8, 0.1};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                double sum = 0;
                for (int v = -1; v <= 1; ++v)
                    for (int u = -1; u <= 1; ++u) sum += weights[u + 1] * weights[v + 1] * before(x + u, y + v);
                ASSERT_NEAR(plane.plane.row(y)[x], sum, 1e-6) << width;
            }
    }
}

/// Of the answer to a single pixel.
double variance(const HeldPlane& plane) {
    double sum = 0, moment = 0, square = 0;
    for (int y = 0; y < plane.plane.height; ++y)
        for (int x = 0; x < plane.plane.width; ++x) {
            const double value = plane.plane.row(y)[x];
            sum += value;
            moment += value * x;
            square += value * x * x;
        }
    return square / sum - moment / sum * (moment / sum);
}

// Averaged over all places of the pixel within a block: what the two ways to a quarter of the size spread it over.
TEST(Pyramid, SoftenedMeansOfBlocksAreAsWideAsReducedLevels) {
    std::vector<float> scratch(1000);
    double reduced = 0, softened = 0;
    for (int place = 0; place < 4; ++place) {
        HeldPlane full(64, 64), half(32, 32), quarter(16, 16), means(16, 16);
        full.plane.row(32)[32 + place] = 1;
        means.plane.row(8)[8] = 1;
        halve(full.plane, half.plane, scratch);
        halve(half.plane, quarter.plane, scratch);
        soften(means.plane, 5.0f / 64, scratch);
        const double middle = 8 + (place - 1.5) / 4;
        const auto spread = [&](const HeldPlane& plane) {
            double sum = 0, mean = 0;
            for (int x = 0; x < 16; ++x) {
                sum += plane.plane.row(8)[x];
                mean += plane.plane.row(8)[x] * (x - middle) * (x - middle);
            }
            return mean / sum;
        };
        reduced += spread(quarter) / 4;
        softened += spread(means) / 4;
        EXPECT_GT(variance(quarter), 0.1);
    }
    EXPECT_NEAR(softened, reduced, 0.02 * reduced);
}

}  // namespace
}  // namespace tedavis::perception::test_pyramid
