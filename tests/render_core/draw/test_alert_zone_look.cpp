#include "render_core/draw/alert_zone_look.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::draw::test_alert_zone_look {
namespace {

using policy::TerrainAhead;

policy::TerrainAlertZone zone_to(double track_deg) {
    policy::TerrainAlertZone zone;
    zone.alert = TerrainAhead::caution;
    zone.from = {base::radians(47), base::radians(9.6), {1500}};
    zone.north_mps = 80 * std::cos(base::radians(track_deg));
    zone.east_mps = 80 * std::sin(base::radians(track_deg));
    zone.radius_m = 200;
    zone.radius_mps = 5;
    zone.floor_msl_m = 900;
    zone.floor_mps = -2;
    zone.until_s = 60;
    return zone;
}

glm::dvec3 place_at(const policy::TerrainAlertZone& zone, double north_m, double east_m, double up_m) {
    const GeographicLib::LocalCartesian local(base::degrees(zone.from.latitude_rad), base::degrees(zone.from.longitude_rad),
                                              zone.from.height.m);
    double lat_deg = 0, lon_deg = 0, height_m = 0;
    local.Reverse(east_m, north_m, up_m, lat_deg, lon_deg, height_m);
    glm::dvec3 place(0);
    GeographicLib::Geocentric::WGS84().Forward(lat_deg, lon_deg, height_m, place.x, place.y, place.z);
    return place;
}

TEST(AlertZoneLook, PlacesInSpaceAreThoseOfThePlaneBelowTheOwnShip) {
    for (const double turn_radps : {0.0, 0.02, -0.02}) {
        policy::TerrainAlertZone zone = zone_to(70);
        zone.turn_radps = turn_radps;
        const AlertZoneLook look = alert_zone_look(zone);
        int seen[3] = {};
        for (double north_m = -3000; north_m < 6000; north_m += 171)
            for (double east_m = -3000; east_m < 6000; east_m += 171) {
                const TerrainAhead expected = policy::violation_at(zone, north_m, east_m, 850);
                EXPECT_EQ(look.at(place_at(zone, north_m, east_m, -650), 850), expected) << north_m << ", " << east_m;
                ++seen[static_cast<std::size_t>(expected)];
            }
        EXPECT_GT(seen[1], 10) << turn_radps;
        EXPECT_GT(seen[0], 1000) << turn_radps;
    }
}

TEST(AlertZoneLook, ForwardIsTheTrackAndRightIsAcrossIt) {
    policy::TerrainAlertZone zone = zone_to(70);
    zone.runway.north_m = zone.north_mps * 10;
    zone.runway.east_m = zone.east_mps * 10;
    const AlertZoneLook look = alert_zone_look(zone);
    const glm::dvec3 ahead = place_at(zone, zone.north_mps * 3, zone.east_mps * 3, -300) - look.from;
    EXPECT_NEAR(glm::dot(ahead, look.forward), 240, 1e-6);
    EXPECT_NEAR(glm::dot(ahead, look.right), 0, 1e-6);
    const glm::dvec3 right = place_at(zone, -zone.east_mps, zone.north_mps, 0) - look.from;
    EXPECT_NEAR(glm::dot(right, look.right), 80, 1e-6);
    EXPECT_NEAR(look.runway_m.x, 800, 1e-9);
    EXPECT_NEAR(look.runway_m.y, 0, 1e-9);
}

TEST(AlertZoneLook, OnlyGroundAboveTheLowestFloorMayBeColored) {
    const AlertZoneLook look = alert_zone_look(zone_to(0));
    EXPECT_TRUE(look.may_reach(781));
    EXPECT_FALSE(look.may_reach(780)) << "the floor after a minute";
    policy::TerrainAlertZone climbing = zone_to(0);
    climbing.floor_mps = 4;
    EXPECT_FALSE(alert_zone_look(climbing).may_reach(900));
    EXPECT_TRUE(alert_zone_look(climbing).may_reach(901));
}

TEST(AlertZoneLook, WithoutAnAlertNothingIsColored) {
    policy::TerrainAlertZone zone = zone_to(0);
    const glm::dvec3 ahead = place_at(zone, 800, 0, 0);
    EXPECT_EQ(alert_zone_look(zone).at(ahead, 1500), TerrainAhead::warning);
    zone.alert = TerrainAhead::none;
    const AlertZoneLook look = alert_zone_look(zone);
    EXPECT_FALSE(look.is_shown());
    EXPECT_FALSE(look.may_reach(9000));
    EXPECT_EQ(look.at(ahead, 1500), TerrainAhead::none);
}

}  // namespace
}  // namespace tedavis::draw::test_alert_zone_look
