#include "render_core/policy/panel_lighting.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::policy::test_panel_lighting {
namespace {

constexpr std::int64_t kDay_ns = 86'400'000'000'000;
const base::Time kEquinoxNoon{(20'168 * kDay_ns) + kDay_ns / 2};  // 2025-03-21T12:00Z, the sun over Greenwich

earth::Geodetic at_longitude(double longitude_deg) { return {0, base::radians(longitude_deg), {0}}; }

design::ViewEffects with(design::PanelLighting lighting) {
    design::ViewEffects effects;
    effects.lighting = lighting;
    return effects;
}

TEST(PanelLighting, IsWhatTheDesignSays) {
    const glm::dvec3 day(1, 1, 1);
    EXPECT_EQ(panel_light(with(design::PanelLighting::day), at_longitude(180), kEquinoxNoon).white, day);
    EXPECT_NEAR(panel_light(with(design::PanelLighting::night), at_longitude(0), kEquinoxNoon).white.x, 0x58 / 255.0, 1e-12);
    EXPECT_NEAR(panel_light(with(design::PanelLighting::dusk), at_longitude(0), kEquinoxNoon).white.z, 0x98 / 255.0, 1e-12);
}

/// A degree of longitude is a degree of the sun's height, at the equator on the equinox.
TEST(PanelLighting, FollowsTheSunWithoutAJump) {
    const design::ViewEffects effects = with(design::PanelLighting::automatic);
    const auto white = [&](double longitude_deg) {
        return panel_light(effects, at_longitude(longitude_deg), kEquinoxNoon).white;
    };
    EXPECT_EQ(white(0), glm::dvec3(1, 1, 1));
    EXPECT_EQ(white(-75), glm::dvec3(1, 1, 1)) << "15 degrees high";
    EXPECT_NEAR(white(150).x, 0x58 / 255.0, 1e-12) << "night";
    double last = 1;
    for (double longitude_deg = 60; longitude_deg < 120; longitude_deg += 0.25) {
        const double now = white(longitude_deg).x;
        EXPECT_LE(now, last + 1e-12);
        EXPECT_LT(last - now, 0.02);
        last = now;
    }
    EXPECT_NEAR(white(91.85).x, 0xB8 / 255.0, 0.03) << "dusk at the horizon: the sun is 7 minutes late";
}

TEST(PanelLighting, WithoutADateItIsDay) {
    const PanelLight light = panel_light(with(design::PanelLighting::automatic), at_longitude(180), base::Time{5});
    EXPECT_FALSE(light.has_date);
    EXPECT_EQ(light.white, glm::dvec3(1, 1, 1));
}

}  // namespace
}  // namespace tedavis::policy::test_panel_lighting
