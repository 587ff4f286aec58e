#include "render_core/raytrace/picture/picture_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render_core/raytrace/picture/trace_presets.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

TEST(PictureError, IsTheRootOfTheMeanSquare) {
    const std::vector<glm::vec3> black(10, glm::vec3(0));
    std::vector<glm::vec3> other = black;
    EXPECT_EQ(picture_error(black, other), 0);
    other[3] = {0.3f, 0, 0.4f};
    EXPECT_NEAR(picture_error(black, other), std::sqrt(0.25 / 30), 1e-7);
    EXPECT_NEAR(picture_error(other, black), std::sqrt(0.25 / 30), 1e-7);
    other[3] = {9, 0, 0};
    EXPECT_NEAR(picture_error(black, other), std::sqrt(1 / 30.0), 1e-7);
    EXPECT_EQ(picture_error({}, {}), 0);
}

TEST(PictureError, FallsWithFinerPatchesOfTheBicubicSurface) {
    std::vector<TraceSettings> all(4, time_preset());
    all[0].surface.kind = SurfaceKind::bicubic;
    for (std::uint32_t n = 1; n < 4; ++n) {
        all[n].surface.kind = SurfaceKind::approximate_bicubic;
        all[n].surface.subdivisions = 1u << (2 * n - 1);
        all[n].is_surface_stored = true;
    }
    const auto posts = test_support::fractal_heights(65);
    base::SerialWorkers alone;
    std::vector<std::vector<glm::vec3>> light;
    for (const TraceSettings& one : all) {
        test_support::DrawnTrace drawn(posts, {one}, 120, 80);
        drawn.draw_directly(alone);
        light.push_back(drawn.light());
    }
    const double two = picture_error(light[1], light[0]), eight = picture_error(light[2], light[0]),
                 more = picture_error(light[3], light[0]);
    EXPECT_GT(two, 1.5 * eight);
    EXPECT_GT(eight, 1.5 * more);
    EXPECT_GT(more, 0);
}

}  // namespace
}  // namespace tedavis::raytrace
