#include "render_core/raytrace/shading/aperture_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/raytrace/shading/arc_functions.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_aperture_light {
namespace {

const glm::dvec3 kUp(0, 0, 1);

glm::dvec3 at_elevation(double angle_rad) { return {std::cos(angle_rad), 0, std::sin(angle_rad)}; }

TEST(ApertureLight, AnOpenPlaceSeesSunAndSky) {
    const ApertureLight light = aperture_light({kUp, 0}, kUp, at_elevation(0.5), kSunRadius_rad, OverlapKind::exact);
    EXPECT_EQ(light.sun, 1);
    EXPECT_EQ(light.sky, 1);
}

TEST(ApertureLight, AClosedPlaceSeesNothing) {
    for (const OverlapKind kind : {OverlapKind::exact, OverlapKind::smooth}) {
        const ApertureLight light = aperture_light({kUp, 1}, kUp, at_elevation(0.5), kSunRadius_rad, kind);
        EXPECT_EQ(light.sun, 0);
        EXPECT_EQ(light.sky, 0);
    }
}

TEST(ApertureLight, TheSunSetsBehindTheEdgeOverItsOwnWidth) {
    // Half of all directions are open: the sun sets at the horizon.
    double last = 2;
    for (double elevation = 0.01; elevation > -0.01; elevation -= 0.0005) {
        const double sun = aperture_light({kUp, 0}, kUp, at_elevation(elevation), kSunRadius_rad, OverlapKind::exact).sun;
        EXPECT_LE(sun, last);
        last = sun;
        EXPECT_TRUE(elevation < kSunRadius_rad || sun == 1);
        EXPECT_TRUE(elevation > -kSunRadius_rad || sun == 0);
    }
    EXPECT_NEAR(aperture_light({kUp, 0}, kUp, at_elevation(0), kSunRadius_rad, OverlapKind::exact).sun, 0.5, 1e-6);
    EXPECT_NEAR(aperture_light({kUp, 0}, kUp, at_elevation(0), kSunRadius_rad, OverlapKind::smooth).sun, 0.5, 1e-6);
}

TEST(ApertureLight, ASunWithoutSizeIsSeenOrNot) {
    const Aperture narrow{kUp, std::cos(0.3)};
    EXPECT_EQ(aperture_light(narrow, kUp, at_elevation(kArcPi / 2 - 0.29), 0, OverlapKind::exact).sun, 1);
    EXPECT_EQ(aperture_light(narrow, kUp, at_elevation(kArcPi / 2 - 0.31), 0, OverlapKind::exact).sun, 0);
    EXPECT_EQ(aperture_light(narrow, kUp, -kUp, 0, OverlapKind::exact).sun, 0);
}

TEST(ApertureLight, TheSkyThroughAConeIsTheLightOfItsDirections) {
    test_support::Dice dice(1);
    for (const double radius : {0.2, 0.6, 1.0}) {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(0.2, -0.1, 1)), normal = glm::normalize(glm::dvec3(-0.1, 0, 1));
        double light = 0;
        constexpr int kRays = 300000;
        for (int n = 0; n < kRays; ++n) {
            const double z = dice.unit(), turn = dice.unit() * 2 * kArcPi, flat = std::sqrt(1 - z * z);
            const glm::dvec3 ray(flat * std::cos(turn), flat * std::sin(turn), z);
            if (glm::dot(ray, axis) >= std::cos(radius)) light += glm::dot(ray, normal);
        }
        EXPECT_NEAR(aperture_light({axis, std::cos(radius)}, normal, kUp, 0.1, OverlapKind::exact).sky, 2 * light / kRays, 5e-3)
            << radius;
    }
}

TEST(ApertureLight, NoInputMakesItNan) {
    for (const double cosine : {-0.1, 0.0, 0.5, 1.0, 1.1})
        for (const glm::dvec3& sun : {kUp, -kUp, at_elevation(0.3)})
            for (const double radius : {0.0, 1e-9, 0.00465, 1.0}) {
                const ApertureLight light = aperture_light({kUp, cosine}, kUp, sun, radius, OverlapKind::exact);
                EXPECT_TRUE(light.sun >= 0 && light.sun <= 1 && light.sky >= 0 && light.sky <= 1);
            }
}

}  // namespace
}  // namespace tedavis::raytrace::test_aperture_light
