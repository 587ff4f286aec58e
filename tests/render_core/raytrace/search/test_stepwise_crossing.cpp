#include "render_core/raytrace/search/stepwise_crossing.hpp"

#include <gtest/gtest.h>

#include "tests/support/raytrace/held_heights.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_stepwise_crossing {
namespace {

using test_support::Dice;

TEST(StepwiseCrossing, NeverPassesWhatFineSamplesFind) {
    Dice dice(1);
    int hit_count = 0, missed = 0;
    for (int n = 0; n < 3000; ++n) {
        SurfaceSettings settings;
        settings.kind = test_support::kSurfaceKinds[n % 4];
        settings.micro.kind = MicroKind::noise;
        settings.micro.noise.kind = n % 3 == 0 ? NoiseKind::value : NoiseKind::gradient;
        settings.micro.noise.amplitude = 0.4;
        settings.micro.noise.frequency = 4;
        const auto heights = test_support::dice_heights<float>(4, 4, n, 2);
        const CellPatch patch = cell_patch(heights.grid(), settings, 1, 1);
        const auto point = [&](double t, double u) { return RayPoint{t, {1, 1, u, dice.unit()}, dice.between(-2, 2)}; };
        const CellRay ray{point(0, 0), point(1, 1)};
        const auto gap = [&](double s) {
            const RayPoint p = ray.at(s);
            return p.z - surface_on(patch, settings.micro, p.place).height;
        };
        const double sign = gap(0) < 0 ? -1 : 1;
        double first = 2;
        for (int k = 0; k <= 3000 && first > 1; ++k)
            if (sign * gap(k / 3000.0) <= 0) first = k / 3000.0;
        const Crossing found = stepwise_crossing(patch, settings.micro, ray);
        if (first <= 1) {
            ASSERT_TRUE(found.is_hit) << n;
            ASSERT_LE(found.s, first + 1e-12);
            ++hit_count;
        }
        missed += found.is_hit ? 0 : 1;
        ASSERT_TRUE(!found.is_hit || std::abs(gap(found.s)) < 1.5e-5) << "no farther than the skin";
    }
    EXPECT_GT(hit_count, 1000);
    EXPECT_GT(missed, 100);
}

TEST(StepwiseCrossing, StepsOfFixedLengthDoPass) {
    // The control: a needle of relief that eight samples a cell go by.
    auto tile = test_support::HeldHeights<std::int16_t>(64, 64);
    for (std::uint32_t row = 0; row < 64; ++row) tile.at(37, row) = 1000;
    SurfaceSettings settings;
    settings.micro.kind = MicroKind::relief;
    settings.micro.relief.tile = tile.grid();
    settings.micro.relief.full_scale = 1000;
    settings.micro.relief.amplitude = 1;
    settings.micro.relief.density = 64;
    const test_support::HeldHeights<float> flat(4, 4, 0.f);
    const CellPatch patch = cell_patch(flat.grid(), settings, 1, 1);
    const CellRay ray{{0, {1, 1, 0, 0.5}, 0.5}, {1, {1, 1, 1, 0.5}, 0.5}};
    bool is_seen = false;
    for (int k = 0; k <= 8; ++k) {
        const RayPoint p = ray.at(k / 8.0);
        is_seen = is_seen || p.z < surface_on(patch, settings.micro, p.place).height;
    }
    EXPECT_FALSE(is_seen);
    const Crossing found = stepwise_crossing(patch, settings.micro, ray);
    EXPECT_TRUE(found.is_hit);
    EXPECT_NEAR(found.s, 36.5 / 64, 1e-5);
}

}  // namespace
}  // namespace tedavis::raytrace::test_stepwise_crossing
