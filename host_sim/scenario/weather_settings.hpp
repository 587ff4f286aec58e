/// The section [weather] of a scenario file: random quantities and their spreads.
///
///     reach_m                          half a side of the square round the strip that wind and radar cover
///     wind_variation_mps               standard deviation of the wind from place to place, away from the strip
///     wind_sigma_mps                   standard deviation of the wind's error at the strip at the start
///     storm_cells                      how many; 0: none
///     storm_bearing_deg, storm_distance_m, storm_spread_m
///                                      where they stand at the start: the middle from the strip, and how far about it
///     storm_radius_m                   of a cell, give or take 30 %
///     storm_intensity_dbz, storm_intensity_spread_dbz
///     storm_speed_mps, storm_speed_spread_mps, storm_toward_deg, storm_toward_spread_deg
///     storm_base_m, storm_top_m        above mean sea level, give or take 200 m and 1000 m
///     radar_range_m                    of the radar, which stands at the strip
///     gust_members                     of the ensemble of gusts; 0, and what is left out: no such layer
///     gust_spread_mps                  standard deviation of its members at the strip at the start
///
/// SI and radians inside. Every value is checked where it is read.
#pragma once

#include "render_core/base/config_reader.hpp"

namespace tedavis::host_sim {

inline constexpr double kSecondsPerHour = 3600;

struct WindSettings {
    double variation_mps = 0, sigma_mps = 0;
};

struct GustSettings {
    int members = 0;
    double spread_mps = 0;
};

struct StormSettings {
    int cells = 0;
    double bearing_rad = 0, distance_m = 0, spread_m = 0;
    double radius_m = 0;
    double intensity_dbz = 0, intensity_spread_dbz = 0;
    double speed_mps = 0, speed_spread_mps = 0;
    double toward_rad = 0, toward_spread_rad = 0;
    double base_msl_m = 0, top_msl_m = 0;
};

struct WeatherSettings {
    double reach_m = 0;
    WindSettings wind;
    StormSettings storm;
    double radar_range_m = 0;
    GustSettings gust;
};

/// Reports faults to the reader of the section.
[[nodiscard]] WeatherSettings read_weather(base::ConfigSection section);

}  // namespace tedavis::host_sim
