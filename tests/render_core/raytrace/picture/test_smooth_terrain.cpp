#include "render_core/raytrace/picture/smooth_terrain.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/search/trace_surface.hpp"
#include "tests/support/raytrace/surface_scene.hpp"
#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::raytrace {
namespace {

TEST(SmoothTerrain, HasWhatEachRayMeetsAlone) {
    constexpr std::uint32_t kSmoothWidth = 40, kSmoothHeight = 30;
    const test_support::SurfaceScene<std::int16_t> scene(test_support::hilly_heights<std::int16_t>(50, 60, 3),
                                                         SurfaceKind::bicubic);
    SmoothTerrain<std::int16_t> terrain;
    terrain.start(scene.maxima, scene.settings, kSmoothWidth);
    std::mt19937 random(8);
    std::size_t hit_count = 0;
    for (int run = 0; run < 8; ++run) {
        const GridCamera camera = test_support::any_camera(random, 50, 60, kSmoothWidth);
        terrain.set_view(PictureSight::of_grid(camera));
        test_support::TracedPicture picture(kSmoothWidth, kSmoothHeight);
        std::vector<float> u(picture.t.size()), v(picture.t.size());
        const HitPicture hits = {picture.t, picture.cell, picture.side, u, v};
        terrain.trace({0, 0, 15, kSmoothHeight}, hits);
        terrain.trace({15, 0, kSmoothWidth - 15, kSmoothHeight}, hits);
        for (std::uint32_t y = 0; y < kSmoothHeight; ++y) {
            SpanSurface surface;
            terrain.find_surface({y * kSmoothWidth, kSmoothWidth}, hits, surface);
            for (std::uint32_t x = 0; x < kSmoothWidth; ++x) {
                const SurfaceHit hit = scene.trace(camera.ray(x, y));
                ASSERT_EQ(surface.is_hit[x], hit.side != HitSide::none);
                EXPECT_EQ(terrain.is_hidden(camera.ray(x, y)), surface.is_hit[x]);
                if (!surface.is_hit[x]) continue;
                ++hit_count;
                EXPECT_EQ(surface.t[x], static_cast<float>(hit.t));
                EXPECT_NEAR(surface.x[x], hit.place.column + hit.place.u, 1e-4);
                EXPECT_NEAR(surface.slope_x[x], hit.slopes.x, 0.05);
                EXPECT_NEAR(surface.slope_y[x], hit.slopes.y, 0.05);
                const RayHit one = terrain.intersect(camera.ray(x, y));
                EXPECT_EQ(one.point.height, hit.height);
                EXPECT_EQ(one.t, surface.t[x]);
            }
        }
    }
    EXPECT_GT(hit_count, 500U);
}

}  // namespace
}  // namespace tedavis::raytrace
