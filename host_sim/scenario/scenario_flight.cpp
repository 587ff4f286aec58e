#include "host_sim/scenario/scenario_flight.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/flight_log/pressure_altitude.hpp"
#include "host_sim/scenario/leg_pilot.hpp"
#include "host_sim/scenario/scenario_guidance.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double kLongestLeg_s = 900;
constexpr int kWaves = 6;
constexpr double kRollAmplitude_rad = base::radians(1.2);  // sum of all waves at turbulence 1
constexpr double kPitchAmplitude_rad = base::radians(0.5);
constexpr double kSlowestWave_radps = 0.8, kFastestWave_radps = 5.0;
constexpr double kGnssHorizontal_m = 3.0, kGnssVertical_m = 5.0;  // figures of merit of a good receiver
constexpr double kRateStep_s = 0.02;                              // of the differences that give body rates

double mix(double a, double b, double share) { return a + (b - a) * share; }

}  // namespace

ScenarioFlight::ScenarioFlight(const Scenario& scenario, std::uint64_t seed, const GeoidEgm96& geoid)
    : scenario_(scenario), geoid_(geoid), traffic_(scenario.traffic, scenario.start, seed, geoid) {
    if (scenario_.radio_altimeter) radio_altimeter_.emplace(*scenario_.radio_altimeter, scenario_.strip);
    draw_random(seed);
    LegPilot pilot(scenario_, air_);
    states_.push_back(pilot.state());
    for (std::size_t i = 0; i < scenario_.legs.size(); ++i) {
        const Leg& leg = scenario_.legs[i];
        const double begin_s = static_cast<double>(states_.size() - 1) / kStepsPerSecond;
        const std::size_t limit = states_.size() + static_cast<std::size_t>(kLongestLeg_s / kScenarioStep_s);
        pilot.begin(leg);
        for (bool ended = false; !ended;) {
            ended = pilot.step(leg);
            states_.push_back(pilot.state());
            if (!ended && states_.size() > limit) {
                throw UserError("scenario " + scenario_.name + ": leg " + std::to_string(i + 1) +
                                " does not end within 15 minutes; check its target and limits");
            }
        }
        legs_.push_back({begin_s, static_cast<double>(states_.size() - 1) / kStepsPerSecond});
    }
    add_turbulence();
}

void ScenarioFlight::draw_random(std::uint64_t seed) {
    SeededRandom random(seed);
    const Environment& e = scenario_.environment;
    air_.qnh_pa = std::round(random.within(e.qnh_pa, e.qnh_spread_pa) / 100) * 100;  // altimeters are set in whole hectopascals
    air_.temperature_deviation_k = random.within(e.temperature_deviation_k, e.temperature_spread_k);
    air_.wind_speed_mps = std::max(0.0, random.within(e.wind_speed_mps, e.wind_speed_spread_mps));
    air_.wind_from_rad = random.within(e.wind_from_rad, e.wind_from_spread_rad);
    for (auto* waves : {&roll_waves_, &pitch_waves_}) {
        const double total = e.turbulence * (waves == &roll_waves_ ? kRollAmplitude_rad : kPitchAmplitude_rad);
        for (int i = 0; i < kWaves; ++i) {
            const double frequency = mix(kSlowestWave_radps, kFastestWave_radps, random.unit());
            waves->push_back({total / kWaves, frequency, 2 * base::kPi * random.unit()});
        }
    }
}

void ScenarioFlight::add_turbulence() {
    const auto sum_at = [](const std::vector<Wave>& waves, double t) {
        double sum = 0;
        for (const Wave& wave : waves) sum += wave.amplitude_rad * std::sin(wave.frequency_radps * t + wave.phase_rad);
        return sum;
    };
    for (std::size_t i = 0; i < states_.size(); ++i) {
        const double t = static_cast<double>(i) * kScenarioStep_s;
        states_[i].roll_rad += states_[i].wind_share * sum_at(roll_waves_, t);
        states_[i].pitch_rad += states_[i].wind_share * sum_at(pitch_waves_, t);
    }
}

base::Time ScenarioFlight::end() const {
    return scenario_.start + base::Duration::from_seconds(static_cast<double>(states_.size() - 1) * kScenarioStep_s);
}

