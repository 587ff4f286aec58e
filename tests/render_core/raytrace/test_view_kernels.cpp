#include "render_core/raytrace/view_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::raytrace::test_view_kernels {
namespace {

using test_support::TracedPicture;
using test_support::ViewedHills;

TEST(ViewKernels, TheWidestIsFirstAndTheScalarOneLast) {
    const auto kernels = view_kernels<std::int16_t>();
    ASSERT_GE(kernels.size(), 2u);
    for (std::size_t n = 1; n < kernels.size(); ++n) EXPECT_LT(kernels[n].lanes, kernels[n - 1].lanes);
    EXPECT_STREQ(kernels[kernels.size() - 1].name, "scalar");
    const auto floats = view_kernels<float>();
    ASSERT_EQ(floats.size(), kernels.size());
    for (std::size_t n = 0; n < floats.size(); ++n) EXPECT_STREQ(floats[n].name, kernels[n].name);
}

TEST(ViewKernels, RaysRunThroughTheMiddlesOfPixels) {
    GridCamera camera;
    camera.origin = {3, 4, 5};
    camera.corner = {-1, 1, 0};
    camera.right = {0.5f, 0, 0};
    camera.down = {0, 0, -0.25f};
    const Ray ray = camera.ray(3, 1);
    EXPECT_EQ(ray.origin, glm::dvec3(3, 4, 5));
    EXPECT_EQ(ray.direction, glm::vec3(0.75f, 1, -0.375f));
}

TEST(ViewKernels, IsTheSameForEveryNumberOfWorkersAndTwiceInARow) {
    const ViewedHills<std::int16_t> hills(300, 211, true);
    const auto field = hills.field(CellSurface::two_triangles);
    std::mt19937 random(8);
    const ViewKernel<std::int16_t>& kernel = view_kernels<std::int16_t>()[0];
    for (int round = 0; round < 6; ++round) {
        const GridCamera camera = test_support::any_camera(random, 300, 211, 190);
        base::SerialWorkers serial;
        const TracedPicture first = test_support::traced_by(kernel, field, camera, 190, 141, serial);
        for (const std::uint32_t threads : {2u, 3u, 7u}) {
            const auto workers = platform::make_thread_workers({threads, nullptr});
            ASSERT_EQ(test_support::traced_by(kernel, field, camera, 190, 141, *workers.value()).differences(first), 0u);
        }
    }
}

TEST(ViewKernels, TheCheckSeesAnotherPicture) {
    const ViewedHills<std::int16_t> hills(100, 100, false);
    GridCamera camera;  // straight down
    camera.origin = {50, 50, 9000};
    camera.corner = {-0.3f, -0.3f, -100};
    camera.right = {0.01f, 0, 0};
    camera.down = {0, 0.01f, 0};
    const auto field = hills.field(CellSurface::two_triangles);
    const TracedPicture one = test_support::traced_singly(field, camera, 64, 64);
    camera.origin.x += 1e-4;
    EXPECT_GT(test_support::traced_singly(field, camera, 64, 64).differences(one), 1000u);
    EXPECT_GT(std::count(one.side.begin(), one.side.end(), HitSide::above), 500);
}

/// Rays that are cut in two go on where they were cut: all kernels, the same surface.
TEST(ViewKernels, GoesOnWithThoseThatHaveMetNothing) {
    const ViewedHills<float> hills(200, 170, true);
    const auto field = hills.field(CellSurface::two_triangles);
    std::mt19937 random(21);
    const std::uint32_t width = 150, height = 90;
    for (int round = 0; round < 8; ++round) {
        const GridCamera camera = test_support::any_camera(random, 200, 170, width);
        const TracedPicture whole = test_support::traced_singly(field, camera, width, height);
        std::vector<TracedPicture> cut;
        for (const ViewKernel<float>& kernel : view_kernels<float>()) {
            TracedPicture picture(width, height);
            clear_pixels(picture.picture(), width, 0, 0, width, height);
            const float middle = 40;
            ViewJob<float> job{&field, &camera, width, height, picture.picture(), {0, middle, 0}, true};
            const ViewTiles tiles(width, height);
            for (std::uint32_t n = 0; n < tiles.count(); ++n) kernel.trace_tile(job, tiles.left(n), tiles.top(n));
            job.span = {middle, std::numeric_limits<float>::infinity(), 0.01f};
            for (std::uint32_t n = 0; n < tiles.count(); ++n) kernel.trace_tile(job, tiles.left(n), tiles.top(n));
            cut.push_back(picture);
            ASSERT_EQ(picture.differences(cut.front()), 0u) << kernel.name;
        }
        std::uint32_t others = 0;
        for (std::size_t n = 0; n < whole.t.size(); ++n)
            if (cut[0].cell[n] != whole.cell[n] || (whole.cell[n] >= 0 && std::abs(cut[0].t[n] / whole.t[n] - 1) > 1e-4f))
                ++others;
        EXPECT_LE(others, 2u) << round;
    }
}

/// Against the place of the ray at that time, in double.
TEST(ViewKernels, SaysWhereInTheCell) {
    const ViewedHills<std::int16_t> hills(200, 170, true);
    const auto field = hills.field(CellSurface::bilinear);
    std::mt19937 random(22);
    const std::uint32_t width = 130, height = 70;
    for (int round = 0; round < 8; ++round) {
        const GridCamera camera = round % 2 == 0 ? test_support::any_camera(random, 200, 170, width)
                                                 : test_support::upright_camera(random, 200, 170, width, round % 4 == 1);
        for (const ViewKernel<std::int16_t>& kernel : view_kernels<std::int16_t>()) {
            TracedPicture all(width, height);
            std::vector<float> u(all.t.size()), v(all.t.size());
            HitPicture picture = all.picture();
            picture.u = u;
            picture.v = v;
            base::SerialWorkers workers;
            test_support::trace_view(field, camera, kernel, workers, width, height, picture);
            for (std::uint32_t n = 0; n < all.t.size(); ++n) {
                if (all.cell[n] < 0) continue;
                const Ray ray = camera.ray(n % width, n / width);
                const glm::dvec3 place = ray.origin + static_cast<double>(all.t[n]) * glm::dvec3(ray.direction);
                ASSERT_NEAR(place.x, all.cell[n] % 199 + u[n], 2e-4) << kernel.name << ' ' << n;
                ASSERT_NEAR(place.y, static_cast<double>(all.cell[n] / 199) + v[n], 2e-4) << kernel.name << ' ' << n;
            }
        }
    }
}

TEST(ViewKernels, GivesTheSameTimesWhereNobodyAsksForMore) {
    const ViewedHills<float> hills(200, 170, true);
    const auto field = hills.field(CellSurface::bilinear);
    std::mt19937 random(24);
    const std::uint32_t width = 75, height = 67;
    base::SerialWorkers workers;
    for (int round = 0; round < 4; ++round) {
        const GridCamera camera = round % 2 == 0 ? test_support::any_camera(random, 200, 170, width)
                                                 : test_support::upright_camera(random, 200, 170, width, round == 1);
        for (const ViewKernel<float>& kernel : view_kernels<float>()) {
            const TracedPicture all = test_support::traced_by(kernel, field, camera, width, height, workers);
            TracedPicture times(width, height);
            test_support::trace_view(field, camera, kernel, workers, width, height, {times.t});
            times.cell = all.cell;
            times.side = all.side;
            ASSERT_EQ(times.differences(all), 0u) << kernel.name;
        }
    }
}

TEST(ViewKernels, MeetsNothingFromBeyondItsReach) {
    const ViewedHills<float> hills(20, 20, false);
    GridCamera camera;
    camera.origin = {1e12, std::numeric_limits<double>::quiet_NaN(), 0};
    camera.corner = {-1, 0, 0};
    const auto field = hills.field(CellSurface::two_triangles);
    base::SerialWorkers workers;
    EXPECT_EQ(test_support::traced_by(view_kernels<float>()[0], field, camera, 9, 9, workers)
                  .differences(test_support::traced_singly(field, camera, 9, 9)),
              0u);
}

}  // namespace
}  // namespace tedavis::raytrace::test_view_kernels
