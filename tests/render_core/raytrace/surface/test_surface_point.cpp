#include "render_core/raytrace/surface/surface_point.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <limits>

#include "render_core/raytrace/surface/pixel_footprint.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_surface_point {
namespace {

TEST(SurfacePoint, NormalsOfPlanes) {
    EXPECT_EQ(normal_of({5, 0, 0}, {30, 30, 1}), glm::dvec3(0, 0, 1));
    const glm::dvec3 east = normal_of({5, 30, 0}, {30, 30, 1});  // 45 degrees up to higher columns
    EXPECT_NEAR(east.x, -std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(east.z, std::sqrt(0.5), 1e-15);
    const glm::dvec3 steep = normal_of({0, 1e9, -1e9}, {1e-3, 1e-3, 1e3});
    EXPECT_GT(steep.z, 0);
    EXPECT_NEAR(steep.x * steep.x + steep.y * steep.y + steep.z * steep.z, 1, 1e-12);
    EXPECT_EQ(normal_of({0, 1e-300, 0}, {}), glm::dvec3(-1e-300, 0, 1)) << "no division by what underflows";
}

TEST(SurfacePoint, CellsOfPlaces) {
    const test_support::HeldHeights<float> heights(4, 3, 2.f);
    CellPlace place;
    EXPECT_TRUE(find_cell(heights.grid(), 3, 2, place));
    EXPECT_EQ(place.column, 2u);
    EXPECT_EQ(place.row, 1u);
    EXPECT_EQ(place.u, 1);
    EXPECT_EQ(place.v, 1);
    EXPECT_FALSE(find_cell(heights.grid(), 3.0000001, 1, place));
    EXPECT_FALSE(find_cell(heights.grid(), -1e-9, 1, place));
    EXPECT_FALSE(find_cell(heights.grid(), std::numeric_limits<double>::quiet_NaN(), 1, place));
}

TEST(SurfacePoint, RaysOfAPixel) {
    EXPECT_EQ(rays_along_pixel(0.49, 8), 1u);
    EXPECT_EQ(rays_along_pixel(0.5, 8), 2u);
    EXPECT_EQ(rays_along_pixel(1.1, 8), 3u);
    EXPECT_EQ(rays_along_pixel(1e30, 8), 8u);
    EXPECT_EQ(rays_along_pixel(std::numeric_limits<double>::quiet_NaN(), 8), 1u);
    for (double footprint = 0.5; footprint < 3; footprint += 0.01)
        EXPECT_LT(footprint / rays_along_pixel(footprint, 100), kUndersampledFootprint);
    EXPECT_DOUBLE_EQ(footprint_posts(10000, 0.0006, {30, 20, 1}), 0.3);
}

}  // namespace
}  // namespace tedavis::raytrace::test_surface_point
