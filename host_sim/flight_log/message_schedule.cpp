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
    {333, Signal::wind_speed, DataType::float32, 200, 52},
    {334, Signal::wind_direction, DataType::float32, 200, 52},
    {335, Signal::outside_temperature, DataType::float32, 1000, 62},
    {1121, Signal::magnetic_variation, DataType::float32, 1000, 72},
    {1046, Signal::vertical_accuracy, DataType::float32, 1000, 82},
    {1047, Signal::horizontal_accuracy, DataType::float32, 1000, 82},
};

}  // namespace

base::Span<const ScheduledMessage> message_schedule() noexcept { return base::Span<const ScheduledMessage>(kSchedule); }

}  // namespace tedavis::host_sim
