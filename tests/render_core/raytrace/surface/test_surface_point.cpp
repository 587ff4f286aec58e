#include "render_core/raytrace/surface/surface_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "render_core/raytrace/surface/pixel_footprint.hpp"
#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/files/hard_case.hpp"
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

/// The naive form: the cross product of two edges of a cell in floats, divided by its length, whose square underflows or
/// overflows.
glm::dvec3 crossed_edges(const SurfacePoint& point, const GridScale& scale) {
    const float rise_x = static_cast<float>(point.slope_x * scale.height_m),
                rise_y = static_cast<float>(point.slope_y * scale.height_m);
    const float across = static_cast<float>(scale.column_m), down = static_cast<float>(scale.row_m);
    const glm::vec3 normal(-down * rise_x, -across * rise_y, across * down);
    return normal / std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
}

/// How far a component of a normal is off; infinite where the normal is no number.
double off_by(const glm::dvec3& normal, const glm::dvec3& truth) {
    const glm::dvec3 apart = normal - truth, off(std::abs(apart.x), std::abs(apart.y), std::abs(apart.z));
    const double most = std::max({off.x, off.y, off.z});
    return most >= 0 && std::isfinite(off.x + off.y + off.z) ? most : std::numeric_limits<double>::infinity();
}

TEST(SurfacePoint, NormalsDoNotDependOnTheUnitOfLength) {
    double ours = 0, naive = 0;
    int naive_off = 0;
    const glm::dvec3 truth = glm::dvec3(-1, 0.5, 1) / 1.5;
    for (const double unit : {1.0, 1e-10, 1e-12, 1e-20, 1e10, 1e20}) {
        const GridScale scale{30 * unit, 20 * unit, unit};
        const SurfacePoint point{7, 30, -10};
        ours = std::max(ours, off_by(normal_of(point, scale), truth));
        const double off = off_by(crossed_edges(point, scale), truth);
        naive = std::max(naive, off);
        naive_off += off > 1e-6 ? 1 : 0;
        EXPECT_TRUE(unit != 1 || off < 1e-6) << "in metres the naive form is right";
    }
    EXPECT_LE(ours, 1e-6);
    EXPECT_GE(naive_off, 4) << "control";
    test_support::record_worst("A27", ours);
    test_support::record_control("A27", naive);
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
