#include "host_sim/clearance/triangle_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace tedavis::host_sim::test_triangle_place {
namespace {

/// Of a fine grid of the triangle's own points, those in the region.
double least_sampled(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Region& region) {
    constexpr int kSteps = 150;
    double least = INFINITY;
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; i + j <= kSteps; ++j) {
            const glm::dvec3 place = a + (b - a) * (i / double{kSteps}) + (c - a) * (j / double{kSteps});
            bool is_inside = true;
            for (const HalfSpace& half : region) is_inside = is_inside && glm::dot(half.normal, place) >= half.offset;
            if (is_inside) least = std::min(least, glm::length(place));
        }
    return least;
}

TEST(TrianglePlace, IsTheNearestOfManySamples) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto any = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    for (int n = 0; n < 60; ++n) {
        const glm::dvec3 a = any(), b = any(), c = any();
        const double found = glm::length(nearest_to_origin(a, b, c)), sampled = least_sampled(a, b, c, {});
        EXPECT_LE(found, sampled + 1e-12);
        EXPECT_NEAR(found, sampled, 0.03);
    }
}

TEST(TrianglePlace, CountsOnlyThePartInTheRegion) {
    std::mt19937 random(8);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto any = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    int missing = 0;
    for (int n = 0; n < 60; ++n) {
        const glm::dvec3 a = any(), b = any(), c = any();
        const Region region{{any(), 0.3 * number(random)}, {any(), 0.3 * number(random)}};
        const auto found = nearest_to_origin(a, b, c, region);
        const double sampled = least_sampled(a, b, c, region);
        if (!found) {
            ++missing;
            EXPECT_TRUE(std::isinf(sampled));
            continue;
        }
        EXPECT_LE(glm::length(*found), sampled + 1e-12);
        for (const HalfSpace& half : region) EXPECT_GE(glm::dot(half.normal, *found), half.offset - 1e-12);
        const double nearest = std::isfinite(sampled) ? sampled : glm::length(*found);  // a part between the samples
        EXPECT_NEAR(glm::length(*found), nearest, 0.06);
    }
    EXPECT_GT(missing, 5);
    EXPECT_LT(missing, 55);
}

TEST(TrianglePlace, ATriangleWithoutAnAreaIsALineOrAPoint) {
    const glm::dvec3 a(1, 1, 0), b(-1, 1, 0);
    EXPECT_NEAR(glm::length(nearest_to_origin(a, b, b)), 1, 1e-12);
    EXPECT_NEAR(glm::length(nearest_to_origin(a, a, a)), std::sqrt(2.0), 1e-12);
}

}  // namespace
}  // namespace tedavis::host_sim::test_triangle_place
