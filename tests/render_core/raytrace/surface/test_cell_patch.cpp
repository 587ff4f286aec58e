#include "render_core/raytrace/surface/cell_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_cell_patch {
namespace {

using test_support::Dice;

constexpr SurfaceKind kKinds[] = {SurfaceKind::two_triangles, SurfaceKind::bilinear, SurfaceKind::bicubic,
                                  SurfaceKind::approximate_bicubic};

SurfaceSettings settings_of(SurfaceKind kind, std::uint32_t subdivisions = 5) {
    SurfaceSettings settings;
    settings.kind = kind;
    settings.subdivisions = subdivisions;
    return settings;
}

TEST(CellPatch, EveryKindGoesThroughThePosts) {
    const auto heights = test_support::dice_heights<std::int16_t>(7, 6, 1);
    for (const SurfaceKind kind : kKinds)
        for (std::uint32_t row = 0; row < 5; ++row)
            for (std::uint32_t column = 0; column < 6; ++column) {
                const CellPatch patch = cell_patch(heights.grid(), settings_of(kind), column, row);
                for (std::uint32_t k = 0; k < 4; ++k)
                    ASSERT_EQ(patch.at(k % 2, k / 2).height, heights.grid().at(column + k % 2, row + k / 2));
            }
}

TEST(CellPatch, NeighboursShareTheirSidesBitForBit) {
    const auto heights = test_support::dice_heights<float>(12, 12, 2);
    Dice dice(1);
    for (const SurfaceKind kind : kKinds)
        for (int n = 0; n < 4000; ++n) {
            const std::uint32_t column = dice.below(10), row = dice.below(10);
            const double t = dice.unit();
            const CellPatch here = cell_patch(heights.grid(), settings_of(kind), column, row);
            const CellPatch right = cell_patch(heights.grid(), settings_of(kind), column + 1, row);
            const CellPatch below = cell_patch(heights.grid(), settings_of(kind), column, row + 1);
            ASSERT_EQ(here.at(1, t).height, right.at(0, t).height) << static_cast<int>(kind);
            ASSERT_EQ(here.at(t, 1).height, below.at(t, 0).height) << static_cast<int>(kind);
        }
}

TEST(CellPatch, TrianglesAreDividedFromTheUpperRightToTheLowerLeft) {
    const auto heights =
        test_support::HeldHeights<std::int16_t>(2, 2).fill([](int x, int y) { return x == 1 && y == 0 ? 9 : 0; });
    const CellPatch triangles = cell_patch(heights.grid(), settings_of(SurfaceKind::two_triangles), 0, 0);
    EXPECT_DOUBLE_EQ(triangles.at(0.5, 0.5).height, 4.5);
    EXPECT_DOUBLE_EQ(triangles.at(0.25, 0.25).height, 2.25);
    EXPECT_DOUBLE_EQ(triangles.at(0.75, 0.75).height, 2.25);
    const CellPatch bilinear = cell_patch(heights.grid(), settings_of(SurfaceKind::bilinear), 0, 0);
    EXPECT_DOUBLE_EQ(bilinear.at(0.5, 0.5).height, 2.25);
}

TEST(CellPatch, SlopesAreDifferencesOfHeights) {
    const auto heights = test_support::dice_heights<std::int16_t>(6, 6, 3);
    Dice dice(2);
    constexpr double kStep = 1e-6;
    for (const SurfaceKind kind : kKinds)
        for (int n = 0; n < 2000; ++n) {
            const CellPatch patch = cell_patch(heights.grid(), settings_of(kind), dice.below(5), dice.below(5));
            const double u = dice.between(0.01, 0.99), v = dice.between(0.01, 0.99);
            const auto is_near_crease = [&](double a, double b) {
                const double parts = 5;
                return std::abs(a + b - 1) < 1e-5 || std::abs(a * parts - std::round(a * parts)) < 1e-4;
            };
            if (is_near_crease(u, v) || is_near_crease(v, u)) continue;
            const SurfacePoint point = patch.at(u, v);
            ASSERT_NEAR(point.slope_x, (patch.at(u + kStep, v).height - patch.at(u - kStep, v).height) / (2 * kStep), 1e-2);
            ASSERT_NEAR(point.slope_y, (patch.at(u, v + kStep).height - patch.at(u, v - kStep).height) / (2 * kStep), 1e-2);
        }
}

/// Of the approximation from the bicubic surface, over all cells of hills.
double rms_of_approximation(std::uint32_t subdivisions) {
    const auto heights = test_support::hilly_heights<std::int16_t>(40, 40, 4);
    Dice dice(3);
    double sum = 0;
    constexpr int kPlaces = 20000;
    for (int n = 0; n < kPlaces; ++n) {
        const std::uint32_t column = dice.below(39), row = dice.below(39);
        const double u = dice.unit(), v = dice.unit();
        const double exact = cell_patch(heights.grid(), settings_of(SurfaceKind::bicubic), column, row).at(u, v).height;
        const double near =
            cell_patch(heights.grid(), settings_of(SurfaceKind::approximate_bicubic, subdivisions), column, row).at(u, v).height;
        sum += (near - exact) * (near - exact);
    }
    return std::sqrt(sum / kPlaces);
}

TEST(CellPatch, TheApproximationComesFourTimesCloserWithTwiceTheSubdivisions) {
    for (const std::uint32_t subdivisions : {2u, 4u, 8u, 16u}) {
        const double ratio = rms_of_approximation(subdivisions) / rms_of_approximation(2 * subdivisions);
        EXPECT_NEAR(ratio, 4, 0.5) << subdivisions;
    }
}

TEST(CellPatch, OneSubdivisionIsBilinear) {
    const auto heights = test_support::dice_heights<std::int16_t>(6, 6, 3);
    const CellPatch one = cell_patch(heights.grid(), settings_of(SurfaceKind::approximate_bicubic, 1), 2, 2);
    const CellPatch bilinear = cell_patch(heights.grid(), settings_of(SurfaceKind::bilinear), 2, 2);
    for (double t = 0; t <= 1; t += 0.125) EXPECT_DOUBLE_EQ(one.at(t, 1 - t * t).height, bilinear.at(t, 1 - t * t).height);
}

TEST(CellPatch, NothingIsWhereAPostHasNoHeight) {
    for (const SurfaceKind kind : kKinds)
        for (std::uint32_t k = 0; k < 4; ++k) {
            test_support::HeldHeights<float> heights(4, 4, 5.f);
            heights.at(1 + k % 2, 1 + k / 2) = HeightGrid<float>::kVoid;
            EXPECT_FALSE(cell_patch(heights.grid(), settings_of(kind), 1, 1).has_surface);
        }
}

}  // namespace
}  // namespace tedavis::raytrace::test_cell_patch
