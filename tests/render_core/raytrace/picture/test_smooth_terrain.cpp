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

/// A wall one cell thick across flat ground, seen from the side by nearly level rays.
class SearchedWall : public ::testing::Test {
protected:
    static constexpr std::uint32_t kSide = 257, kRays = 200;

    SearchedWall() : scene_(wall(), SurfaceKind::bilinear) { terrain_.start(scene_.maxima, scene_.settings, 1); }
    static test_support::HeldHeights<std::int16_t> wall() {
        test_support::HeldHeights<std::int16_t> heights(kSide, 65, 0);
        for (std::uint32_t row = 0; row < 65; ++row) heights.at(131, row) = 100;
        return heights;
    }
    static Ray ray(std::uint32_t number) { return {{number / double{kRays}, 32, 90}, {1, 0, -0.1f}}; }
    /// How many rays do not meet the wall where the exact search does.
    [[nodiscard]] std::uint32_t lost() const {
        std::uint32_t count = 0;
        for (std::uint32_t n = 0; n < kRays; ++n) {
            const RayHit found = terrain_.intersect(ray(n));
            count += found.is_hit && std::abs(double{found.t} - scene_.trace(ray(n)).t) < 0.01 ? 0 : 1;
        }
        return count;
    }

    test_support::SurfaceScene<std::int16_t> scene_;
    SmoothTerrain<std::int16_t> terrain_;
};

TEST_F(SearchedWall, IsMetExactlyAndInCellsAndPassedByFewStepsOverTheRay) {
    EXPECT_EQ(lost(), 0U) << "exact";
    terrain_.set_search(usual_search(SearchKind::cells), nullptr);
    EXPECT_EQ(lost(), 0U);
    terrain_.set_search({SearchKind::ray, 64, 12}, nullptr);
    EXPECT_GT(lost(), kRays / 4) << "control: steps of four cells";
    terrain_.set_search({SearchKind::ray, 4096, 12}, nullptr);
    EXPECT_EQ(lost(), 0U) << "sixteen steps a cell";
    terrain_.start(scene_.maxima, scene_.settings, 1);
    EXPECT_EQ(lost(), 0U) << "started anew, it is exact";
}

TEST_F(SearchedWall, IsMostlyMetByStepsOfCones) {
    std::vector<unsigned char> memory(ConeMap<std::int16_t>::bytes_needed(kSide, 65));
    base::Arena arena(memory.data(), memory.size());
    ConeMap<std::int16_t> cones;
    ASSERT_TRUE(cones.start(scene_.heights.grid(), {}, arena));
    base::SerialWorkers alone;
    cones.build(alone);
    terrain_.set_search({SearchKind::cones, 400, 16}, &cones);
    EXPECT_LT(lost(), kRays / 2) << "relaxed cones let some level rays pass";
    terrain_.set_search({SearchKind::cones, 4, 16}, &cones);
    EXPECT_EQ(lost(), kRays) << "control: four steps of up to 16 posts do not reach it";
}

}  // namespace
}  // namespace tedavis::raytrace
