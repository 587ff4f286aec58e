#include "render_core/raytrace/view_kernels.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace tedavis::raytrace::test_view_kernels {
namespace {

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

}  // namespace
}  // namespace tedavis::raytrace::test_view_kernels
