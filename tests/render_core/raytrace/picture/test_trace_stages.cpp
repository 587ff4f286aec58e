#include "render_core/raytrace/picture/trace_stages.hpp"

#include <gtest/gtest.h>

#include "render_core/raytrace/picture/trace_presets.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kSpannedWidth = 150, kSpannedHeight = 70;

TEST(TraceStages, SpansCoverEveryPixelOnceWhateverTheView) {
    test_support::DrawnTrace drawn(test_support::fractal_heights(65), {time_preset()}, kSpannedWidth, kSpannedHeight);
    for (const std::uint32_t camera : {0u, 3u}) {
        drawn.set_camera(test_support::trace_cameras(65, kSpannedWidth, kSpannedHeight)[camera]
                             .in_steps(test_support::steps_a_cell(65))
                             .view());
        ASSERT_TRUE(drawn.begin());
        const TraceStages<std::int16_t>& stages = drawn.picture.stages();
        std::vector<int> covered(std::size_t{kSpannedWidth} * kSpannedHeight);
        for (std::uint32_t n = 0; n < stages.tiles() * stages.kSpansOfTile; ++n) {
            const PixelSpan span = stages.span(n);
            for (std::uint32_t k = 0; k < span.count; ++k) {
                ++covered[span.first + k];
                ASSERT_EQ(stages.place_of(span.first + k), n * PixelSpan::kMax + k);
            }
        }
        EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), static_cast<std::ptrdiff_t>(covered.size())) << camera;
    }
}

TEST(TraceStages, SupersampledPixelsAreMeansOfALargerPicture) {
    constexpr std::uint32_t kFewWide = 24, kFewHigh = 18, kAlong = 2;
    TraceSettings settings = time_preset();
    settings.antialiasing = Antialiasing::supersampling;
    settings.rays_along = kAlong;
    const auto posts = test_support::fractal_heights(129);
    test_support::DrawnTrace drawn(posts, {settings, time_preset()}, kFewWide, kFewHigh);
    test_support::DrawnTrace larger(posts, {time_preset()}, kAlong * kFewWide, kAlong * kFewHigh);
    GridCamera camera = drawn.scene.sight().camera;
    camera.right /= static_cast<float>(kAlong);
    camera.down /= static_cast<float>(kAlong);
    larger.set_camera(camera);
    base::SerialWorkers alone;
    drawn.draw_directly(alone, 1);
    const std::vector<glm::vec3> once = drawn.light();
    drawn.draw_directly(alone, 0);
    larger.draw_directly(alone);
    const std::vector<glm::vec3> many = drawn.light(), rays = larger.light();
    std::size_t resampled = 0, right = 0;
    for (std::uint32_t y = 0; y < kFewHigh; ++y)
        for (std::uint32_t x = 0; x < kFewWide; ++x) {
            glm::vec3 mean(0);
            for (std::uint32_t n = 0; n < kAlong * kAlong; ++n)
                mean += rays[(y * kAlong + n / kAlong) * kAlong * kFewWide + x * kAlong + n % kAlong];
            mean /= static_cast<float>(kAlong * kAlong);
            const std::size_t at = y * kFewWide + x;
            if (many[at] == once[at]) continue;  // near, or what meets nothing
            ++resampled;
            right += glm::length(many[at] - mean) < 1e-3f ? 1 : 0;
        }
    EXPECT_GT(resampled, 100U);
    EXPECT_GE(right + 3, resampled);  // rays on a crease may fall to either side of it, by rounding
}

TEST(TraceStages, AMirrorShowsWhatAnEyeBehindItWouldSee) {
    // Level water below a ridge: a pixel of the water has its own light and the mirror's share of what the ray from there sees.
    test_support::HeightField<std::int16_t> posts(65, 65);
    for (std::uint32_t row = 0; row < 65; ++row)
        for (std::uint32_t column = 50; column < 65; ++column)
            posts.at(column, row) = static_cast<std::int16_t>(2000 * (column - 49));
    TraceSettings settings = time_preset(), plain = settings;
    settings.mirrors = 2;
    test_support::DrawnTrace drawn(posts, {settings, plain}, 40, 30);
    drawn.look.material.mirror = 0.5f;
    drawn.look.mirror_below = 0;
    base::SerialWorkers alone;
    drawn.draw_directly(alone, 1);
    const std::vector<glm::vec3> without = drawn.light();
    drawn.draw_directly(alone, 0);
    const std::vector<glm::vec3> with = drawn.light();
    const TracedTerrain& terrain = drawn.scene.terrain(plain);
    std::size_t of_sky = 0, of_ridge = 0;
    for (std::uint32_t y = 0; y < 30; ++y)
        for (std::uint32_t x = 0; x < 40; ++x) {
            const Ray ray = drawn.scene.sight().camera.ray(x, y);
            const RayHit hit = terrain.intersect(ray);
            const std::size_t at = y * 40 + x;
            if (!hit.is_hit || hit.point.height > 0) {
                EXPECT_EQ(with[at], without[at]);
                continue;
            }
            Ray behind = ray;
            behind.origin = {hit.x, hit.y, 0.1};
            behind.direction.z = -ray.direction.z;
            const RayHit seen = terrain.intersect(behind);
            if (!seen.is_hit) {
                ++of_sky;
                const glm::vec3 right = 0.5f * without[at] + 0.5f * drawn.look.background;
                EXPECT_LT(glm::length(with[at] - right), 1e-3f);
            } else {
                ++of_ridge;
                EXPECT_NE(with[at], without[at]);
            }
        }
    EXPECT_GT(of_sky, 20U);
    EXPECT_GT(of_ridge, 20U);
}

}  // namespace
}  // namespace tedavis::raytrace
