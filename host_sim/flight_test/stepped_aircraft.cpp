#include "host_sim/flight_test/stepped_aircraft.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/flight_log/pressure_altitude.hpp"
#include "host_sim/flight_test/signal_value.hpp"
#include "host_sim/scenario/local_plane.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double kRadioRange_m = 760;
constexpr double kPositionAccuracy_m = 3;

/// Density of the standard atmosphere by that at sea level.
double relative_density(double altitude_m) {
    return standard_pressure_pa(altitude_m) / standard_pressure_pa(0) * standard_temperature_k(0) /
           standard_temperature_k(altitude_m);
}

}  // namespace

SteppedAircraft::SteppedAircraft(const TestStart& start)
    : latitude_rad_(start.latitude_rad),
      longitude_rad_(start.longitude_rad),
      altitude_msl_m_(start.altitude_msl_m),
      ground_msl_m_(start.ground_msl_m),
      geoid_(GeoidEgm96::installed()) {
    set_usual_values(start);
}

void SteppedAircraft::set_usual_values(const TestStart& start) {
    for (const Signal signal : {Signal::pitch, Signal::roll, Signal::pitch_rate, Signal::roll_rate, Signal::yaw_rate,
                                Signal::longitudinal_acceleration, Signal::lateral_acceleration, Signal::wind_speed,
                                Signal::wind_direction, Signal::magnetic_variation, Signal::heading_rate})
        values_[signal] = 0;
    values_[Signal::normal_acceleration] = base::kStandardGravity;
    values_[Signal::baro_setting] = kStandardPressure_pa;
    values_[Signal::horizontal_accuracy] = values_[Signal::vertical_accuracy] = kPositionAccuracy_m;
    values_[Signal::ground_speed] = start.speed_mps;
    values_[Signal::true_track] = start.heading_rad;
    values_[Signal::vertical_speed] = start.climb_mps;
}

void SteppedAircraft::take(const TestStep& step, double time_s) {
    const SignalSample now = sample();
    for (const SignalTarget& target : step.hold) {
        const auto place = static_cast<std::size_t>(target.signal);
        values_[target.signal] = target.si;
        is_held_[place] = true;
        ramps_[place].reset();
    }
    for (const SignalTarget& target : step.ramp) {
        const auto place = static_cast<std::size_t>(target.signal);
        const double from = now.has(target.signal) ? now[target.signal] : target.si;
        const double way = is_direction(target.signal) ? std::remainder(target.si - from, 2 * base::kPi) : target.si - from;
        ramps_[place] = Ramp{from, from + way, time_s, step.over_s};
        values_[target.signal] = from;
        is_held_[place] = true;
    }
}

void SteppedAircraft::follow_ramps() {
    for (std::size_t n = 0; n < flight::kSignalCount; ++n) {
        if (!ramps_[n]) continue;
        const double share = std::clamp((time_s_ - ramps_[n]->begin_s) / ramps_[n]->over_s, 0.0, 1.0);
        const double value = ramps_[n]->from + share * (ramps_[n]->to - ramps_[n]->from);
        values_.values[n] = is_direction(static_cast<Signal>(n)) ? earth::wrap_heading(value) : value;
        if (share >= 1) ramps_[n].reset();
    }
}

void SteppedAircraft::move(double seconds) {
    const double way_m = values_[Signal::ground_speed] * seconds, track_rad = values_[Signal::true_track];
    const PlanePlace place =
        LocalPlane(latitude_rad_, longitude_rad_).at(way_m * std::sin(track_rad), way_m * std::cos(track_rad));
    latitude_rad_ = place.latitude_rad;
    longitude_rad_ = place.longitude_rad;
    altitude_msl_m_ += values_[Signal::vertical_speed] * seconds;
}

void SteppedAircraft::advance_to(double time_s) {
    constexpr double kRounding_s = 1e-9;
    while (time_s_ + kRounding_s < time_s) {
        const double step_s = std::min(kStep_s, time_s - time_s_);
        time_s_ += step_s;
        follow_ramps();
        move(step_s);
    }
}

void SteppedAircraft::put(SignalSample& sample, Signal signal, double value) const {
    if (!is_held_[static_cast<std::size_t>(signal)]) sample[signal] = value;
}

void SteppedAircraft::derive(SignalSample& sample) const {
    const double airspeed_mps = sample[Signal::ground_speed];
    const double indicated_mps = airspeed_mps * std::sqrt(relative_density(altitude_msl_m_));
    put(sample, Signal::latitude, latitude_rad_);
    put(sample, Signal::longitude, longitude_rad_);
    put(sample, Signal::ellipsoid_height, altitude_msl_m_ + geoid_.undulation(latitude_rad_, longitude_rad_).m);
    put(sample, Signal::true_heading, sample[Signal::true_track]);
    put(sample, Signal::true_airspeed, airspeed_mps);
    put(sample, Signal::indicated_airspeed, indicated_mps);
    put(sample, Signal::calibrated_airspeed, indicated_mps);
    put(sample, Signal::true_altitude, altitude_msl_m_);
    put(sample, Signal::baro_altitude, altitude_msl_m_);
    put(sample, Signal::standard_altitude, altitude_msl_m_);
    put(sample, Signal::outside_temperature, standard_temperature_k(altitude_msl_m_));
    if (!ground_msl_m_) return;
    const double height_m = std::max(altitude_msl_m_ - *ground_msl_m_, 0.0);
    put(sample, Signal::radio_height, height_m <= kRadioRange_m ? height_m : std::numeric_limits<double>::quiet_NaN());
}

SignalSample SteppedAircraft::sample() const {
    SignalSample sample = values_;
    derive(sample);
    return sample;
}

}  // namespace tedavis::host_sim
