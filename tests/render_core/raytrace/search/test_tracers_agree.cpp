// The tracer in double, cell by cell, beside the one in floats and lanes: no arithmetic is shared.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render_core/raytrace/shading/cast_shadow.hpp"
#include "render_core/raytrace/trace_ray.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_tracers_agree {
namespace {

using test_support::Dice;
using test_support::SurfaceScene;

/// What the other one needs as well: lowest heights.
struct FloatTracer {
    std::vector<unsigned char> memory;
    base::Arena arena;
    HeightMipmap<std::int16_t> minima{HeightBound::minimum};
    TracedField<std::int16_t> field;

    explicit FloatTracer(const SurfaceScene<std::int16_t>& scene)
        : memory(HeightMipmap<std::int16_t>::bytes_needed(scene.heights.columns, scene.heights.rows)),
          arena(memory.data(), memory.size()) {
        EXPECT_TRUE(minima.start(scene.heights.grid(), arena));
        base::SerialWorkers alone;
        minima.build(alone);
        const bool is_bilinear = scene.settings.kind == SurfaceKind::bilinear;
        field = {&scene.maxima, &minima, is_bilinear ? CellSurface::bilinear : CellSurface::two_triangles};
    }
};

TEST(TracersAgree, AboutWhatIsMetAndWhere) {
    for (const SurfaceKind kind : {SurfaceKind::two_triangles, SurfaceKind::bilinear}) {
        const SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(257, 200, 4, 80), kind);
        const FloatTracer floats(scene);
        Dice dice(1);
        int hits = 0, unlike = 0, far = 0;
        constexpr int kRays = 60000;
        for (int n = 0; n < kRays; ++n) {
            Ray ray;
            ray.origin = {dice.between(-20, 276), dice.between(-20, 219), dice.between(90, 140)};
            const glm::dvec3 aim(dice.between(0, 256), dice.between(0, 199), dice.between(-80, 90));
            ray.direction = glm::vec3(glm::normalize(aim - ray.origin));
            const SurfaceHit ours = scene.trace(ray);
            const Hit theirs = trace_ray(floats.field, ray);
            if (ours.side != theirs.side) {
                ++unlike;
                continue;
            }
            if (ours.side == HitSide::none) continue;
            ++hits;
            far += std::abs(ours.t - double{theirs.t}) > 1e-5 * (1 + ours.t) ? 1 : 0;
        }
        EXPECT_GT(hits, kRays / 3);
        EXPECT_LE(unlike, 3) << "rays that touch";
        EXPECT_LE(far, kRays / 2000) << "rays that graze";
    }
}

TEST(TracersAgree, AndTheFloatsKeepOffTheirOwnGroundWithTheStatedPrecision) {
    for (const double slope : {0.0, 1.7320508}) {
        const GridScale scale{30, 30, 1};
        const SurfaceScene<std::int16_t> scene(test_support::HeldHeights<std::int16_t>(129, 129).fill([&](double x, double y) {
            return std::floor(4000 + 30 * slope * (0.8 * x - 0.6 * y));
        }),
                                               SurfaceKind::bilinear);
        const FloatTracer floats(scene);
        Dice dice(2);
        int own = 0, own_without = 0, asked = 0;
        for (int n = 0; n < 100000; ++n) {
            const double x = dice.between(2, 126), y = dice.between(2, 126);
            SurfacePoint point;
            ASSERT_TRUE(find_surface(scene.heights.grid(), scene.settings, x, y, point));
            // Along the mean plane and at least five degrees above it: roundings of heights make cells that tilt by less.
            const glm::dvec3 normal = normal_of({0, 30 * slope * 0.8, -30 * slope * 0.6}, scale);
            const glm::dvec3 any = glm::normalize(glm::dvec3(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)));
            const glm::dvec3 along = glm::normalize(any - glm::dot(any, normal) * normal);
            const glm::dvec3 sun = glm::normalize(along + 0.09 * normal);
            Ray ray = ray_from_surface(x, y, point, in_grid_space(sun, scale), {});
            ++asked;
            own += trace_ray(floats.field, ray).side != HitSide::none ? 1 : 0;
            ray.origin.z = point.height - 1e-4;
            own_without += trace_ray(floats.field, ray).side != HitSide::none ? 1 : 0;
        }
        EXPECT_EQ(own, 0) << slope << " of " << asked;
        EXPECT_GT(own_without, 0) << "a start below the ground must be seen to matter";
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_tracers_agree
