#include "host_sim/scenario/example_approach.hpp"

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using base::radians;
using flight::Signal;

constexpr double kGroundSpeed_mps = 52, kTrack_deg = 24, kSink_mps = 2.6;

struct StatedValue {
    Signal signal;
    double value;  ///< SI units
};

const StatedValue kStated[] = {
    {Signal::ground_speed, kGroundSpeed_mps},
    {Signal::true_track, radians(kTrack_deg)},
    {Signal::horizontal_accuracy, 3},
    {Signal::vertical_accuracy, 5},
    {Signal::magnetic_variation, 0},
    {Signal::normal_acceleration, base::kStandardGravity},
    {Signal::lateral_acceleration, 0.5},
    {Signal::indicated_airspeed, 104 * base::kMpsPerKnot},
    {Signal::airspeed_rate, 0.9},
    {Signal::baro_altitude, 2030 * base::kMetresPerFoot},
    {Signal::baro_setting, 101'600},
    {Signal::vertical_speed, -kSink_mps},
    {Signal::radio_height, 820 * base::kMetresPerFoot},
    {Signal::wind_speed, 9 * base::kMpsPerKnot},
    {Signal::wind_direction, radians(310)},
    {Signal::outside_temperature, 287},
    {Signal::heading_rate, radians(1)},
    {Signal::flaps_position, 1},
    {Signal::navigation_source, static_cast<double>(flight::NavigationSource::radio1)},
    {Signal::selected_course, radians(32)},
    {Signal::ils1_localizer_deviation, radians(-1.2)},
    {Signal::ils1_glideslope_deviation, radians(0.25)},
    {Signal::waypoint_bearing, radians(60)},
    {Signal::selected_glidepath, radians(3)},
    {Signal::flight_director_pitch, radians(2.5)},
    {Signal::flight_director_roll, radians(9)},
    {Signal::selected_altitude, 2100 * base::kMetresPerFoot},
    {Signal::selected_heading, radians(350)},
    {Signal::selected_airspeed, 108 * base::kMpsPerKnot},
    {Signal::selected_vertical_speed, -800 * base::kMpsPerFootPerMinute},
    {Signal::decision_height, 200 * base::kMetresPerFoot},
    {Signal::minimum_altitude, 1850 * base::kMetresPerFoot},
};

}  // namespace

AircraftPose example_approach_pose() {
    AircraftPose pose;
    pose.latitude_deg = 36.5807;
    pose.longitude_deg = -84.1875;
    pose.altitude_msl_m = 640;
    pose.heading_deg = 20;
    pose.pitch_deg = 2;
    pose.roll_deg = 12;
    return pose;
}

flight::FrameInput example_approach(display::Display& display) {
    const AircraftPose pose = example_approach_pose();
    flight::FrameInput input;
    input.time = pose.time;
    input.state = posed_aircraft(pose, display);
    input.state.is_posed = false;  // all that a flight has is stated
    for (const StatedValue& stated : kStated) input.state[stated.signal] = {stated.value, pose.time};
    flight::OwnShipEstimate& own = input.state.own_ship;
    own.velocity_north_mps = kGroundSpeed_mps * std::cos(radians(kTrack_deg));
    own.velocity_east_mps = kGroundSpeed_mps * std::sin(radians(kTrack_deg));
    own.velocity_up_mps = -kSink_mps;
    input.phase.phase = flight::kApproachFinal;
    input.phase.source = flight::PhaseSource::switches;
    return input;
}

}  // namespace tedavis::host_sim
