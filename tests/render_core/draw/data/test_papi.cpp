#include "render_core/draw/data/papi.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tedavis::draw::test_papi {
namespace {

int whites(double angle_deg, double path_deg = kPapiPath_deg) {
    const PapiLights lights = papi_lights(angle_deg, path_deg);
    return static_cast<int>(std::count(lights.begin(), lights.end(), true));
}

TEST(Papi, P31TheLightsTellTheAngleToThePath) {
    EXPECT_EQ(whites(2.45), 0);
    EXPECT_EQ(whites(2.6), 1);
    EXPECT_EQ(whites(2.82), 1);
    EXPECT_EQ(whites(3.0), 2);
    EXPECT_EQ(whites(3.16), 2);
    EXPECT_EQ(whites(3.3), 3);
    EXPECT_EQ(whites(3.51), 4);
    EXPECT_EQ(whites(-1), 0);
}

TEST(Papi, P31OnThePathTheTwoNearestToTheRunwayAreRed) {
    const PapiLights lights = papi_lights(3);
    EXPECT_FALSE(lights[0]);
    EXPECT_FALSE(lights[1]);
    EXPECT_TRUE(lights[2]);
    EXPECT_TRUE(lights[3]);
}

TEST(Papi, P31AnotherPathHasItsOwnAngles) {
    EXPECT_EQ(whites(5.5, 5.5), 2);
    EXPECT_EQ(whites(5.5), 4) << "control: by the usual path they would be white";
    EXPECT_EQ(whites(5.1, 5.5), 1);
}

TEST(Papi, P31TheyAreSeenFromBeforeThemWithinTenMilesAndTenDegrees) {
    EXPECT_TRUE(is_papi_seen(18'000, 0));
    EXPECT_FALSE(is_papi_seen(18'600, 0)) << "farther than 10 NM";
    EXPECT_TRUE(is_papi_seen(1000, 170));
    EXPECT_TRUE(is_papi_seen(1000, -170));
    EXPECT_FALSE(is_papi_seen(1000, 180)) << "beyond 10 degrees";
    EXPECT_FALSE(is_papi_seen(-1000, 0)) << "from behind";
    EXPECT_FALSE(is_papi_seen(0, 0));
    EXPECT_FALSE(is_papi_seen(std::numeric_limits<double>::quiet_NaN(), 0));
}

}  // namespace
}  // namespace tedavis::draw::test_papi
