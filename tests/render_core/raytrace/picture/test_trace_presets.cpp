#include "render_core/raytrace/picture/trace_presets.hpp"

#include <gtest/gtest.h>

#include "tests/support/raytrace/drawn_trace.hpp"

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

TEST(TracePresets, TimeAloneNeedsPrimaryHitsOnly) {
    EXPECT_TRUE(needs_primary_hits_only(time_preset()));
    EXPECT_FALSE(needs_primary_hits_only(memory_preset()));
    EXPECT_FALSE(needs_primary_hits_only(quality_preset()));
    const auto changed = [](auto change) {
        TraceSettings settings = time_preset();
        change(settings);
        return needs_primary_hits_only(settings);
    };
    EXPECT_TRUE(changed([](TraceSettings& s) { s.surface.kind = SurfaceKind::bilinear; }));
    EXPECT_TRUE(changed([](TraceSettings& s) { s.has_data = s.has_capsules = true; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.surface.kind = SurfaceKind::bicubic; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.is_surface_stored = true; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.search = usual_search(SearchKind::cells); }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.antialiasing = Antialiasing::average_mipmap; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.ambient = Ambient::sky_view; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.has_shadows = true; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.mirrors = 1; }));
    EXPECT_FALSE(changed([](TraceSettings& s) { s.paths = 1; }));
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
