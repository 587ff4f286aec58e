#include "host_sim/flight_log/message_schedule.hpp"

namespace tedavis::host_sim {
namespace {

using bus::DataType;
using flight::Signal;

constexpr ScheduledMessage kSchedule[] = {
    {311, Signal::pitch, DataType::float32, 20, 0},
    {312, Signal::roll, DataType::float32, 20, 0},
    {1133, Signal::true_heading, DataType::float32, 20, 0},
    {303, Signal::pitch_rate, DataType::float32, 20, 5},
    {304, Signal::roll_rate, DataType::float32, 20, 5},
    {305, Signal::yaw_rate, DataType::float32, 20, 5},
    {300, Signal::longitudinal_acceleration, DataType::float32, 20, 10},
    {301, Signal::lateral_acceleration, DataType::float32, 20, 10},
    {302, Signal::normal_acceleration, DataType::float32, 20, 10},
    {1036, Signal::latitude, DataType::double_high, 100, 2},
    {1037, Signal::longitude, DataType::double_high, 100, 2},
    {1038, Signal::ellipsoid_height, DataType::float32, 100, 2},
    {1039, Signal::ground_speed, DataType::float32, 100, 2},
    {1040, Signal::true_track, DataType::float32, 100, 2},
    {314, Signal::vertical_speed, DataType::float32, 100, 12},
    {315, Signal::indicated_airspeed, DataType::float32, 100, 22},
    {316, Signal::true_airspeed, DataType::float32, 100, 22},
    {317, Signal::calibrated_airspeed, DataType::float32, 100, 22},
    {320, Signal::baro_altitude, DataType::float32, 100, 32},
    {322, Signal::standard_altitude, DataType::float32, 100, 32},
    {332, Signal::true_altitude, DataType::float32, 100, 32},
    {319, Signal::baro_setting, DataType::float32, 1000, 42},
    {1070, Signal::radio_height, DataType::float32, 100, 97},
    {333, Signal::wind_speed, DataType::float32, 200, 52},
    {334, Signal::wind_direction, DataType::float32, 200, 52},
    {335, Signal::outside_temperature, DataType::float32, 1000, 62},
    {1121, Signal::magnetic_variation, DataType::float32, 1000, 72},
    {1046, Signal::vertical_accuracy, DataType::float32, 1000, 82},
    {1047, Signal::horizontal_accuracy, DataType::float32, 1000, 82},
    {327, Signal::heading_rate, DataType::float32, 100, 7},
    {1087, Signal::ils1_localizer_deviation, DataType::float32, 100, 17},
    {1091, Signal::ils1_glideslope_deviation, DataType::float32, 100, 17},
    {1042, Signal::cross_track_deviation, DataType::float32, 100, 27},
    {1120, Signal::desired_track, DataType::float32, 100, 27},
    {7, Signal::waypoint_bearing, DataType::float32, 100, 37, true},
    {1095, Signal::flight_director_pitch, DataType::float32, 100, 47},
    {1097, Signal::flight_director_roll, DataType::float32, 100, 47},
    {6, Signal::flaps_position, DataType::float32, 200, 57, true},
    {430, Signal::flaps_lever, DataType::float32, 1000, 67},
    {1099, Signal::decision_height, DataType::float32, 1000, 67},
    {1122, Signal::selected_glidepath, DataType::float32, 1000, 67},
    {1125, Signal::selected_course, DataType::float32, 1000, 67},
    {0, Signal::navigation_source, DataType::uchar8, 1000, 77, true},
    {1, Signal::selected_altitude, DataType::float32, 1000, 77, true},
    {2, Signal::selected_heading, DataType::float32, 1000, 77, true},
    {3, Signal::selected_airspeed, DataType::float32, 1000, 87, true},
    {4, Signal::selected_vertical_speed, DataType::float32, 1000, 87, true},
    {5, Signal::minimum_altitude, DataType::float32, 1000, 87, true},
};

}  // namespace

base::Span<const ScheduledMessage> message_schedule() noexcept { return base::Span<const ScheduledMessage>(kSchedule); }

}  // namespace tedavis::host_sim
