#include "render_core/draw/data/ground_section.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_ground_section {
namespace {

using test_support::scene_point;

/// Rises to the east.
class Slope final : public scene::Ground {
public:
    double height_m(double, double longitude_rad) override { return 1e6 * (longitude_rad - base::radians(9.8)); }
    double undulation_m(double, double) override { return 0; }
};

TEST(GroundSection, FlatWaysAreThoseOfGeodesics) {
    const scene::ScenePoint from = scene_point(46.8, 179.99, 0), to = scene_point(46.81, -179.99, 0);
    const glm::dvec2 way = flat_offset(from, to);
    double distance_m = 0, azimuth_deg = 0, unused = 0;
    GeographicLib::Geodesic::WGS84().Inverse(46.8, 179.99, 46.81, -179.99, distance_m, azimuth_deg, unused);
    EXPECT_NEAR(glm::length(way), distance_m, 1);
    EXPECT_NEAR(base::degrees(std::atan2(way.x, way.y)), azimuth_deg, 0.1);
    EXPECT_NEAR(glm::length(flat_offset(moved(from, way), to)), 0, 1e-6);
    EXPECT_LT(glm::length(right_of(way) - glm::dvec2(way.y, -way.x) / glm::length(way)), 1e-12);
    EXPECT_EQ(right_of(glm::dvec2(0)), glm::dvec2(0));
    EXPECT_NEAR(glm::length(flat_offset(between(from, to, 0.25), from)), 0.25 * glm::length(way), 1);
}

TEST(GroundSection, IsAsHighAsTheHighestGroundBelow) {
    test_support::ElementOfTest test(test_support::small_points());
    Slope slope;
    const ElementInput made = test.input();
    const ElementInput input{made.element, made.group, made.layer, slope, made.missing};
    const scene::ScenePoint middle = scene_point(46.8, 9.801, std::numeric_limits<float>::quiet_NaN());
    const GroundSection narrow = ground_section(input, middle, {0, 0}), wide = ground_section(input, middle, {100, 0});
    EXPECT_NEAR(narrow.height_m, 1e6 * base::radians(0.001) + kStripLift_m, 1e-6);
    EXPECT_GT(wide.height_m, narrow.height_m + 10);
    const SectionEnds ends = section_ends(wide);
    EXPECT_NEAR(glm::distance(ends.left, ends.right), 200, 0.1);
    EXPECT_GT(glm::dot(ends.right_normal, ends.right - ends.left), 0) << "leans outwards";
    EXPECT_LT(glm::dot(ends.left_normal, ends.right - ends.left), 0);
    double latitude_deg = 0, longitude_deg = 0, height_m = 0;
    GeographicLib::Geocentric::WGS84().Reverse(ends.left.x, ends.left.y, ends.left.z, latitude_deg, longitude_deg, height_m);
    EXPECT_NEAR(height_m, wide.height_m, 1e-3) << "level";
}

TEST(GroundSection, WithoutGroundItHasTheStatedHeightOrNone) {
    test_support::ElementOfTest test(test_support::small_areas());
    test.ground.is_known = false;
    EXPECT_NEAR(ground_section(test.input(), scene_point(46.8, 9.8, 700), {10, 0}).height_m, 700 + 50 + kStripLift_m, 1e-6);
    EXPECT_FALSE(ground_section(test.input(), scene_point(46.8, 9.8, std::numeric_limits<float>::quiet_NaN()), {10, 0}).is_known);
}

}  // namespace
}  // namespace tedavis::draw::test_ground_section
