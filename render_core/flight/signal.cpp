#include "render_core/flight/signal.hpp"

namespace tedavis::flight {
namespace {

constexpr const char* kNames[] = {
    "latitude",
    "longitude",
    "ellipsoid_height",
    "ground_speed",
    "true_track",
    "horizontal_accuracy",
    "vertical_accuracy",
    "pitch",
    "roll",
    "true_heading",
    "magnetic_heading",
    "magnetic_variation",
    "sideslip",
    "pitch_rate",
    "roll_rate",
    "yaw_rate",
    "longitudinal_acceleration",
    "lateral_acceleration",
    "normal_acceleration",
    "indicated_airspeed",
    "true_airspeed",
    "calibrated_airspeed",
    "standard_altitude",
    "baro_altitude",
    "baro_setting",
    "vertical_speed",
    "radio_height",
    "wind_speed",
    "wind_direction",
    "outside_temperature",
    "true_altitude",
    "heading_rate",
    "flaps_lever",
    "flaps_position",
    "navigation_source",
    "ils1_localizer_deviation",
    "ils1_glideslope_deviation",
    "ils2_localizer_deviation",
    "ils2_glideslope_deviation",
    "cross_track_deviation",
    "gnss_vertical_deviation",
    "desired_track",
    "waypoint_bearing",
    "selected_course",
    "selected_glidepath",
    "flight_director_pitch",
    "flight_director_roll",
    "selected_altitude",
    "selected_heading",
    "selected_airspeed",
    "selected_vertical_speed",
    "decision_height",
    "minimum_altitude",
    "airspeed_rate",
    "height_above_terrain",
};
static_assert(sizeof kNames / sizeof kNames[0] == kSignalCount);

}  // namespace

const char* to_string(Signal signal) noexcept {
    const auto index = static_cast<std::size_t>(signal);
    return index < kSignalCount ? kNames[index] : "unknown";
}

Signal signal_from_name(std::string_view name) noexcept {
    for (std::size_t i = 0; i < kSignalCount; ++i)
        if (name == kNames[i]) return static_cast<Signal>(i);
    return Signal::count_;
}

}  // namespace tedavis::flight
