#include "render_core/raytrace/shading/ray_capsule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_ray_capsule {
namespace {

using test_support::Dice;

using Real = long double;
struct Point {
    Real x, y, z;
};

/// From a point to the axis, less the radius.
Real distance(const Point& p, const Capsule& c) {
    const Point axis{Real(c.to.x) - c.from.x, Real(c.to.y) - c.from.y, Real(c.to.z) - c.from.z};
    const Point from{p.x - c.from.x, p.y - c.from.y, p.z - c.from.z};
    const Real square = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
    Real h = square > 0 ? (from.x * axis.x + from.y * axis.y + from.z * axis.z) / square : 0;
    h = std::min<Real>(std::max<Real>(h, 0), 1);
    const Point d{from.x - h * axis.x, from.y - h * axis.y, from.z - h * axis.z};
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) - c.radius;
}

Point on_ray(const glm::dvec3& o, const glm::dvec3& d, Real t) { return {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z}; }

glm::dvec3 random_point(Dice& dice, double size) {
    return {dice.between(-size, size), dice.between(-size, size), dice.between(-size, size)};
}

/// By sphere tracing in long double: the distance says how far a step cannot pass it. Negative: missed.
Real stepped(const glm::dvec3& origin, const glm::dvec3& unit, const Capsule& capsule, Real& nearest) {
    Real t = 0;
    nearest = 1e30L;
    for (int n = 0; n < 20000 && t < 100; ++n) {
        const Real left = distance(on_ray(origin, unit, t), capsule);
        nearest = std::min(nearest, left);
        if (left < 1e-13L) return t;
        t += left;
    }
    return -1;
}

TEST(RayCapsule, IsWhereStepsInLongDoubleEnd) {
    Dice dice(1);
    int hits = 0, compared = 0;
    for (int n = 0; n < 20000; ++n) {
        const Capsule capsule{random_point(dice, 3), random_point(dice, 3), dice.between(0.1, 1.5)};
        const glm::dvec3 origin = random_point(dice, 12), unit = glm::normalize(random_point(dice, 3) - origin);
        if (distance(on_ray(origin, unit, 0), capsule) <= 0) continue;
        Real nearest = 0;
        const Real t = stepped(origin, unit, capsule, nearest);
        const CapsuleHit hit = ray_capsule(origin, unit, 0, capsule);
        ++compared;
        if (nearest > 1e-12L && nearest < 1e-6L) continue;  // touches: either is right
        ASSERT_EQ(hit.is_hit, t >= 0) << n;
        if (!hit.is_hit) continue;
        ++hits;
        EXPECT_NEAR(static_cast<double>(distance(on_ray(origin, unit, hit.t), capsule)), 0, 1e-10);
        EXPECT_NEAR(hit.t, static_cast<double>(t), 1e-5);
        EXPECT_NEAR(glm::length(hit.normal), 1, 1e-12);
        EXPECT_LT(glm::dot(hit.normal, unit), 1e-6) << "faces the ray";
    }
    EXPECT_GT(hits, 3000);
    EXPECT_GT(compared, 15000);
}

TEST(RayCapsule, FromWithinItMeetsTheInside) {
    Dice dice(2);
    for (int n = 0; n < 2000; ++n) {
        const Capsule capsule{random_point(dice, 3), random_point(dice, 3), 1};
        const glm::dvec3 origin = capsule.from + dice.unit() * (capsule.to - capsule.from);
        const glm::dvec3 direction = random_point(dice, 5);
        const CapsuleHit hit = ray_capsule(origin, direction, 0, capsule);
        ASSERT_TRUE(hit.is_hit && hit.is_from_inside);
        EXPECT_NEAR(static_cast<double>(distance(on_ray(origin, direction, hit.t), capsule)), 0, 1e-10);
        EXPECT_FALSE(ray_capsule(origin, direction, hit.t + 1e-6, capsule).is_hit);
    }
}

TEST(RayCapsule, FarRaysKeepTheirDigits) {
    const Capsule tube{{1e6, 0, 0}, {1e6, 1000, 0}, 5};
    const CapsuleHit hit = ray_capsule({0, 500, 4.9999}, {1, 0, 0}, 0, tube);
    ASSERT_TRUE(hit.is_hit);
    EXPECT_NEAR(hit.t, 1e6 - std::sqrt(25 - 4.9999 * 4.9999), 1e-8);
    EXPECT_FALSE(ray_capsule({0, 500, 5.0000001}, {1, 0, 0}, 0, tube).is_hit);
}

TEST(RayCapsule, ABallAndARayAlongTheAxis) {
    const Capsule ball{{0, 0, 0}, {0, 0, 0}, 2};
    EXPECT_NEAR(ray_capsule({-10, 0, 0}, {2, 0, 0}, 0, ball).t, 4, 1e-12);
    const Capsule tube{{0, 0, 0}, {7, 0, 0}, 2};
    EXPECT_NEAR(ray_capsule({-10, 1, 0}, {1, 0, 0}, 0, tube).t, 10 - std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(ray_capsule({3, 0, 9}, {0, 0, -1}, 0, tube).t, 7, 1e-12);
    EXPECT_NEAR(ray_capsule({3, 0, 9}, {0, 0, -1}, 0, tube).along, 3 / 7.0, 1e-12);
    EXPECT_FALSE(ray_capsule({3, 0, 9}, {0, 0, 1}, 0, tube).is_hit);
    EXPECT_EQ(ray_capsule({3, 0, 9}, {0, 0, -1}, 0, tube).normal, glm::dvec3(0, 0, 1));
}

}  // namespace
}  // namespace tedavis::raytrace::test_ray_capsule
