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
    normal_acceleration,        ///< m/s^2
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
    height_above_terrain,       ///< m, computed by the display from position and database
    count_                      ///< number of signals; not a signal
};
inline constexpr std::size_t kSignalCount = static_cast<std::size_t>(Signal::count_);

[[nodiscard]] const char* to_string(Signal signal) noexcept;
/// Returns count_ when the name is unknown.
[[nodiscard]] Signal signal_from_name(std::string_view name) noexcept;

}  // namespace tedavis::flight
