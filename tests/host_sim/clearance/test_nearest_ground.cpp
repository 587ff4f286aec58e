#include "host_sim/clearance/nearest_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/terrain/brute_ground.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_nearest_ground {
namespace {

const Region kNotLower{{{0, 0, -1}, 0}};

struct RoughGround {
    Raster raster = test_support::make_rough_raster(97, 97);
    test_support::BuiltDatabase built{raster};
    test_support::BruteGround brute{raster, built.database};
    NearestGround nearest{built.database};

    [[nodiscard]] earth::Geodetic place(double i, double j, double msl_m) const {
        const double latitude = base::radians(raster.north_deg - j * raster.step_lat_deg),
                     longitude = base::radians(raster.west_deg + i * raster.step_lon_deg);
        return {latitude, longitude, {msl_m + built.database.undulation(latitude, longitude).m}};
    }
};

/// Its samples are 6 m apart, and at the nearest place the distance changes with the square of what they miss.
constexpr double kMissed_m = 0.5;

TEST(NearestGround, IsThatOfBruteForce) {
    RoughGround ground;
    std::mt19937 random(3);
    for (int n = 0; n < 16; ++n) {
        const double i = 15 + random() % 65, j = 15 + random() % 65, above_m = 5 + random() % 900;
        const earth::Geodetic at = ground.place(i, j, 0);
        const double ground_m = ground.brute.height_m(at.latitude_rad, at.longitude_rad);
        const earth::Geodetic from = ground.place(i, j, ground_m + above_m);
        const auto found = ground.nearest.find(from, 1e5);
        ASSERT_TRUE(found);
        const double brute_m = ground.brute.distance_m(earth::to_ecef(from));
        EXPECT_LE(found->distance_m, brute_m + 0.02);
        EXPECT_NEAR(found->distance_m, brute_m, kMissed_m) << n;
        EXPECT_LE(found->distance_m, above_m + 0.02) << "never farther than the ground below";
        const double there_m = ground.brute.height_m(found->place.latitude_rad, found->place.longitude_rad);
        EXPECT_NEAR(found->height_msl_m, there_m, 0.1) << "it lies on the ground";
        const glm::dvec3 way = earth::to_ecef(found->place) - earth::to_ecef(from);
        EXPECT_NEAR(glm::length(way), found->distance_m, 1e-3);
    }
}

TEST(NearestGround, OfARegionIsThatOfBruteForceToo) {
    RoughGround ground;
    std::mt19937 random(4);
    int found_in_all = 0;
    for (int n = 0; n < 12; ++n) {
        const earth::Geodetic from = ground.place(15 + random() % 65, 15 + random() % 65, 900 + random() % 600);
        const glm::dmat3 axes = earth::north_east_down(from.latitude_rad, from.longitude_rad);
        const double towards = 0.5 * n;
        const Region region{{{0, 0, -1}, 0}, {{std::cos(towards), std::sin(towards), 0}, 0}};
        const double brute_m = ground.brute.distance_m(earth::to_ecef(from), [&](const glm::dvec3& way) {
            return -glm::dot(way, axes[2]) >= 0 &&
                   glm::dot(way, axes[0]) * std::cos(towards) + glm::dot(way, axes[1]) * std::sin(towards) >= 0;
        });
        const auto found = ground.nearest.find(from, 5000, region);
        EXPECT_EQ(found.has_value(), brute_m < 5000) << n;
        if (!found) continue;
        ++found_in_all;
        EXPECT_LE(found->distance_m, brute_m + 0.02);
        EXPECT_NEAR(found->distance_m, brute_m, 8) << "the samples have steps at the region's edge";
        EXPECT_GE(found->elevation_rad, -1e-9);
    }
    EXPECT_GT(found_in_all, 3);
}

TEST(NearestGround, AWallBesideIsNearerThanTheValleyBelow) {
    const Raster raster = test_support::make_raster(97, 97, [](std::uint32_t i, auto) { return i < 60 ? 500.0f : 2500.0f; });
    const test_support::BuiltDatabase built(raster);
    NearestGround nearest(built.database);
    const double latitude = built.lattice().latitude_rad(48), longitude = built.lattice().longitude_rad(54);
    const earth::Geodetic from{latitude, longitude, {1500 + built.database.undulation(latitude, longitude).m}};
    const auto found = nearest.find(from, 1e5);
    ASSERT_TRUE(found);
    EXPECT_NEAR(base::degrees(found->bearing_rad), 90, 2);
    EXPECT_LT(found->distance_m, 400) << "five columns of 63 m, and the slope between two; it is 1000 m to the valley";
    const auto level = nearest.find(from, 1e5, kNotLower);
    ASSERT_TRUE(level);
    EXPECT_NEAR(level->height_msl_m, 1500, 1);
    EXPECT_NEAR(level->elevation_rad, 0, 1e-6);
    EXPECT_FALSE(nearest.find(from, 100)) << "nothing within so little";
}

TEST(NearestGround, SaysWhereGroundMayBeUnknown) {
    const Raster raster = test_support::make_raster(
        97, 97, [](std::uint32_t i, std::uint32_t j) { return i == 40 && j == 40 ? std::nanf("") : 500.0f; });
    const test_support::BuiltDatabase built(raster);
    NearestGround nearest(built.database);
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return earth::Geodetic{built.lattice().latitude_rad(j), built.lattice().longitude_rad(i), {800}};
    };
    EXPECT_TRUE(nearest.may_be_unknown(at(40, 40), 10));
    EXPECT_TRUE(nearest.may_be_unknown(at(50, 40), 700)) << "ten columns of 63 m beside the void";
    EXPECT_FALSE(nearest.may_be_unknown(at(64, 64), 300));
    EXPECT_TRUE(nearest.may_be_unknown(at(94, 64), 300)) << "the east end of the raster";
    EXPECT_TRUE(nearest.may_be_unknown({at(40, 40).latitude_rad + 1, at(40, 40).longitude_rad, {800}}, 10));
}

TEST(NearestGround, ADamagedChunkLeavesTheOthersAndADoubt) {
    test_support::BuiltDatabase built(test_support::make_rough_raster(97, 97));
    const terrain::ChunkEntry entry = built.entry({0, 1, 1});
    built.image[entry.payload.offset + 8] ^= 1;
    NearestGround nearest(built.database);
    const earth::Geodetic from{built.lattice().latitude_rad(48), built.lattice().longitude_rad(48), {1500}};
    ASSERT_TRUE(nearest.find(from, 1e5));
    EXPECT_TRUE(nearest.may_be_unknown(from, 1));
}

}  // namespace
}  // namespace tedavis::host_sim::test_nearest_ground
