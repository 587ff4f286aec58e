// The trap that proves "no heap after the start": it must see every kind of allocation, ours and the driver's apart, and a
// frame of the GL layer must cost none of ours.
#include "host_sim/heap_trap/heap_trap.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "platform/surface_factory.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/base/driver_scope.hpp"
#include "render_core/gl/readback.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::test_heap_trap {
namespace {

using host_sim::HeapCounts;
using host_sim::HeapTrap;
using test_support::GlSession;
using test_support::TriangleScene;

/// Keeps the compiler from leaving out an allocation that nobody uses.
template <class T>
T* kept(T* pointer) {
    asm volatile("" : : "g"(pointer) : "memory");
    return pointer;
}

template <class Work>
HeapCounts counted(Work work) {
    HeapTrap trap;
    work();
    trap.close();
    return trap.counts();
}

TEST(HeapTrap, SeesEveryKindOfAllocation) {
    EXPECT_EQ(counted([] {}).ours, 0u);
    EXPECT_EQ(counted([] { std::free(kept(std::malloc(8))); }).ours, 1u);
    EXPECT_EQ(counted([] { std::free(kept(std::calloc(2, 8))); }).ours, 1u);
    EXPECT_EQ(counted([] { std::free(kept(std::realloc(nullptr, 8))); }).ours, 1u);
    EXPECT_EQ(counted([] { std::free(kept(std::aligned_alloc(64, 64))); }).ours, 1u);
    EXPECT_EQ(counted([] { std::free(kept(memalign(64, 64))); }).ours, 1u);
    EXPECT_EQ(counted([] {
                  void* memory = nullptr;
                  if (posix_memalign(&memory, 64, 64) == 0) std::free(kept(memory));
              }).ours,
              1u);
    EXPECT_EQ(counted([] { delete kept(new int(3)); }).ours, 1u);
    EXPECT_EQ(counted([] { delete[] kept(new char[100]); }).ours, 1u);
    EXPECT_EQ(counted([] {
                  std::vector<int> numbers(50);
                  kept(numbers.data());
              }).ours,
              1u);
}

TEST(HeapTrap, SeesNothingWhenClosed) {
    HeapTrap trap;
    trap.close();
    std::free(kept(std::malloc(8)));
    EXPECT_EQ(trap.counts().ours, 0u);
    EXPECT_EQ(trap.first_of_ours(), "");
}

TEST(HeapTrap, CountsTheDriversApart) {
    const HeapCounts counts = counted([] {
        const base::DriverScope driver;
        std::free(kept(std::malloc(8)));
        const base::DriverScope nested;
        std::free(kept(std::malloc(8)));
    });
    EXPECT_EQ(counts.ours, 0u);
    EXPECT_EQ(counts.driver, 2u);
    EXPECT_EQ(base::driver_depth, 0);
}

TEST(HeapTrap, SaysWhoAllocatedFirst) {
    HeapTrap trap;
    std::free(kept(std::malloc(8)));
    trap.close();
    EXPECT_NE(trap.first_of_ours().find("test_host_sim"), std::string::npos);
}

void allocate_once(void*, std::uint32_t) { std::free(kept(std::malloc(8))); }
void do_nothing(void*, std::uint32_t) {}

TEST(HeapTrap, SeesWorkersThatWatchThemselves) {
    auto watched = platform::make_thread_workers({3, &HeapTrap::watch_this_thread});
    ASSERT_TRUE(watched.ok());
    watched.value()->parallel_for(16, &do_nothing, nullptr);  // all threads have started
    EXPECT_EQ(counted([&] { watched.value()->parallel_for(16, &allocate_once, nullptr); }).ours, 16u);
    EXPECT_EQ(counted([&] { watched.value()->parallel_for(16, &do_nothing, nullptr); }).ours, 0u) << "fork and join are free";
}

TEST(HeapTrap, DoesNotSeeThreadsOfOthers) {
    std::thread stranger;
    HeapTrap trap;
    {
        const base::DriverScope driver;  // making the thread allocates here
        stranger = std::thread([] { std::free(kept(std::malloc(8))); });
        stranger.join();
    }
    trap.close();
    EXPECT_EQ(trap.counts().ours, 0u);
}

TEST(HeapTrap, FramesOfTheGlLayerCostNoneOfOurs) {
    for (const std::string& backend : test_support::headless_backends()) {
        GlSession at(backend, "es3-mid");
        TriangleScene scene(at.gl, at.device.budget);
        std::vector<std::uint8_t> pixels(std::size_t{4} * 64 * 48);
        at.gl.seal();
        HeapTrap trap;
        bool good = true;
        for (int frame = 0; frame < 50; ++frame) {
            at.gl.begin_frame();
            scene.draw(at.gl, *at.surface);
            good = good && at.surface->present() == base::SurfaceState::ready;
            good = good && gl::read_pixels(at.gl, 64, 48, pixels);
        }
        at.surface->release_current();
        good = good && at.surface->make_current();
        at.gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          nullptr);  // denied: counted without heap
        trap.close();
        EXPECT_TRUE(good);
        EXPECT_EQ(trap.counts().ours, 0u) << backend << "\n" << trap.first_of_ours();
        EXPECT_GT(trap.counts().driver, 0u) << "the control: this driver does allocate";
        EXPECT_EQ(at.gl.denied().total, 1u);
    }
}

}  // namespace
}  // namespace tedavis::test_heap_trap
