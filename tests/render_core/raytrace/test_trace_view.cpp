#include "render_core/raytrace/trace_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/traced_view.hpp"

namespace tedavis::raytrace::test_trace_view {
namespace {

using test_support::TracedPicture;
using test_support::ViewedHills;

TEST(TraceView, IsTheSameForEveryNumberOfWorkersAndTwiceInARow) {
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

TEST(TraceView, TheCheckSeesAnotherPicture) {
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

TEST(TraceView, RefusesSizesAndArenasThatDoNotDo) {
    std::vector<std::uint64_t> memory(ViewTracer<float>::bytes_needed(640, 480) / 8 + 1);
    ViewTracer<float> tracer;
    base::Arena enough(memory.data(), memory.size() * 8), less(memory.data(), 1000);
    EXPECT_FALSE(tracer.start(0, 480, enough));
    EXPECT_FALSE(tracer.start(ViewTracer<float>::kMostSide + 1, 480, enough));
    EXPECT_FALSE(tracer.start(640, 480, less));
    EXPECT_TRUE(tracer.start(640, 480, enough));
    EXPECT_LT(memory.size() * 8, 640u * 480u);
}

}  // namespace
}  // namespace tedavis::raytrace::test_trace_view