ScenarioFlight::State ScenarioFlight::state_at(double time_s) const {
    const double place = std::clamp(time_s / kScenarioStep_s, 0.0, static_cast<double>(states_.size() - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(place), states_.size() - 2);
    const State &a = states_[i], &b = states_[i + 1];
    const double share = place - static_cast<double>(i);
    State state;
    for (double State::*member :
         {&State::latitude_rad, &State::longitude_rad, &State::altitude_msl_m, &State::north_mps, &State::east_mps,
          &State::up_mps, &State::airspeed_mps, &State::heading_rad, &State::pitch_rad, &State::roll_rad, &State::wind_share}) {
        state.*member = mix(a.*member, b.*member, share);
    }
    return state;
}

std::optional<SignalSample> ScenarioFlight::at(base::Time time) const {
    if (time < begin() || time > end()) return std::nullopt;
    const double t = (time - begin()).to_seconds();
    const State state = state_at(t);
    SignalSample sample;
    sample[Signal::latitude] = state.latitude_rad;
    sample[Signal::longitude] = earth::wrap_longitude(state.longitude_rad);
    sample[Signal::ellipsoid_height] = state.altitude_msl_m + geoid_.undulation(state.latitude_rad, state.longitude_rad).m;
    sample[Signal::true_altitude] = state.altitude_msl_m;
    sample[Signal::ground_speed] = std::hypot(state.north_mps, state.east_mps);
    const bool moving = sample[Signal::ground_speed] > 0.5;
    sample[Signal::true_track] = earth::wrap_heading(moving ? std::atan2(state.east_mps, state.north_mps) : state.heading_rad);
    sample[Signal::vertical_speed] = state.up_mps;
    sample[Signal::horizontal_accuracy] = kGnssHorizontal_m;
    sample[Signal::vertical_accuracy] = kGnssVertical_m;
    sample[Signal::pitch] = state.pitch_rad;
    sample[Signal::roll] = state.roll_rad;
    sample[Signal::true_heading] = earth::wrap_heading(state.heading_rad);
    sample[Signal::magnetic_variation] = scenario_.environment.magnetic_variation_rad;
    add_air_data(state, sample);
    add_radio_height(state, sample);
    add_motion(t, state, sample);
    if (scenario_.guidance) ScenarioGuidance(scenario_, *this, instruments_of_air()).add(t, sample);
    return sample;
}

AirInstruments ScenarioFlight::instruments_of_air() const {
    return {scenario_.strip.elevation_msl_m, air_.qnh_pa, air_.temperature_deviation_k};
}

/// The altimeter shows the field's elevation on the ground; above it the air column is warmer or colder than standard.
void ScenarioFlight::add_air_data(const State& state, SignalSample& sample) const {
    const AirInstruments instruments = instruments_of_air();
    sample[Signal::baro_setting] = air_.qnh_pa;
    sample[Signal::baro_altitude] = instruments.baro_altitude_m(state.altitude_msl_m);
    sample[Signal::standard_altitude] = standard_altitude(sample[Signal::baro_altitude], air_.qnh_pa);
    sample[Signal::outside_temperature] = instruments.outside_temperature_k(state.altitude_msl_m);
    sample[Signal::true_airspeed] = state.airspeed_mps;
    sample[Signal::calibrated_airspeed] = state.airspeed_mps * instruments.airspeed_ratio(state.altitude_msl_m);
    sample[Signal::indicated_airspeed] = sample[Signal::calibrated_airspeed];
    sample[Signal::wind_speed] = state.wind_share * air_.wind_speed_mps;
    sample[Signal::wind_direction] = earth::wrap_heading(air_.wind_from_rad);
}

/// It reads 0 where the wheels stand on the ground, and no less.
void ScenarioFlight::add_radio_height(const State& state, SignalSample& sample) const {
    if (!radio_altimeter_) return;
    const double wheels_msl_m = state.altitude_msl_m - scenario_.aircraft.antenna_height_m;
    const auto height_m = radio_altimeter_->height_m(state.latitude_rad, state.longitude_rad, wheels_msl_m);
    if (height_m) sample[Signal::radio_height] = std::max(0.0, *height_m);
}

/// Body rates and specific forces (what accelerometers feel: 1 g upwards at rest) from differences of the flown states.
void ScenarioFlight::add_motion(double time_s, const State& state, SignalSample& sample) const {
    const State before = state_at(time_s - kRateStep_s / 2), after = state_at(time_s + kRateStep_s / 2);
    const double heading_rate = (after.heading_rad - before.heading_rad) / kRateStep_s;
    const double pitch_rate = (after.pitch_rad - before.pitch_rad) / kRateStep_s;
    const double roll_rate = (after.roll_rad - before.roll_rad) / kRateStep_s;
    const double cr = std::cos(state.roll_rad), sr = std::sin(state.roll_rad), cp = std::cos(state.pitch_rad),
                 sp = std::sin(state.pitch_rad);
    sample[Signal::heading_rate] = heading_rate;
    sample[Signal::roll_rate] = roll_rate - heading_rate * sp;
    sample[Signal::pitch_rate] = pitch_rate * cr + heading_rate * cp * sr;
    sample[Signal::yaw_rate] = heading_rate * cp * cr - pitch_rate * sr;
    const double c = std::cos(state.heading_rad), s = std::sin(state.heading_rad);
    const double north = (after.north_mps - before.north_mps) / kRateStep_s,
                 east = (after.east_mps - before.east_mps) / kRateStep_s;
    const double up = (after.up_mps - before.up_mps) / kRateStep_s + base::kStandardGravity;
    const double ahead = north * c + east * s, right = east * c - north * s;
    sample[Signal::longitudinal_acceleration] = ahead * cp + up * sp;
    const double lifted = up * cp - ahead * sp;
    sample[Signal::lateral_acceleration] = right * cr - lifted * sr;
    sample[Signal::normal_acceleration] = lifted * cr + right * sr;
}

std::optional<flight::FlightPhase> ScenarioFlight::stated_phase(base::Time time) const {
    const double t = (time - begin()).to_seconds();
    for (std::size_t i = 0; i < legs_.size(); ++i) {
        if (t < legs_[i].end_s || i + 1 == legs_.size()) {
            const Leg& leg = scenario_.legs[i];
            return leg.stated_by == PhaseStatedBy::can ? std::optional<flight::FlightPhase>(leg.phase) : std::nullopt;
        }
    }
    return std::nullopt;
}

}  // namespace tedavis::host_sim
