#include "render_core/raytrace/picture/kernel_terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kTiledWidth = 150, kTiledHeight = 100;

struct TracedPlaces : test_support::TracedPicture {
    TracedPlaces(std::uint32_t w, std::uint32_t h) : TracedPicture(w, h), u(w * h), v(w * h) {}
    [[nodiscard]] HitPicture picture() { return {t, cell, side, u, v}; }
    std::vector<float> u, v;
};

class KernelTerrainTest : public ::testing::Test {
protected:
    KernelTerrainTest() : hills_(90, 70, true) {}

    [[nodiscard]] TracedField<std::int16_t> field(CellSurface surface) const {
        TracedField<std::int16_t> field = hills_.field(surface);
        field.minima = nullptr;
        return field;
    }
    test_support::ViewedHills<std::int16_t> hills_;
    std::mt19937 random_{5};
    base::SerialWorkers alone_;
};

TEST_F(KernelTerrainTest, WholeTilesAreWhatTheKernelFinds) {
    for (const bool is_upright : {false, true})
        for (int run = 0; run < 6; ++run) {
            const GridCamera camera = is_upright ? test_support::upright_camera(random_, 90, 70, kTiledWidth, run % 2 == 1)
                                                 : test_support::any_camera(random_, 90, 70, kTiledWidth);
            const auto& kernel = view_kernels<std::int16_t>()[0];
            KernelTerrain<std::int16_t> terrain;
            terrain.start(field(CellSurface::bilinear), 1, kTiledWidth, kTiledHeight);
            terrain.set_view(PictureSight::of_grid(camera), kernel);
            const test_support::TracedPicture right =
                test_support::traced_by(kernel, field(CellSurface::bilinear), camera, kTiledWidth, kTiledHeight, alone_);
            TracedPlaces rows(kTiledWidth, kTiledHeight), columns(kTiledWidth, kTiledHeight);
            for (std::uint32_t y = 0; y < kTiledHeight; y += 32)
                terrain.trace({0, y, kTiledWidth, std::min(32u, kTiledHeight - y)}, rows.picture());
            for (std::uint32_t x = 0; x < kTiledWidth; x += 64)
                terrain.trace({x, 0, std::min(64u, kTiledWidth - x), kTiledHeight}, columns.picture());
            EXPECT_EQ(rows.differences(right), 0U) << is_upright << run;
            EXPECT_EQ(columns.differences(right), 0U) << is_upright << run;
        }
}

TEST_F(KernelTerrainTest, SurfaceOfASpanIsThatWhichSingleRaysMeet) {
    std::size_t hit_pixels = 0;
    for (const CellSurface surface : {CellSurface::bilinear, CellSurface::two_triangles})
        for (int run = 0; run < 6; ++run) {
            const GridCamera camera = test_support::any_camera(random_, 90, 70, kTiledWidth);
            KernelTerrain<std::int16_t> terrain;
            terrain.start(field(surface), 1, kTiledWidth, kTiledHeight);
            terrain.set_view(PictureSight::of_grid(camera), view_kernels<std::int16_t>()[0]);
            TracedPlaces tiles(kTiledWidth, kTiledHeight);
            for (std::uint32_t y = 0; y < kTiledHeight; y += 32)
                terrain.trace({0, y, kTiledWidth, std::min(32u, kTiledHeight - y)}, tiles.picture());
            SpanSurface found;
            for (std::uint32_t y = 0; y < kTiledHeight; y += 7) {
                terrain.find_surface({y * kTiledWidth + 64, 64}, tiles.picture(), found);
                for (std::uint32_t n = 0; n < found.count; ++n) {
                    const RayHit one = terrain.intersect(camera.ray(64 + n, y));
                    ASSERT_EQ(found.is_hit[n], one.is_hit);
                    if (!one.is_hit) continue;
                    ++hit_pixels;
                    EXPECT_EQ(found.t[n], one.t);
                    EXPECT_NEAR(found.x[n], one.x, 1e-4);
                    EXPECT_NEAR(found.y[n], one.y, 1e-4);
                    // Heights of thousands a post; near a crease either side's slope is right.
                    EXPECT_NEAR(found.height[n], one.point.height, 2);
                }
            }
        }
    EXPECT_GT(hit_pixels, 500U);
}

/// Whatever lies in the memory of a place that no ray has written.
TEST_F(KernelTerrainTest, RaysThatMeetNothingGiveHeightsInRange) {
    const float nothing = std::numeric_limits<float>::quiet_NaN();
    std::size_t missed = 0;
    for (const CellSurface surface : {CellSurface::bilinear, CellSurface::two_triangles}) {
        KernelTerrain<std::int16_t> terrain;
        terrain.start(field(surface), 1, kTiledWidth, kTiledHeight);
        terrain.set_view(PictureSight::of_grid(test_support::any_camera(random_, 90, 70, kTiledWidth)),
                         view_kernels<std::int16_t>()[0]);
        TracedPlaces places(kTiledWidth, kTiledHeight);
        std::fill(places.cell.begin(), places.cell.end(), HitPicture::kNoCell);
        std::fill(places.u.begin(), places.u.end(), nothing);
        std::fill(places.v.begin(), places.v.end(), nothing);
        SpanSurface found;
        terrain.find_surface({0, 64}, places.picture(), found);
        for (std::uint32_t n = 0; n < found.count; ++n) {
            missed += found.is_hit[n] ? 0 : 1;
            ASSERT_TRUE(std::isfinite(found.height[n]) && std::isfinite(found.x[n]) && std::isfinite(found.y[n])) << n;
        }
    }
    EXPECT_EQ(missed, 2u * 64);
}

TEST_F(KernelTerrainTest, FinerPostsAreTheSamePlaces) {
    KernelTerrain<std::int16_t> fine;
    fine.start(field(CellSurface::bilinear), 2, kTiledWidth, kTiledHeight);
    Ray ray;  // in posts of the scene, of which each is two of the field
    ray.origin = {10.3, 12.2, 30000};
    ray.direction = {0.01f, 0.02f, -1000};
    Ray own = ray;
    own.origin = {20.6, 24.4, 30000};
    own.direction = {0.02f, 0.04f, -1000};
    const Hit hit = trace_ray(field(CellSurface::bilinear), own);
    const RayHit ray_hit = fine.intersect(ray);
    ASSERT_TRUE(ray_hit.is_hit && hit.side != HitSide::none);
    EXPECT_EQ(ray_hit.t, hit.t);
    EXPECT_TRUE(fine.is_hidden(ray));
    EXPECT_EQ(static_cast<std::uint32_t>(ray_hit.x * 2), hit.column);
    EXPECT_EQ(static_cast<std::uint32_t>(ray_hit.y * 2), hit.row);
    KernelTerrain<std::int16_t> posts;
    posts.start(field(CellSurface::bilinear), 1, kTiledWidth, kTiledHeight);
    EXPECT_NEAR(ray_hit.point.slope_x, 2 * posts.intersect(own).point.slope_x, 1e-6);
    ray.direction.z = 1000;
    EXPECT_FALSE(fine.is_hidden(ray));
}

}  // namespace
}  // namespace tedavis::raytrace
