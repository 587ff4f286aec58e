#include "render_core/raytrace/search/search_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_search_surface {
namespace {

using test_support::Dice;
using test_support::SurfaceScene;

TEST(UniformSearch, IsAsPreciseAsItsHalvings) {
    const auto gap = [](double t) { return 0.3137 - t; };
    for (std::uint32_t halvings = 0; halvings <= 30; ++halvings) {
        const SearchedPlace found = search_uniformly(gap, 0, 1, {4, halvings});
        ASSERT_TRUE(found.is_hit);
        EXPECT_LE(std::abs(found.t - 0.3137), 0.25 / std::pow(2, std::min(halvings, 24u)));
    }
    EXPECT_GT(std::abs(search_uniformly(gap, 0, 1, {4, 100}).t - 0.3137), 1e-12) << "never more than 24";
    EXPECT_FALSE(search_uniformly([](double t) { return 1 + t; }, 0, 1, {4, 4}).is_hit);
    EXPECT_TRUE(search_uniformly([](double t) { return t - 0.5; }, 0, 1, {4, 4}).is_from_below);
    EXPECT_EQ(search_uniformly([](double t) { return t; }, 0, 1, {4, 4}).t, 0);
}

TEST(UniformSearch, BeginsAnewBehindAHole) {
    const auto gap = [](double t) { return t < 0.3 ? 1 : t < 0.6 ? std::nan("") : -1; };
    EXPECT_FALSE(search_uniformly(gap, 0, 1, {50, 8}).is_hit);
}

struct WrongRays {
    int all = 0, wrong = 0;  ///< off by more than a cell, or missed
    double share() const { return wrong / static_cast<double>(all); }
};

/// Rays near the horizon over rough ground.
template <class Found>
WrongRays wrong_rays(const SurfaceScene<std::int16_t>& scene, int rays, const Found& search) {
    WrongRays result;
    Dice dice(3);
    const double size = scene.heights.columns - 1;
    for (int n = 0; n < rays; ++n) {
        Ray ray;
        ray.origin = {0, dice.between(0, size), 12 + dice.between(0, 8)};
        ray.direction = glm::vec3(1, dice.between(-0.4, 0.4), dice.between(-0.05, 0.01));
        const SurfaceHit exact = scene.trace(ray), found = search(ray);
        ++result.all;
        const bool is_wrong = (exact.side == HitSide::none) != (found.side == HitSide::none) ||
                              (exact.side != HitSide::none && std::abs(exact.t - found.t) > 1);
        result.wrong += is_wrong ? 1 : 0;
    }
    return result;
}

TEST(SearchSurface, WithinCellsNextToNoRayIsWrong) {
    const SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(257, 257, 4, 50), SurfaceKind::bilinear);
    const WrongRays of_cells = wrong_rays(scene, 20000, [&](const Ray& ray) {
        return search_cells(scene.maxima, scene.settings, ray, {4, 12});
    });
    EXPECT_LE(of_cells.share(), 2e-4);
}

TEST(SearchSurface, OverTheWholeRayManyAreAndFewerStepsAreWorse) {
    const SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(257, 257, 4, 50), SurfaceKind::bilinear);
    double last = 1;
    for (const std::uint32_t steps : {64u, 128u, 256u, 1024u}) {
        const double share = wrong_rays(scene, 6000, [&](const Ray& ray) {
                                 return search_ray(scene.heights.grid(), scene.settings, ray, {steps, 12});
                             }).share();
        EXPECT_LT(share, last);
        last = share;
        EXPECT_TRUE(steps != 64 || share > 0.01);
    }
    EXPECT_LT(last, 0.01);
}

TEST(SearchSurface, ASpikeIsFoundInCellsAndLostOverTheRay) {
    test_support::HeldHeights<std::int16_t> heights(257, 65, 0);
    for (std::uint32_t row = 0; row < 65; ++row) heights.at(131, row) = 100;
    const SurfaceScene<std::int16_t> scene(heights, SurfaceKind::bilinear);
    int lost_in_cells = 0, lost_over_ray = 0;
    for (int n = 0; n < 500; ++n) {
        const Ray ray{{n / 500.0, 32, 90}, {1, 0, 0}};
        ASSERT_EQ(scene.trace(ray).side, HitSide::above);
        lost_in_cells += search_cells(scene.maxima, scene.settings, ray, {4, 12}).side == HitSide::none ? 1 : 0;
        lost_over_ray += search_ray(scene.heights.grid(), scene.settings, ray, {32, 12}).side == HitSide::none ? 1 : 0;
    }
    EXPECT_EQ(lost_in_cells, 0);
    EXPECT_GT(lost_over_ray, 250) << "steps of eight cells";
    test_support::record_worst("A23", lost_in_cells);
    test_support::record_control("A23", lost_over_ray);
}

}  // namespace
}  // namespace tedavis::raytrace::test_search_surface
