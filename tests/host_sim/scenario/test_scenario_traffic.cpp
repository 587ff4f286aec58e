#include "host_sim/scenario/scenario_traffic.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <cmath>
#include <string>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim::test_scenario_traffic {
namespace {

constexpr base::Time kStart{1'780'322'400'000'000'000};
base::Time at(double seconds) { return kStart + base::Duration::from_seconds(seconds); }

TrafficSettings straight() {
    TrafficSettings aircraft;
    aircraft.callsign = "N1";
    aircraft.address = 0xA0F12B;
    aircraft.latitude_rad = base::radians(36.6);
    aircraft.longitude_rad = base::radians(-84.2);
    aircraft.altitude_msl_m = 1500;
    aircraft.at_s = 100;
    aircraft.track_rad = base::radians(75);
    aircraft.speed_mps = 60;
    aircraft.climb_mps = -2;
    aircraft.position_deviation_m = 35;
    aircraft.received_from_s = 20;
    aircraft.received_until_s = 200;
    return aircraft;
}

std::string fault_of(const std::string& line) {
    std::string text =
        "[[traffic]]\naddress = \"A0F12B\"\nlatitude_deg = 36.5\nlongitude_deg = -84\naltitude_msl_m = 1000\nat_s = 1\n"
        "track_deg = 75\nspeed_mps = 58\n";
    const std::string key = line.substr(0, line.find(' '));
    if (const std::size_t there = text.find(key + " ="); there != std::string::npos)
        text.erase(there, text.find('\n', there) + 1 - there);
    base::ConfigReader reader(text + line + "\n", "s.toml");
    base::ConfigSection root = reader.root();
    EXPECT_EQ(root.table_count("traffic"), 1u);
    base::ConfigSection section = root.table_at("traffic", 0);
    (void)read_traffic(section);
    return reader.finish() ? "" : std::string(reader.error().message.view());
}

class ScenarioTrafficTest : public ::testing::Test {
protected:
    const GeoidEgm96 geoid_ = GeoidEgm96::installed();
};

TEST_F(ScenarioTrafficTest, FliesStraightAlongTheGeodesic) {
    const ScenarioTraffic traffic({straight()}, kStart, 1, geoid_);
    for (const double second : {20.0, 100.0, 160.0}) {
        const auto heard = traffic.at(at(second));
        ASSERT_EQ(heard.size(), 1u);
        const flight::TrafficReport& report = heard[0].report;
        double latitude = 0, longitude = 0;
        GeographicLib::Geodesic::WGS84().Direct(36.6, -84.2, 75, 60 * (second - 100), latitude, longitude);
        EXPECT_NEAR(base::degrees(report.place.latitude_rad), latitude, 2e-5) << "two metres in five kilometres";
        EXPECT_NEAR(base::degrees(report.place.longitude_rad), longitude, 3e-5);
        const double undulation = geoid_.undulation(report.place.latitude_rad, report.place.longitude_rad).m;
        EXPECT_NEAR(static_cast<double>(report.place.height_m), 1500 - 2 * (second - 100) + undulation, 0.01);
        EXPECT_EQ(report.place.at, at(second));
        EXPECT_EQ(report.callsign.view(), "N1");
    }
}

TEST_F(ScenarioTrafficTest, StandsUntilItMoves) {
    TrafficSettings aircraft = straight();
    const ScenarioTraffic moving({aircraft}, kStart, 1, geoid_);
    aircraft.stands_before = true;
    const ScenarioTraffic standing({aircraft}, kStart, 1, geoid_);
    const auto report = [](const ScenarioTraffic& traffic, double second) { return traffic.at(at(second))[0].report; };
    for (const double second : {20.0, 60.0, 99.9}) {
        EXPECT_EQ(report(standing, second).place.latitude_rad, report(moving, 100).place.latitude_rad) << second;
        EXPECT_EQ(report(standing, second).place.height_m, report(moving, 100).place.height_m) << second;
        EXPECT_EQ(report(standing, second).ground_speed_mps, 0) << second;
        EXPECT_EQ(report(standing, second).climb_mps, 0) << second;
        EXPECT_NE(report(moving, second).place.latitude_rad, report(moving, 100).place.latitude_rad) << "control";
    }
    EXPECT_EQ(report(standing, 150).place.latitude_rad, report(moving, 150).place.latitude_rad);
    EXPECT_EQ(report(standing, 150).ground_speed_mps, 60);
}

/// Whoever turns goes where its track and speed say.
TEST_F(ScenarioTrafficTest, ATurnIsACircleAlongItsTrack) {
    TrafficSettings aircraft = straight();
    aircraft.turn_radps = base::radians(9);
    aircraft.climb_mps = 0;
    const ScenarioTraffic traffic({aircraft}, kStart, 1, geoid_);
    const auto report = [&](double second) { return traffic.at(at(second))[0].report; };
    EXPECT_NEAR(report(100).place.latitude_rad, report(140).place.latitude_rad, 1e-9) << "360 degrees take 40 s";
    EXPECT_NEAR(report(100).place.longitude_rad, report(140).place.longitude_rad, 1e-9);
    for (double second = 60; second < 100; second += 7) {
        const flight::TrafficPlace before = report(second - 0.05).place, after = report(second + 0.05).place;
        double metres = 0, azimuth = 0, other = 0;
        GeographicLib::Geodesic::WGS84().Inverse(base::degrees(before.latitude_rad), base::degrees(before.longitude_rad),
                                                 base::degrees(after.latitude_rad), base::degrees(after.longitude_rad), metres,
                                                 azimuth, other);
        EXPECT_NEAR(metres, 6, 0.02) << second;
        const double off = azimuth - base::degrees(static_cast<double>(report(second).true_track_rad));
        EXPECT_NEAR(std::remainder(off, 360), 0, 0.2) << second;
    }
}

TEST_F(ScenarioTrafficTest, IsReceivedInItsTimeUnderItsNumber) {
    TrafficSettings later = straight();
    later.received_from_s = 50;
    later.received_until_s = 60;
    const ScenarioTraffic traffic({straight(), later}, kStart, 1, geoid_);
    EXPECT_EQ(traffic.at(at(19)).size(), 0u);
    EXPECT_EQ(traffic.at(at(20)).size(), 1u);
    ASSERT_EQ(traffic.at(at(55)).size(), 2u);
    EXPECT_EQ(traffic.at(at(55))[1].number, 1);
    EXPECT_EQ(traffic.at(at(201)).size(), 0u);
}

TEST_F(ScenarioTrafficTest, TheSeedMovesItWithinItsSpread) {
    TrafficSettings aircraft = straight();
    aircraft.spread_m = 500;
    const auto latitude = [&](std::uint64_t seed) {
        return ScenarioTraffic({aircraft}, kStart, seed, geoid_).at(at(100))[0].report.place.latitude_rad;
    };
    EXPECT_EQ(latitude(1), latitude(1));
    EXPECT_NE(latitude(1), latitude(2));
    for (std::uint64_t seed = 0; seed < 50; ++seed) EXPECT_LE(std::abs(latitude(seed) - base::radians(36.6)), 501 / 6.35e6);
}

TEST(TrafficSettings, FaultsAreSaid) {
    EXPECT_EQ(fault_of("callsign = \"TDV417\""), "");
    for (const char* line : {"callsign = \"TOOLONG99\"", "callsign = \"tdv\"", "address = \"0\"", "address = \"G00000\"",
                             "address = \"1000000\"", "latitude_deg = 91", "speed_mps = nan", "colour = 3"})
        EXPECT_NE(fault_of(line).find("s.toml:"), std::string::npos) << line;
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario_traffic
