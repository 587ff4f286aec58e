#include "host_sim/reports/geo_extent.hpp"

#include <gtest/gtest.h>

#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_geo_extent {
namespace {

TEST(GeoExtent, GrowsByWhatItIncludes) {
    GeoExtent extent;
    EXPECT_TRUE(extent.is_empty());
    extent.include(46.5, 9.6);
    EXPECT_FALSE(extent.is_empty());
    extent.include(47.1, 10.2);
    extent.include(46.8, 9.7);
    EXPECT_EQ(extent.words(), "46.500 .. 47.100 N, 9.600 .. 10.200 E");
}

TEST(GeoExtent, OfATerrainReachesFromPostToPost) {
    const Raster raster = test_support::make_rough_raster(65, 33);
    const test_support::BuiltDatabase built(raster);
    const GeoExtent extent = extent_of(built.database);
    EXPECT_NEAR(extent.west_deg, raster.west_deg, 1e-9);
    EXPECT_NEAR(extent.north_deg, raster.north_deg, 1e-9);
    EXPECT_NEAR(extent.east_deg, raster.west_deg + 64 * raster.step_lon_deg, 1e-9);
    EXPECT_NEAR(extent.south_deg, raster.north_deg - 32 * raster.step_lat_deg, 1e-9);
}

TEST(GeoExtent, ApartIsMeasuredInBothDirectionsAndRoundTheEarth) {
    const GeoExtent alps{46, 47, 9, 10};
    EXPECT_FALSE(are_apart(alps, alps, 0));
    EXPECT_FALSE(are_apart(alps, {48, 49, 9, 10}, 2));
    EXPECT_TRUE(are_apart(alps, {49.5, 50, 9, 10}, 2));
    EXPECT_TRUE(are_apart(alps, {46, 47, -84, -83}, 2));
    EXPECT_FALSE(are_apart(alps, {40, 50, 0, 20}, 2)) << "within";
    EXPECT_FALSE(are_apart({0, 1, 179, 179.5}, {0, 1, -179.5, -179}, 2)) << "across the antimeridian";
    EXPECT_FALSE(are_apart({0, 1, 369, 370}, {0, 1, 9, 10}, 0)) << "another name of the same meridian";
    EXPECT_FALSE(are_apart(alps, GeoExtent(), 2)) << "what is nowhere is apart from nothing";
}

}  // namespace
}  // namespace tedavis::host_sim::test_geo_extent
