#include "render_core/raytrace/search/bicubic_crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_bicubic_crossing {
namespace {

using test_support::Dice;

BicubicPatch dice_patch(std::uint64_t seed) {
    const auto heights = test_support::dice_heights<float>(4, 4, seed, 3);
    return bicubic_patch(patch_posts(heights.grid(), 1, 1));
}

CellRay stretch_of(Dice& dice) {
    const auto point = [&](double t) { return RayPoint{t, {1, 1, dice.unit(), dice.unit()}, dice.between(-3, 3)}; };
    return {point(0), point(1)};
}

TEST(BicubicCrossing, TheCurveIsTheLinesHeightAboveThePatch) {
    Dice dice(1);
    for (int n = 0; n < 5000; ++n) {
        const BicubicPatch patch = dice_patch(n);
        const CellRay ray = stretch_of(dice);
        GapCurve curve = gap_curve(patch, ray);
        const double s = dice.unit();
        for (int k = 6; k > 0; --k)
            for (int i = 0; i < k; ++i) curve.c[i] = (1 - s) * curve.c[i] + s * curve.c[i + 1];
        const RayPoint p = ray.at(s);
        ASSERT_NEAR(curve.c[0], p.z - patch.at(p.place.u, p.place.v).height, 1e-12);
    }
}

TEST(BicubicCrossing, MissesNoDipThatFineSamplesFind) {
    Dice dice(2);
    int hit_count = 0;
    for (int n = 0; n < 3000; ++n) {
        const BicubicPatch patch = dice_patch(n);
        CellRay ray = stretch_of(dice);
        const auto gap = [&](double s) {
            const RayPoint p = ray.at(s);
            return p.z - patch.at(p.place.u, p.place.v).height;
        };
        // Shifted until it just dips in: a thousandth of a step deep, some thousandths of the stretch wide.
        double least = 1e30;
        for (int k = 0; k <= 1000; ++k) least = std::min(least, gap(k / 1000.0));
        ray.from.z -= least + 1e-3;
        ray.to.z -= least + 1e-3;
        if (gap(0) <= 0) continue;
        const Crossing found = bicubic_crossing(patch, ray, 1);
        ASSERT_TRUE(found.is_hit) << n;
        ASSERT_NEAR(gap(found.s), 0, 1e-9);
        // And just above it: nothing, where the samples say so by more than they may be off.
        ray.from.z += 2.1e-3;
        ray.to.z += 2.1e-3;
        const Crossing above = bicubic_crossing(patch, ray, 1);
        ASSERT_TRUE(!above.is_hit || std::abs(gap(above.s)) < 1e-9);
        hit_count += above.is_hit ? 0 : 1;
    }
    EXPECT_GT(hit_count, 1500);
}

TEST(BicubicCrossing, ALineInTheSurfaceEndsAfterBoundedSteps) {
    const test_support::HeldHeights<float> flat(4, 4, 2.f);
    const BicubicPatch patch = bicubic_patch(patch_posts(flat.grid(), 1, 1));
    const CellRay in_it{{0, {1, 1, 0.1, 0.2}, 2}, {1, {1, 1, 0.9, 0.3}, 2}};
    EXPECT_TRUE(bicubic_crossing(patch, in_it, 1).is_hit);
    EXPECT_EQ(bicubic_crossing(patch, in_it, 1).s, 0);
    const CellRay above{{0, {1, 1, 0.1, 0.2}, std::nextafter(2.0, 3.0)}, {1, {1, 1, 0.9, 0.3}, std::nextafter(2.0, 3.0)}};
    EXPECT_FALSE(bicubic_crossing(patch, above, 1).is_hit);
}

}  // namespace
}  // namespace tedavis::raytrace::test_bicubic_crossing
