#include "render_core/raytrace/search/trace_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_trace_surface {
namespace {

using test_support::Dice;
using test_support::kSurfaceKinds;
using test_support::SurfaceScene;

Ray random_ray(Dice& dice, double columns, double rows, double height) {
    Ray ray;
    ray.origin = {dice.between(-3, columns + 3), dice.between(-3, rows + 3), dice.between(0.5, 2.5) * height};
    const glm::dvec3 aim(dice.between(0, columns), dice.between(0, rows), dice.between(-1, 1) * height);
    ray.direction = glm::vec3(aim - ray.origin);
    return ray;
}

/// Traversed in a hundredth of a cell; NaN where there is no surface.
struct Traversed {
    double t = -1, least_clearance = 1e30;
};

template <class Height>
Traversed march(const SurfaceScene<Height>& scene, const Ray& ray) {
    Traversed found;
    const double steps = 100 * std::hypot(ray.direction.x, ray.direction.y) * 1.5;
    bool is_first = true, was_above = true;
    for (double n = 0; n <= steps; ++n) {
        const double t = 1.5 * n / steps;
        const glm::dvec3 p = ray.origin + t * glm::dvec3(ray.direction);
        SurfacePoint surface;
        if (!find_surface(scene.heights.grid(), scene.settings, p.x, p.y, surface)) {
            is_first = true;
            continue;
        }
        const bool is_above = p.z > surface.height;
        found.least_clearance = std::min(found.least_clearance, std::abs(p.z - surface.height));
        if (!is_first && is_above != was_above) {
            found.t = t;
            return found;
        }
        is_first = false;
        was_above = is_above;
    }
    return found;
}

TEST(TraceSurface, IsWhereAFineMarchChangesSides) {
    for (const SurfaceKind kind : kSurfaceKinds) {
        SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(37, 29, 5, 60), kind);
        Dice dice(static_cast<std::uint64_t>(kind));
        int hits = 0, unlike = 0;
        for (int n = 0; n < 1500; ++n) {
            Ray ray = random_ray(dice, 36, 28, 30);
            ray.to = 1.5f;
            const SurfaceHit hit = scene.trace(ray);
            const Traversed marched = march(scene, ray);
            if ((hit.side != HitSide::none) != (marched.t >= 0)) {
                ++unlike;
                EXPECT_LT(marched.least_clearance, 2) << "only where the march may step over something";
                continue;
            }
            if (marched.t < 0) continue;
            ++hits;
            EXPECT_LE(hit.t, marched.t + 1e-9);
            const double z = ray.origin.z + hit.t * ray.direction.z;
            EXPECT_NEAR(z, hit.height, 1e-6);
        }
        EXPECT_GT(hits, 600);
        EXPECT_LE(unlike, 15);
    }
}

TEST(TraceSurface, TheMipmapChangesNothing) {
    // The same cells one after the other, without it.
    for (const SurfaceKind kind : kSurfaceKinds) {
        SurfaceScene<std::int16_t> scene(test_support::dice_heights<std::int16_t>(33, 47, 5, 20), kind);
        test_support::HeldHeights<std::int16_t> raised = scene.heights;
        SurfaceScene<std::int16_t> high(std::move(raised), kind);
        Dice dice(7);
        for (int n = 0; n < 3000; ++n) {
            const Ray ray = random_ray(dice, 32, 46, 15);
            TraceCounts counts;
            const SurfaceHit hit = scene.trace(ray, &counts);
            Ray rest = ray;  // a later start before the hit finds the same
            if (hit.side != HitSide::above || hit.t < 0.01) continue;
            rest.from = static_cast<float>(hit.t * dice.between(0.1, 0.9));
            EXPECT_NEAR(high.trace(rest).t, hit.t, 1e-9);
            EXPECT_LT(counts.nodes, 400u);
        }
    }
}

TEST(TraceSurface, VerticalRaysHitEveryPostAndSide) {
    for (const SurfaceKind kind : kSurfaceKinds) {
        SurfaceScene<float> scene(test_support::dice_heights<float>(9, 6, 2, 50), kind);
        for (int j = 0; j <= 20; ++j)
            for (int i = 0; i <= 32; ++i) {
                Ray ray;
                ray.origin = {i / 4.0, j / 4.0, 1000};
                ray.direction = {0, 0, -1};
                const SurfaceHit hit = scene.trace(ray);
                ASSERT_EQ(hit.side, HitSide::above) << i << ' ' << j;
                SurfacePoint point;
                ASSERT_TRUE(find_surface(scene.heights.grid(), scene.settings, i / 4.0, j / 4.0, point));
                ASSERT_NEAR(hit.t, 1000 - point.height, 1e-6);
            }
    }
}

TEST(TraceSurface, RaysAlongGridLinesHitTheWall) {
    for (const SurfaceKind kind : kSurfaceKinds) {
        test_support::HeldHeights<std::int16_t> heights(20, 11);
        for (std::uint32_t row = 0; row < 11; ++row) heights.at(13, row) = 100;
        SurfaceScene<std::int16_t> scene(heights, kind);
        for (int row = 0; row <= 20; ++row)
            for (const float sign : {1.f, -1.f}) {
                Ray ray;
                ray.origin = {sign > 0 ? -4 : 24, row / 2.0, 40};
                ray.direction = {sign, 0, 0};
                const SurfaceHit hit = scene.trace(ray);
                ASSERT_EQ(hit.side, HitSide::above) << row;
                EXPECT_NEAR(ray.origin.x + sign * hit.t, 13 - sign * 0.6, kind == SurfaceKind::bilinear ? 1e-9 : 0.15);
            }
    }
}

