#include "render_core/policy/predicted_track.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::policy::test_predicted_track {
namespace {

PredictedTrack track(double north_mps, double east_mps, double up_mps = 0) {
    return {{base::radians(46.8), base::radians(9.8), {1500}}, north_mps, east_mps, up_mps};
}

/// Metres between two places, straight through space.
double distance_m(const earth::Geodetic& a, const earth::Geodetic& b) {
    return glm::length(earth::to_ecef(a) - earth::to_ecef(b));
}

TEST(PredictedTrack, AfterAMinuteItIsAMinuteOfFlightAway) {
    for (const PredictedTrack& flown : {track(70, 0), track(-70, 0), track(0, 70), track(30, -40)}) {
        const earth::Geodetic place = flown.at(60);
        EXPECT_NEAR(distance_m(flown.from, place), 60 * flown.ground_speed_mps(), 3) << "the earth's curve and 1500 m of height";
        EXPECT_EQ(place.height.m, 1500);
    }
    EXPECT_EQ(track(70, 0, -5).at(60).height.m, 1200);
    EXPECT_GT(track(70, 0).at(60).latitude_rad, base::radians(46.8));
    EXPECT_GT(track(0, 70).at(60).longitude_rad, base::radians(9.8));
}

TEST(PredictedTrack, RightIsRightOfTheTrack) {
    const PredictedTrack north = track(70, 0), west = track(0, -70);
    EXPECT_GT(north.at(10, 200).longitude_rad, north.at(10).longitude_rad);
    EXPECT_EQ(north.at(10, 200).latitude_rad, north.at(10).latitude_rad);
    EXPECT_GT(west.at(10, 200).latitude_rad, west.at(10).latitude_rad) << "north of a track to the west";
    for (const PredictedTrack& flown : {north, west, track(30, -40)})
        EXPECT_NEAR(distance_m(flown.at(10, 200), flown.at(10)), 200, 0.2);
    EXPECT_EQ(track(0, 0).at(10, 200).longitude_rad, base::radians(9.8)) << "who stands still has no right";
}

}  // namespace
}  // namespace tedavis::policy::test_predicted_track
