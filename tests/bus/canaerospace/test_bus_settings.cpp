#include "bus/canaerospace/bus_settings.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/files/paths.hpp"

namespace tedavis::bus::test_bus_settings {
namespace {

std::string shipped(const char* name) {
    std::ifstream file(test_support::source_dir() + "/configs/buses/" + name);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string error_of(const std::string& text) {
    const auto result = load_bus_settings(text, "bus.toml");
    return result.ok() ? std::string("accepted") : std::string(result.error().message.view());
}

TEST(BusSettings, ShippedStandardFileStatesTheDefaults) {
    const auto result = load_bus_settings(shipped("canaerospace.toml"), "canaerospace.toml");
    ASSERT_TRUE(result.ok()) << result.error().message.view();
    const BusSettings& loaded = result.value();
    const BusSettings defaults;
    EXPECT_EQ(loaded.dialect.accept_long_position, defaults.dialect.accept_long_position);
    EXPECT_EQ(loaded.dialect.heading, defaults.dialect.heading);
    EXPECT_EQ(loaded.dialect.service_code, defaults.dialect.service_code);
    EXPECT_EQ(loaded.dialect.redundancy_channels, defaults.dialect.redundancy_channels);
    EXPECT_EQ(loaded.dialect.pair_window, defaults.dialect.pair_window);
    EXPECT_EQ(loaded.dialect.sender_timeout, defaults.dialect.sender_timeout);
    EXPECT_EQ(loaded.phase.timeout, defaults.phase.timeout);
    EXPECT_EQ(loaded.utc_timeout, defaults.utc_timeout);
    EXPECT_FALSE(defaults.traffic.is_carried());
    EXPECT_EQ(loaded.traffic.first_identifier, 1840) << "has no default";
    EXPECT_FALSE(defaults.guidance.is_carried());
    EXPECT_EQ(loaded.guidance.first_identifier, 1832) << "has no default";
    EXPECT_FALSE(defaults.display.has(0)) << "no identifier is none";
    EXPECT_EQ(loaded.display.legend_identifier, 1852) << "has no default";
    EXPECT_EQ(loaded.dialect.deviation, defaults.dialect.deviation);
    EXPECT_EQ(loaded.dialect.directions, defaults.dialect.directions);
    EXPECT_EQ(loaded.node.node, defaults.node.node);
    EXPECT_EQ(loaded.own_ship.extrapolation_limit, defaults.own_ship.extrapolation_limit);
    EXPECT_EQ(loaded.own_ship.acceleration_mps2, defaults.own_ship.acceleration_mps2);
    for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
        EXPECT_EQ(loaded.limits[i].stale, defaults.limits[i].stale) << flight::to_string(static_cast<flight::Signal>(i));
        EXPECT_EQ(loaded.limits[i].lost, defaults.limits[i].lost) << flight::to_string(static_cast<flight::Signal>(i));
    }
}

TEST(BusSettings, ShippedGliderFileLoads) {
    const auto result = load_bus_settings(shipped("glider.toml"), "glider.toml");
    ASSERT_TRUE(result.ok()) << result.error().message.view();
    EXPECT_EQ(result.value().dialect.acceleration, AccelerationUnit::mps2);
    EXPECT_EQ(result.value().dialect.pressure, PressureUnit::pa);
    EXPECT_EQ(result.value().dialect.wind, WindDirection::to);
    EXPECT_TRUE(result.value().dialect.month_from_zero);
    EXPECT_TRUE(result.value().dialect.glider_identifiers);
    EXPECT_EQ(result.value().own_ship.extrapolation_limit, base::Duration::milliseconds(600));
}

TEST(BusSettings, AnEmptyFileIsTheStandard) {
    ASSERT_TRUE(load_bus_settings("", "empty.toml").ok());
    EXPECT_EQ(load_bus_settings("", "empty.toml").value().phase.status_identifier, 1830);
}

TEST(BusSettings, FaultsNameFileLineAndRemedy) {
    EXPECT_EQ(error_of("protocol = \"canaerospace\"\n[dialect]\nacceleration_unit = \"ft\"\n"),
              "bus.toml:3: 'acceleration_unit' must be one of: g, m/s2");
    EXPECT_NE(error_of("[dialect]\nheading = \"true\"\n").find("bus.toml:2: unknown key"), std::string::npos);
    EXPECT_NE(error_of("protocol = \"arinc825\"\n").find("must be one of: canaerospace"), std::string::npos);
    EXPECT_NE(error_of("[freshness]\npitch = [2.0, 1.0]\n").find("bus.toml:2: the lost limit"), std::string::npos);
    EXPECT_NE(error_of("[freshness]\npitch = [nan, 1.0]\n").find("bus.toml:2"), std::string::npos);
    EXPECT_NE(error_of("[freshness]\nspeed = [1.0, 2.0]\n").find("no such signal"), std::string::npos);
    EXPECT_NE(error_of("[freshness]\nheight_above_terrain = [1.0, 2.0]\n").find("no such signal"), std::string::npos);
    EXPECT_NE(error_of("[phase]\nstatus_identifier = 311\n").find("has a meaning in the standard"), std::string::npos);
    EXPECT_NE(error_of("[phase]\nstatus_identifier = 1840\nrequest_identifier = 1840\n").find("give each its own"),
              std::string::npos);
    for (const char* other : {"1830", "1831"})
        EXPECT_NE(error_of("[phase]\nreport_identifier = " + std::string(other) + "\n").find("bus.toml:2: 'report_identifier'"),
                  std::string::npos);
    EXPECT_NE(error_of("[phase]\nreport_identifier = 311\n").find("has a meaning in the standard"), std::string::npos);
    EXPECT_NE(error_of("[phase]\nreport_identifier = 0\n").find("bus.toml:2"), std::string::npos);
    EXPECT_EQ(error_of("[phase]\nreport_identifier = 1853\n"), "accepted");
    EXPECT_NE(error_of("[phase]\nreport_identifier = 1852\n[display]\nlegend_identifier = 1852\n").find("bus.toml:4"),
              std::string::npos);
    EXPECT_NE(error_of("[traffic]\n").find("first_identifier"), std::string::npos);
    EXPECT_NE(error_of("[traffic]\nfirst_identifier = 1200\n").find("bus.toml:2: one of the twelve"), std::string::npos);
    EXPECT_NE(error_of("[traffic]\nfirst_identifier = 1820\n").find("phase of flight"), std::string::npos);
    EXPECT_NE(error_of("[traffic]\nfirst_identifier = 1989\n").find("bus.toml:2"), std::string::npos);
    EXPECT_EQ(error_of("[traffic]\nfirst_identifier = 1988\n"), "accepted");
    EXPECT_EQ(error_of("[guidance]\nfirst_identifier = 1037\n"),
              "bus.toml:2: one of the eight identifiers from here on has a meaning in the standard; choose others");
    EXPECT_NE(error_of("[traffic]\nfirst_identifier = 1840\n[guidance]\nfirst_identifier = 1833\n")
                  .find("bus.toml:4: one of the eight"),
              std::string::npos);
    EXPECT_EQ(error_of("[traffic]\nfirst_identifier = 1840\n[guidance]\nfirst_identifier = 1832\n"), "accepted");
    EXPECT_NE(error_of("[guidance]\nfirst_identifier = 1825\n").find("phase of flight"), std::string::npos);
    EXPECT_EQ(error_of("[display]\nlegend_identifier = 1852\n"), "accepted");
    for (const char* taken : {"1830", "1831", "311"})
        EXPECT_EQ(error_of("[display]\nlegend_identifier = " + std::string(taken) + "\n"),
                  "bus.toml:2: this identifier has a meaning already; choose another");
    EXPECT_NE(error_of("[traffic]\nfirst_identifier = 1840\n[display]\nlegend_identifier = 1851\n").find("bus.toml:4"),
              std::string::npos);
    EXPECT_NE(error_of("[guidance]\nfirst_identifier = 1832\n[display]\nlegend_identifier = 1832\n").find("bus.toml:4"),
              std::string::npos);
    EXPECT_NE(error_of("[dialect]\ndeviation_states = \"needle\"\n").find("own_ship, path"), std::string::npos);
    EXPECT_NE(error_of("[own_ship]\nextrapolation_limit_s = 3.0\n").find("lost_after_s"), std::string::npos);
    EXPECT_NE(error_of("[own_ship]\nposition_noise_m = -1\n").find("bus.toml:2"), std::string::npos);
    EXPECT_NE(error_of("[node]\nid = 0\n").find("bus.toml:2"), std::string::npos);
    EXPECT_NE(error_of("[dialect\n").find("bus.toml:1"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::bus::test_bus_settings
