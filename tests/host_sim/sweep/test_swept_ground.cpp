#include "host_sim/sweep/swept_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_swept_ground {
namespace {

constexpr double kStep_deg = 1.0 / 1200, kWest_deg = 9.6, kNorth_deg = 47.1;

/// Flat at 500 m, with a wall of 900 m along the meridian of post 60, that leaves the north open.
const test_support::BuiltDatabase& walled() {
    static const test_support::BuiltDatabase kDatabase(
        test_support::make_raster(129, 129, [](auto i, auto j) { return i == 60 && j > 40 ? 900.0f : 500.0f; }));
    return kDatabase;
}

earth::Geodetic at(SweptGround& ground, double i, double j, double msl_m) {
    const double latitude_rad = base::radians(kNorth_deg - j * kStep_deg),
                 longitude_rad = base::radians(kWest_deg + i * kStep_deg);
    return {latitude_rad, longitude_rad, earth::to_ellipsoid({msl_m}, ground.at(latitude_rad, longitude_rad).undulation)};
}

TEST(SweptGround, AWallHidesWhatIsBehindIt) {
    SweptGround ground(walled().database);
    const earth::Geodetic place = at(ground, 40, 80, 500);
    EXPECT_TRUE(ground.hides(place, at(ground, 80, 80, 700)));
    EXPECT_TRUE(ground.hides(place, at(ground, 80, 80, 1240))) << "the sight passes 30 m below the wall's top";
    EXPECT_FALSE(ground.hides(place, at(ground, 80, 80, 1310)));
    EXPECT_FALSE(ground.hides(place, at(ground, 50, 80, 700))) << "on this side of it";
    EXPECT_FALSE(ground.hides(at(ground, 40, 20, 501), at(ground, 80, 20, 600))) << "where it is open";
    EXPECT_FALSE(ground.hides(place, at(ground, 20, 80, 502))) << "over flat ground";
}

TEST(SweptGround, ThePlaceDoesNotHideItself) {
    SweptGround ground(walled().database);
    const earth::Geodetic top = at(ground, 60, 80, 900);
    EXPECT_FALSE(ground.hides(top, at(ground, 90, 80, 2000)));
    EXPECT_TRUE(ground.hides(at(ground, 59, 80, 500), at(ground, 90, 80, 1000))) << "at the foot of the other side";
}

TEST(SweptGround, OutsideNothingHides) {
    SweptGround ground(walled().database);
    EXPECT_EQ(ground.at(base::radians(46), base::radians(9.6)).status, terrain::HeightStatus::outside);
    const earth::Geodetic one{base::radians(46.0), base::radians(9.6), {400}},
        other{base::radians(46.05), base::radians(9.6), {400}};
    EXPECT_FALSE(ground.hides(one, other));
}

TEST(SweptGround, TheMiddleIsThatOfThePosts) {
    const earth::Geodetic middle = SweptGround(walled().database).middle();
    EXPECT_NEAR(base::degrees(middle.latitude_rad), kNorth_deg - 64 * kStep_deg, 1e-9);
    EXPECT_NEAR(base::degrees(middle.longitude_rad), kWest_deg + 64 * kStep_deg, 1e-9);
}

}  // namespace
}  // namespace tedavis::host_sim::test_swept_ground
