#include "host_sim/terrain_builder/attributes/direct_light.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/terrain/attribute_terrain.hpp"

namespace tedavis::host_sim::test_direct_light {
namespace {

using terrain::PostClass;
using test_support::make_tile;
using test_support::post_of;

FixedLight light_from(double azimuth_deg, double elevation_deg) {
    FixedLight light;
    light.azimuth_rad = base::radians(azimuth_deg);
    light.elevation_rad = base::radians(elevation_deg);
    return light;
}

/// A wall 200 m high from column 10 on, which runs north.
AttributeTile wall_tile() {
    return make_tile(12, 4, 20, 25, [](int i, int) { return i >= 10 ? 200.0 : 0.0; });
}

TEST(DirectLight, IsLambertsCosineWhereNothingHidesTheLight) {
    const auto waves = [](int i, int j) { return 300 + 6 * std::sin(0.3 * i) + 5 * std::cos(0.2 * j + 0.1 * i); };
    const AttributeTile tile = make_tile(30, 20, 20, 25, waves);
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    for (const FixedLight& light : {light_from(315, 45), light_from(100, 30), light_from(0, 89), light_from(40, 90)}) {
        const HalfPlanes direct = direct_light(planes, gradients, light, {});
        const long double along = std::cos(light.elevation_rad);
        for (int row = -kHorizonReach; row < tile.rows + kHorizonReach; ++row) {
            for (int column = -kHorizonReach; column < tile.columns + kHorizonReach; ++column) {
                const std::size_t at = planes.at(column, row);
                const long double e = gradients.east[at], n = gradients.north[at];
                const long double cosine = (along * (-e * std::sin(light.azimuth_rad) - n * std::cos(light.azimuth_rad)) +
                                            std::sin(light.elevation_rad)) /
                                           std::sqrt(1 + e * e + n * n);
                ASSERT_NEAR(direct[at_post][at], static_cast<double>(cosine), 1e-6);
            }
        }
    }
}

// The wall's shadow ends where its edge is seen at the light's elevation.
TEST(DirectLight, AWallCastsItsShadowAndNoMore) {
    const AttributeTile tile = wall_tile();
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    const double level = std::sin(base::radians(60));
    const HalfPlanes direct = direct_light(planes, gradients, light_from(90, 60), {});
    for (int column = 0; column < 9; ++column) {
        const double edge = std::atan(200.0 / (20 * (10 - column)));
        EXPECT_NEAR(direct[at_post][planes.at(column, 2)], edge > base::radians(60) ? 0 : level, 1e-6) << column;
    }
    const HalfPlanes west = direct_light(planes, gradients, light_from(270, 60), {});
    EXPECT_NEAR(west[at_post][planes.at(8, 2)], level, 1e-6) << "the wall lies behind";
}

TEST(DirectLight, TheEdgeOfAShadowIsAsSoftAsTheDisc) {
    const AttributeTile tile = wall_tile();
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    const double edge_deg = base::degrees(std::atan(1.0 - 200 / (2 * 6371000.0)));  // seen from column 0
    const auto lit = [&](double above_deg) {
        const FixedLight light = light_from(90, edge_deg + above_deg);
        return direct_light(planes, gradients, light, {})[at_post][planes.at(0, 2)] / std::sin(light.elevation_rad);
    };
    EXPECT_NEAR(lit(0), 0.5, 1e-3);
    EXPECT_NEAR(lit(0.13325), 0.75, 3e-3);
    EXPECT_NEAR(lit(-0.13325), 0.25, 3e-3);
    EXPECT_EQ(lit(-0.3), 0);
    EXPECT_NEAR(lit(0.3), 1, 1e-6);
}

TEST(DirectLight, AFarHorizonHidesTheLightToo) {
    FarHorizons above;
    above.columns = 6;
    above.rows = 2;
    above.lines.resize(static_cast<std::size_t>(6 + 2 * kFarMargin) * (2 + 2 * kFarMargin));
    above.known.assign(above.lines.size(), 1);
    const AttributeTile tile = make_tile(12, 4, 20, 25, [](int, int) { return 0.0; });
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    const auto lit = [&](float far_tangent) {
        for (FarLines& lines : above.lines) lines.intercept.fill(far_tangent);
        return direct_light(planes, gradients, light_from(33, 30), test_support::view_of(above))[at_post][planes.at(3, 1)];
    };
    EXPECT_NEAR(lit(0.5f), 0.5, 1e-6) << "26.6 degrees";
    EXPECT_EQ(lit(0.7f), 0) << "35 degrees";
}

using DirectLightDeathTest = ::testing::Test;
TEST(DirectLightDeathTest, TheLightStandsAboveTheHorizontal) {
    const AttributeTile tile = wall_tile();
    const HeightPlanes planes(tile);
    const Gradients gradients(planes);
    EXPECT_DEATH((void)direct_light(planes, gradients, light_from(10, 0), {}), "elevation_rad > 0");
    EXPECT_DEATH((void)direct_light(planes, gradients, light_from(10, 91), {}), "elevation_rad > 0");
}

TEST(DirectLight, PostsWithoutHeightAreLitAsLevelGround) {
    AttributeTile tile = wall_tile();
    tile.post_class[post_of(tile, 9, 2)] = PostClass::void_;
    const HeightPlanes planes(tile);
    const HalfPlanes direct = direct_light(planes, Gradients(planes), light_from(90, 20), {});
    EXPECT_NEAR(direct[at_post][planes.at(9, 2)], std::sin(base::radians(20)), 1e-6);
    EXPECT_EQ(direct[half_east][planes.at(8, 2)], 0) << "half way counts the post with a height alone, which is in shadow";
    EXPECT_EQ(direct[at_post][planes.at(9, 1)], 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_direct_light