TEST(TraceSurface, EdgesOfCellsAreNotSlippedThrough) {
    SurfaceScene<float> scene(test_support::dice_heights<float>(65, 65, 3, 10), SurfaceKind::bicubic);
    Dice dice(5);
    for (int n = 0; n < 200000; ++n) {
        const bool is_across = n % 2 == 0;
        const double line = dice.below(63) + 1, along = n % 5 == 0 ? dice.below(64) : dice.between(0, 64);
        const glm::dvec3 aim(is_across ? line : along, is_across ? along : line, 0);
        Ray ray;
        ray.origin = aim + glm::dvec3(dice.between(-30, 30), dice.between(-30, 30), 60);
        ray.direction = glm::vec3(glm::dvec3(aim) - ray.origin) * 2.f;
        const glm::dvec3 end = ray.origin + glm::dvec3(ray.direction);
        if (std::min({ray.origin.x, ray.origin.y, end.x, end.y}) < 0 || std::max({ray.origin.x, ray.origin.y, end.x, end.y}) > 64)
            continue;
        ASSERT_EQ(scene.trace(ray).side, HitSide::above) << n;
    }
}

TEST(TraceSurface, BelowAndThroughHoles) {
    test_support::HeldHeights<float> heights(12, 12, 10.f);
    heights.at(6, 6) = HeightGrid<float>::kVoid;
    SurfaceScene<float> scene(heights, SurfaceKind::bilinear);
    Ray up;
    up.origin = {2.5, 2.5, 0};
    up.direction = {0, 0, 1};
    EXPECT_EQ(scene.trace(up).side, HitSide::below);
    EXPECT_NEAR(scene.trace(up).t, 10, 1e-12);
    Ray through = up;
    through.origin = {6.2, 5.9, 50};
    through.direction = {0, 0, -1};
    EXPECT_EQ(scene.trace(through).side, HitSide::none);
    Ray in_and_out;  // down through the hole, then up from below it
    in_and_out.origin = {6, 6, 5};
    in_and_out.direction = {1, 0, 1};
    EXPECT_EQ(scene.trace(in_and_out).side, HitSide::below);
    EXPECT_NEAR(scene.trace(in_and_out).t, 5, 1e-9);
    EXPECT_EQ(scene.trace({{6, 6, 5}, {1, 0, 6}}).side, HitSide::none);
    Ray on_it = up;
    on_it.origin.z = 10;
    EXPECT_EQ(scene.trace(on_it).t, 0);
}

TEST(TraceSurface, BoundsOfPostsAloneLoseSmoothHilltops) {
    const auto heights = test_support::hilly_heights<std::int16_t>(64, 64, 5, 300);
    SurfaceScene<std::int16_t> scene(heights, SurfaceKind::bicubic);
    std::vector<unsigned char> memory(HeightMipmap<std::int16_t>::bytes_needed(64, 64));
    base::Arena arena(memory.data(), memory.size());
    HeightMipmap<std::int16_t> of_posts;
    ASSERT_TRUE(of_posts.start(scene.heights.grid(), arena));
    base::SerialWorkers alone;
    of_posts.build(alone);
    int lost = 0;
    Dice dice(6);
    for (int n = 0; n < 20000; ++n) {
        // Level rays that graze the tops of cells.
        const std::uint32_t column = dice.below(63), row = dice.below(63);
        const double z = of_posts.level(0).at(column, row) + 0.05;
        const Ray ray{{column + 0.5, row + 0.5, z}, {static_cast<float>(dice.between(-1, 1)), 1, 0}, 0, 1};
        lost += trace_surface(of_posts, scene.settings, ray).side != scene.trace(ray).side ? 1 : 0;
    }
    EXPECT_GT(lost, 50);
}

TEST(TraceSurface, MicroStructureIsMetWithItsBounds) {
    SurfaceSettings settings;
    settings.micro.kind = MicroKind::noise;
    settings.micro.noise.amplitude = 2;
    SurfaceScene<float> scene(test_support::HeldHeights<float>(30, 30, 0.f), settings);
    Dice dice(8);
    int above_posts = 0;
    for (int n = 0; n < 2000; ++n) {
        const Ray ray{{dice.between(0, 29), dice.between(0, 29), 30}, {static_cast<float>(dice.between(-0.2, 0.2)), 0.1f, -2}};
        const SurfaceHit hit = scene.trace(ray);
        if (hit.side == HitSide::none) continue;
        const glm::dvec3 p = ray.origin + hit.t * glm::dvec3(ray.direction);
        EXPECT_NEAR(p.z, noise_at(settings.micro.noise, p.x, p.y).height, 1e-5);
        above_posts += p.z > 0.01 ? 1 : 0;
    }
    EXPECT_GT(above_posts, 500);
}

}  // namespace
}  // namespace tedavis::raytrace::test_trace_surface
