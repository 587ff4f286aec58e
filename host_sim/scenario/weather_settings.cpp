#include "host_sim/scenario/weather_settings.hpp"

#include "host_sim/scenario/storm_cells.hpp"
#include "render_core/base/units.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {
namespace {

using base::ConfigSection;
using base::radians;

WindSettings read_wind(ConfigSection& section) {
    WindSettings wind;
    wind.variation_mps = section.number("wind_variation_mps", 0, 20);
    wind.sigma_mps = section.number("wind_sigma_mps", 0, 20);
    return wind;
}

GustSettings read_gust(ConfigSection& section) {
    GustSettings gust;
    gust.members = static_cast<int>(section.integer("gust_members", 0, scene::kMaxMembers, 0));
    if (gust.members == 1) section.fault("gust_members", "must be 0, or 2 to 16: one member alone is no ensemble");
    if (gust.members > 0) gust.spread_mps = section.number("gust_spread_mps", 0, 20);
    return gust;
}

StormSettings read_storm(ConfigSection& section) {
    StormSettings storm;
    storm.cells = static_cast<int>(section.integer("storm_cells", 0, 64));
    storm.bearing_rad = radians(section.number("storm_bearing_deg", 0, 360));
    storm.distance_m = section.number("storm_distance_m", 0, 200'000);
    storm.spread_m = section.number("storm_spread_m", 0, 100'000);
    storm.radius_m = section.number("storm_radius_m", 200, 20'000);
    storm.intensity_dbz = section.number("storm_intensity_dbz", 10, 70);
    storm.intensity_spread_dbz = section.number("storm_intensity_spread_dbz", 0, 10);
    storm.speed_mps = section.number("storm_speed_mps", 0, 40);
    storm.speed_spread_mps = section.number("storm_speed_spread_mps", 0, 10);
    storm.toward_rad = radians(section.number("storm_toward_deg", 0, 360));
    storm.toward_spread_rad = radians(section.number("storm_toward_spread_deg", 0, 180));
    storm.base_msl_m = section.number("storm_base_m", 0, 10'000);
    storm.top_msl_m = section.number("storm_top_m", 0, 20'000);
    if (storm.top_msl_m - kStormTopSpread_m <= storm.base_msl_m + kStormBaseSpread_m)
        section.fault("storm_top_m", "must be more than 1200 m above storm_base_m, for both vary with the seed");
    return storm;
}

}  // namespace

WeatherSettings read_weather(ConfigSection section) {
    WeatherSettings weather;
    weather.reach_m = section.number("reach_m", 2'000, 200'000);
    weather.wind = read_wind(section);
    weather.storm = read_storm(section);
    weather.radar_range_m = section.number("radar_range_m", 1'000, 400'000);
    weather.gust = read_gust(section);
    return weather;
}

}  // namespace tedavis::host_sim
