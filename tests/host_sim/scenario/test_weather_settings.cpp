#include "host_sim/scenario/weather_settings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim::test_weather_settings {
namespace {

constexpr const char* kWeather = R"(reach_m = 18000
wind_variation_mps = 1.5
wind_sigma_mps = 0.5
storm_cells = 3
storm_bearing_deg = 90
storm_distance_m = 12000
storm_spread_m = 2500
storm_radius_m = 1500
storm_intensity_dbz = 47
storm_intensity_spread_dbz = 7
storm_speed_mps = 9
storm_speed_spread_mps = 2
storm_toward_deg = 45
storm_toward_spread_deg = 12
storm_base_m = 1500
storm_top_m = 7500
radar_range_m = 17000
)";

std::string fault_of(const std::string& from, const std::string& to) {
    std::string text = kWeather;
    text.replace(text.find(from), from.size(), to);
    base::ConfigReader reader(text, "w.toml");
    (void)read_weather(reader.root());
    return reader.finish() ? "" : std::string(reader.error().message.view());
}

TEST(WeatherSettings, AreReadInSiUnits) {
    base::ConfigReader reader(kWeather, "w.toml");
    const WeatherSettings weather = read_weather(reader.root());
    ASSERT_TRUE(reader.finish());
    EXPECT_EQ(weather.reach_m, 18000);
    EXPECT_EQ(weather.wind.sigma_mps, 0.5);
    EXPECT_EQ(weather.storm.cells, 3);
    EXPECT_NEAR(weather.storm.bearing_rad, base::kPi / 2, 1e-12);
    EXPECT_NEAR(weather.storm.toward_rad, base::kPi / 4, 1e-12);
    EXPECT_EQ(weather.radar_range_m, 17000);
}

TEST(WeatherSettings, GustsMayBeLeftOutButAreAnEnsemble) {
    const auto read = [](const std::string& more) {
        base::ConfigReader reader(kWeather + more, "w.toml");
        return read_weather(reader.root()).gust;
    };
    EXPECT_EQ(read("").members, 0);
    EXPECT_EQ(read("gust_members = 16\ngust_spread_mps = 1.5\n").members, 16);
    EXPECT_EQ(read("gust_members = 16\ngust_spread_mps = 1.5\n").spread_mps, 1.5);
    const std::string last = "radar_range_m = 17000";
    EXPECT_NE(fault_of(last, last + "\ngust_members = 1").find("one member alone"), std::string::npos);
    EXPECT_NE(fault_of(last, last + "\ngust_members = 17").find("gust_members"), std::string::npos);
    EXPECT_NE(fault_of(last, last + "\ngust_members = 3").find("gust_spread_mps"), std::string::npos) << "is then needed";
}

TEST(WeatherSettings, NameTheLineOfAFault) {
    EXPECT_EQ(fault_of("storm_cells = 3", "storm_cells = 3"), "");
    EXPECT_EQ(fault_of("storm_cells = 3", "storm_cells = -1").rfind("w.toml:4: ", 0), 0u);
    EXPECT_EQ(fault_of("storm_cells = 3", "storm_cells = 2.5").rfind("w.toml:4: ", 0), 0u);
    EXPECT_EQ(fault_of("wind_sigma_mps = 0.5", "wind_sigma_mps = nan").rfind("w.toml:3: ", 0), 0u);
    EXPECT_NE(fault_of("wind_sigma_mps = 0.5", "").find("wind_sigma_mps"), std::string::npos);
    EXPECT_EQ(fault_of("wind_sigma_mps", "wind_sigmas_mps").find("w.toml"), 0u);
    EXPECT_NE(fault_of("storm_top_m = 7500", "storm_top_m = 2700").find("w.toml:16: must be more than 1200 m"),
              std::string::npos);
}

}  // namespace
}  // namespace tedavis::host_sim::test_weather_settings
