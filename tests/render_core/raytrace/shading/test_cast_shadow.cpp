#include "render_core/raytrace/shading/cast_shadow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_cast_shadow {
namespace {

using test_support::Dice;
using test_support::SurfaceScene;

constexpr TracerPrecision kDoubles{0x1p-53, 16};

template <class Height>
OcclusionTest test_of(const SurfaceScene<Height>& scene) {
    return {[](const void* context, const Ray& ray) {
                return static_cast<const SurfaceScene<Height>*>(context)->trace(ray).side != HitSide::none;
            },
            &scene};
}

/// Shadow rays from hits of eye rays on a plane: those that meet the plane itself, with a lift of one's own.
int own_hits(const SurfaceScene<float>& scene, const GridScale& scale, double fixed_lift, bool is_projected) {
    Dice dice(1);
    int hits = 0;
    const double size = scene.heights.columns - 1;
    for (int n = 0; n < 40000; ++n) {
        const glm::dvec3 aim(dice.between(1, size - 1), dice.between(1, size - 1), 0);
        Ray eye;
        eye.origin = aim + glm::dvec3(dice.between(-200, 200), dice.between(-200, 200), 20000);
        eye.direction = glm::vec3(aim - eye.origin);
        const SurfaceHit hit = scene.trace(eye);
        if (hit.side == HitSide::none) continue;
        // As a tracer in floats gives it.
        const double t = static_cast<float>(hit.t);
        const glm::dvec3 place = eye.origin + t * glm::dvec3(eye.direction);
        SurfacePoint point;
        if (!find_surface(scene.heights.grid(), scene.settings, place.x, place.y, point)) continue;
        const glm::dvec3 normal = normal_of(point, scale);
        const glm::dvec3 sun =
            glm::normalize(normal * 0.05 + glm::normalize(glm::dvec3(dice.between(-1, 1), dice.between(-1, 1), 1)));
        if (glm::dot(normal, sun) <= 1e-3) continue;
        Ray ray = ray_from_surface(place.x, place.y, point, in_grid_space(sun, scale), kDoubles);
        if (!is_projected) ray.origin.z = place.z + fixed_lift;
        hits += scene.trace(ray).side != HitSide::none ? 1 : 0;
    }
    return hits;
}

TEST(CastShadow, PlanesAndSlopesDoNotShadowThemselves) {
    int worst = 0, unlifted = 0;
    for (const double slope : {0.0, 0.3, 1.7320508}) {
        const GridScale scale{30, 30, 1};
        const SurfaceScene<float> scene(test_support::HeldHeights<float>(65, 65).fill(
                                            [&](double x, double y) { return 3000 + 30 * slope * (0.8 * x - 0.6 * y); }),
                                        SurfaceKind::bilinear);
        const int ours = own_hits(scene, scale, 0, true), none = own_hits(scene, scale, 0, false),
                  fixed = own_hits(scene, scale, 1e-4, false);
        EXPECT_EQ(ours, 0) << slope;
        EXPECT_GT(none, 400) << "without a lift";
        EXPECT_GT(fixed, 200) << "with a fixed one of a tenth of a millimetre";
        worst = std::max(worst, ours);
        unlifted = std::max(unlifted, none);
    }
    test_support::record_worst("A22", worst);
    test_support::record_control("A22", unlifted);
}

TEST(CastShadow, LightDoesNotLeakUnderAWall) {
    // A wall one post wide at column 32; behind it, close to its foot, nothing may be lit by a sun behind the wall.
    test_support::HeldHeights<float> heights(65, 65, 2000.f);
    for (std::uint32_t row = 0; row < 65; ++row) heights.at(32, row) = 2100;
    const SurfaceScene<float> scene(heights, SurfaceKind::bilinear);
    const GridScale scale{30, 30, 1};
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-1, 0, 0.01));
    Dice dice(2);
    for (int n = 0; n < 20000; ++n) {
        const double x = 33 + std::pow(10, -dice.between(0, 12)), y = dice.between(1, 63);
        SurfacePoint point;
        ASSERT_TRUE(find_surface(scene.heights.grid(), scene.settings, x, y, point));
        ASSERT_TRUE(is_in_shadow(x, y, point, sun, scale, test_of(scene), kDoubles));
    }
    // A ray that starts a whole step higher than it needs passes over a low wall: what too large a fixed lift does.
    SurfacePoint ground{2000, 0, 0};
    EXPECT_LT(lift_above(ground, kDoubles), 1e-10);
    EXPECT_LT(lift_above(ground, TracerPrecision{}) * 1 / 30, 1e-3) << "a thousandth of a cell, in floats";
}

TEST(CastShadow, IsWhereTheGeometryOfAWallSays) {
    test_support::HeldHeights<float> heights(65, 33, 0.f);
    for (std::uint32_t row = 0; row < 33; ++row) heights.at(20, row) = 10;
    const SurfaceScene<float> scene(heights, SurfaceKind::bilinear);
    const glm::dvec3 sun = glm::normalize(glm::dvec3(-2, 0, 1));  // its shadow is 20 long
    for (double x = 21.01; x < 60; x += 0.25) {
        SurfacePoint point;
        ASSERT_TRUE(find_surface(scene.heights.grid(), scene.settings, x, 16.3, point));
        if (std::abs(x - 40) < 1e-6) continue;
        EXPECT_EQ(is_in_shadow(x, 16.3, point, sun, {}, test_of(scene), kDoubles), x < 40) << x;
    }
}

TEST(CastShadow, WhatFacesAwayNeedsNoRay) {
    const OcclusionTest never{[](const void*, const Ray&) { return false; }, nullptr};
    EXPECT_TRUE(is_in_shadow(0, 0, {0, 1, 0}, {0.9, 0, 0.1}, {}, never, {}));
    EXPECT_FALSE(is_in_shadow(0, 0, {0, 1, 0}, {-0.9, 0, 0.1}, {}, never, {}));
}

}  // namespace
}  // namespace tedavis::raytrace::test_cast_shadow
