/// The list of the aircraft's signals, with their names. Decoder bindings, freshness limits, frame records, configuration keys
/// and tests all use it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tedavis::flight {

/// Values are in SI units and radians. "true" means relative to true north.
enum class Signal : std::uint8_t {
    latitude,                   ///< rad, GNSS
    longitude,                  ///< rad, GNSS, [-pi, pi)
    ellipsoid_height,           ///< m above WGS84, GNSS
    ground_speed,               ///< m/s
    true_track,                 ///< rad, [0, 2 pi)
    horizontal_accuracy,        ///< m, figure of merit
    vertical_accuracy,          ///< m, figure of merit
    pitch,                      ///< rad, nose up
    roll,                       ///< rad, right wing down
    true_heading,               ///< rad, [0, 2 pi)
    magnetic_heading,           ///< rad, [0, 2 pi)
    magnetic_variation,         ///< rad, east positive
    sideslip,                   ///< rad
    pitch_rate,                 ///< rad/s
    roll_rate,                  ///< rad/s
    yaw_rate,                   ///< rad/s
    longitudinal_acceleration,  ///< m/s^2
    lateral_acceleration,       ///< m/s^2
    normal_acceleration,        ///< m/s^2, as an accelerometer feels it: 1 g in level flight
    indicated_airspeed,         ///< m/s
    true_airspeed,              ///< m/s
    calibrated_airspeed,        ///< m/s
    standard_altitude,          ///< m, pressure altitude at 1013.25 hPa
    baro_altitude,              ///< m above MSL as the altimeter shows it (QNH set)
    baro_setting,               ///< Pa, QNH
    vertical_speed,             ///< m/s, up
    radio_height,               ///< m above ground
    wind_speed,                 ///< m/s
    wind_direction,             ///< rad, the direction that the wind comes from
    outside_temperature,        ///< K
    true_altitude,              ///< m above MSL, geometric
    heading_rate,               ///< rad/s, turning right positive
    flaps_lever,                ///< share of full travel, -1 .. 1; what the pilot has set
    flaps_position,             ///< share of full travel, 0 .. 1; where the flaps are
    navigation_source,          ///< a code, see NavigationSource
    ils1_localizer_deviation,   ///< rad, positive: the own ship is right of the course
    ils1_glideslope_deviation,  ///< rad, positive: the own ship is above the path
    ils2_localizer_deviation,   ///< rad, as that of the first receiver
    ils2_glideslope_deviation,  ///< rad, as that of the first receiver
    cross_track_deviation,      ///< m, GNSS, positive: the own ship is right of the desired track
    gnss_vertical_deviation,    ///< m, GNSS, positive: the own ship is above the path
    desired_track,              ///< rad, true, [0, 2 pi), GNSS
    waypoint_bearing,           ///< rad, true, [0, 2 pi), of the active waypoint
    selected_course,            ///< rad, true, [0, 2 pi), of the radio receiver
    selected_glidepath,         ///< rad, descending positive
    flight_director_pitch,      ///< rad, by which the nose must go up
    flight_director_roll,       ///< rad, by which the right wing must go down
    selected_altitude,          ///< m above MSL as the altimeter shows it
    selected_heading,           ///< rad, true, [0, 2 pi)
    selected_airspeed,          ///< m/s, indicated
    selected_vertical_speed,    ///< m/s, up
    decision_height,            ///< m above ground, the minimum on radio height
    minimum_altitude,           ///< m above MSL as the altimeter shows it, the minimum on the altimeter
    airspeed_rate,              ///< m/s^2, computed by the display from the airspeed
    height_above_terrain,       ///< m, computed by the display from position and database
    count_                      ///< number of signals; not a signal
};
inline constexpr std::size_t kSignalCount = static_cast<std::size_t>(Signal::count_);

/// The codes of Signal::navigation_source: which receiver the course deviations come from.
enum class NavigationSource : std::uint8_t { none, radio1, radio2, gnss };
inline constexpr double kMaxNavigationSource = static_cast<double>(NavigationSource::gnss);

/// Computed by the display; no bus states it.
[[nodiscard]] constexpr bool is_computed(Signal signal) {
    return signal == Signal::airspeed_rate || signal == Signal::height_above_terrain;
}

[[nodiscard]] const char* to_string(Signal signal) noexcept;
/// Returns count_ when the name is unknown.
[[nodiscard]] Signal signal_from_name(std::string_view name) noexcept;

}  // namespace tedavis::flight
