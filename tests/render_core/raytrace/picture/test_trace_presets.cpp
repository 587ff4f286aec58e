#include "render_core/raytrace/picture/trace_presets.hpp"

#include <gtest/gtest.h>

#include "tests/support/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

TEST(TracePresets, MemoryTakesLeastAndQualityMost) {
    const auto posts = test_support::fractal_heights(65);
    const auto bytes_of = [&](const TraceSettings& settings) {
        return test_support::DrawnTrace(posts, {settings}, 64, 32).scene.bytes();
    };
    EXPECT_EQ(bytes_of(memory_preset()), bytes_of(time_preset()));
    EXPECT_LT(bytes_of(memory_preset()) + 7 * 65 * 65 - 100, bytes_of(quality_preset()));
    EXPECT_TRUE(is_kernel_surface(time_preset()) && is_kernel_surface(memory_preset()));
    EXPECT_FALSE(is_kernel_surface(quality_preset()));
}

TEST(TracePresets, TheThreePicturesAreOfTheSamePlace) {
    test_support::DrawnTrace drawn(test_support::fractal_heights(65), {time_preset(), quality_preset(), memory_preset()}, 96, 64);
    base::SerialWorkers alone;
    std::vector<float> t[3];
    for (std::uint32_t n = 0; n < 3; ++n) {
        ASSERT_TRUE(drawn.draw(alone, n));
        t[n].assign(drawn.picture.stages().hits().t.begin(), drawn.picture.stages().hits().t.end());
    }
    for (const int other : {1, 2}) {
        int near = 0, hit_count = 0;
        for (std::size_t n = 0; n < t[0].size(); ++n) {
            if (!std::isfinite(t[0][n])) continue;
            ++hit_count;
            near += std::abs(t[other][n] - t[0][n]) < 1.5f ? 1 : 0;  // cells
        }
        EXPECT_GT(hit_count, 1000);
        EXPECT_GT(near, hit_count * 95 / 100);
    }
}

}  // namespace
}  // namespace tedavis::raytrace
