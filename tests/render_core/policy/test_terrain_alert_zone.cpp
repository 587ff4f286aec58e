#include "render_core/policy/terrain_alert_zone.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::policy::test_terrain_alert_zone {
namespace {

/// North-east at 50 m/s, 100 m wide and 1 m/s wider; the ground may reach 500 m.
TerrainAlertZone north_east(double turn_radps) {
    TerrainAlertZone zone;
    zone.alert = TerrainAhead::caution;
    zone.north_mps = zone.east_mps = 50 * std::sqrt(0.5);
    zone.turn_radps = turn_radps;
    zone.radius_m = 100;
    zone.radius_mps = 1;
    zone.floor_msl_m = 500;
    zone.until_s = 60;
    return zone;
}

struct Walked {
    double north_m = 0, east_m = 0;
};
/// Where the track leads, and `aside_m` to its right: in steps of a hundredth of a second.
Walked walked(const TerrainAlertZone& zone, double seconds, double aside_m) {
    Walked at;
    double direction = std::atan2(zone.east_mps, zone.north_mps);
    const int steps = static_cast<int>(std::lround(seconds * 100));
    for (int n = 0; n < steps; ++n) {
        at.north_m += 0.5 * std::cos(direction + zone.turn_radps * 0.005);
        at.east_m += 0.5 * std::sin(direction + zone.turn_radps * 0.005);
        direction += zone.turn_radps * 0.01;
    }
    return {at.north_m - aside_m * std::sin(direction), at.east_m + aside_m * std::cos(direction)};
}

TEST(TerrainAlertZone, PlacesArePassedWhenAWalkAlongTheTrackPassesThem) {
    for (const double turn_deg : {0.0, 0.0005, 0.5, 2.9, -0.5, -2.9}) {
        const TerrainAlertZone zone = north_east(base::radians(turn_deg));
        for (const double seconds : {1.0, 20.0, 45.0, 59.0})
            for (const double aside_m : {-300.0, -40.0, 0.0, 250.0}) {
                const Walked at = walked(zone, seconds, aside_m);
                const TrackPassage passage = passage_of(zone, at.north_m, at.east_m);
                EXPECT_NEAR(passage.seconds, seconds, 0.02) << turn_deg << " " << aside_m;
                EXPECT_NEAR(passage.aside_m, std::fabs(aside_m), 1) << turn_deg << " " << seconds;
            }
    }
}

TEST(TerrainAlertZone, GroundViolatesByTimeWidthAndHeight) {
    for (const double turn_deg : {0.0, 1.5, -1.5}) {
        const TerrainAlertZone zone = north_east(base::radians(turn_deg));
        const auto at = [&](double seconds, double aside_m, double height_m) {
            const Walked place = walked(zone, seconds, aside_m);
            return violation_at(zone, place.north_m, place.east_m, height_m);
        };
        EXPECT_EQ(at(29, 0, 501), TerrainAhead::warning);
        EXPECT_EQ(at(31, 0, 501), TerrainAhead::caution);
        EXPECT_EQ(at(29, 0, 499), TerrainAhead::none);
        EXPECT_EQ(at(59, 155, 501), TerrainAhead::caution);
        EXPECT_EQ(at(59, -165, 501), TerrainAhead::none);
        EXPECT_EQ(at(61, 0, 501), TerrainAhead::none);
    }
}

TEST(TerrainAlertZone, BehindTheOwnShipCountsWhatIsAround) {
    for (const double turn_rad : {0.0, 0.02, -0.02}) {
        const TerrainAlertZone zone = north_east(turn_rad);
        EXPECT_EQ(violation_at(zone, -60, -60, 501), TerrainAhead::warning) << turn_rad;
        EXPECT_EQ(violation_at(zone, -80, -80, 501), TerrainAhead::none) << turn_rad;
    }
    TerrainAlertZone still = north_east(0);
    still.north_mps = still.east_mps = 0;
    EXPECT_EQ(violation_at(still, 90, 0, 501), TerrainAhead::warning);
    EXPECT_EQ(violation_at(still, 110, 0, 501), TerrainAhead::none);
}

TEST(TerrainAlertZone, TheFloorMovesWithTheTrack) {
    TerrainAlertZone zone = north_east(0);
    zone.floor_mps = -5;
    EXPECT_EQ(violation_at(zone, 1000, 1000, 370), TerrainAhead::warning) << "after 28.3 s it is 358.6 m";
    EXPECT_EQ(violation_at(zone, 1000, 1000, 350), TerrainAhead::none);
}

TEST(TerrainAlertZone, GroundOfARunwayIsLeftOutUpToItsHeight) {
    TerrainAlertZone zone = north_east(0);
    zone.runway = {1000, 1000, 400, 520};
    EXPECT_EQ(violation_at(zone, 1000, 1000, 515), TerrainAhead::none);
    EXPECT_EQ(violation_at(zone, 1000, 1000, 525), TerrainAhead::warning);
    EXPECT_EQ(violation_at(zone, 700, 700, 515), TerrainAhead::warning) << "outside of the circle";
}

}  // namespace
}  // namespace tedavis::policy::test_terrain_alert_zone
