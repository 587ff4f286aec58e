#include "host_sim/scenario/scenario_guidance.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/flight_log/pressure_altitude.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using flight::NavigationSource;
using flight::Signal;

constexpr double kGasConstant = 287.05287;           // of air, J/(kg K)
constexpr double kSeaLevelDensity = 1.225;           // kg/m^3
constexpr double kTouchdownZone_m = 200;             // beyond the threshold
constexpr double kCoverage_rad = base::radians(35);  // of the localizer, either side
constexpr double kCoverage_m = 18'500;
constexpr double kGlideCoverage_rad = base::radians(10);
constexpr double kNearStrip_m = 50;       // nearer to an antenna its beam states nothing
constexpr double kLevelledWithin_m = 30;  // a leg that begins so near its altitude has no vertical speed selected

/// Metres north and east from one place to another nearby.
struct PlaneOffset {
    double north_m = 0, east_m = 0;
};
PlaneOffset plane_offset(double from_latitude_rad, double from_longitude_rad, double to_latitude_rad, double to_longitude_rad) {
    return {(to_latitude_rad - from_latitude_rad) * earth::meridian_radius_m(to_latitude_rad),
            earth::angle_difference(to_longitude_rad, from_longitude_rad) * earth::prime_vertical_radius_m(to_latitude_rad) *
                std::cos(to_latitude_rad)};
}

bool has_target(const Leg& leg) { return leg.kind == LegKind::hold || leg.kind == LegKind::fly_to; }
bool is_landing(const Leg& leg) { return leg.kind == LegKind::final_leg || leg.kind == LegKind::land; }

}  // namespace

double AirInstruments::baro_altitude_m(double altitude_msl_m) const {
    const double above_m = altitude_msl_m - field_msl_m;
    const double standard_k = standard_temperature_k(field_msl_m + above_m / 2);
    return field_msl_m + above_m * standard_k / (standard_k + temperature_deviation_k);
}

double AirInstruments::outside_temperature_k(double altitude_msl_m) const {
    return standard_temperature_k(standard_altitude(baro_altitude_m(altitude_msl_m), qnh_pa)) + temperature_deviation_k;
}

double AirInstruments::airspeed_ratio(double altitude_msl_m) const {
    const double pressure_pa = standard_pressure_pa(standard_altitude(baro_altitude_m(altitude_msl_m), qnh_pa));
    return std::sqrt(pressure_pa / (kGasConstant * outside_temperature_k(altitude_msl_m)) / kSeaLevelDensity);
}

NavigationSource ScenarioGuidance::source_on(const Leg& leg, const ScenarioFlight::State& state) const {
    if (is_landing(leg)) return to_touchdown_zone_m(state) > kNearStrip_m ? NavigationSource::radio1 : NavigationSource::none;
    return leg.kind == LegKind::fly_to ? NavigationSource::gnss : NavigationSource::none;
}

double ScenarioGuidance::to_touchdown_zone_m(const ScenarioFlight::State& state) const {
    return kTouchdownZone_m - scenario_.strip.length_m / 2 - from_strip(state).along_m;
}

std::size_t ScenarioGuidance::leg_at(double time_s) const {
    const auto& legs = flight_.legs();
    const auto leg = std::find_if(legs.begin(), legs.end(), [&](const auto& flown) { return time_s < flown.end_s; });
    return leg == legs.end() ? legs.size() - 1 : static_cast<std::size_t>(leg - legs.begin());
}

const ScenarioFlight::State& ScenarioGuidance::state_near(double time_s) const {
    const auto& states = flight_.states();
    const double place = std::clamp(std::round(time_s * kStepsPerSecond), 0.0, static_cast<double>(states.size() - 1));
    return states[static_cast<std::size_t>(place)];
}

ScenarioGuidance::FromStrip ScenarioGuidance::from_strip(const ScenarioFlight::State& state) const {
    const LandingStrip& strip = scenario_.strip;
    const PlaneOffset offset = plane_offset(strip.latitude_rad, strip.longitude_rad, state.latitude_rad, state.longitude_rad);
    const double c = std::cos(strip.heading_rad), s = std::sin(strip.heading_rad);
    return {offset.north_m * c + offset.east_m * s, offset.east_m * c - offset.north_m * s};
}

void ScenarioGuidance::add(double time_s, SignalSample& sample) const {
    const std::size_t leg = leg_at(time_s);
    const ScenarioFlight::State& state = state_near(time_s);
    sample[Signal::navigation_source] = static_cast<double>(source_on(scenario_.legs[leg], state));
    sample[Signal::flaps_lever] = scenario_.legs[leg].flaps;
    sample[Signal::flaps_position] = flaps_position(time_s);
    sample[Signal::decision_height] = guidance_.decision_height_m;
    sample[Signal::minimum_altitude] = instruments_.baro_altitude_m(guidance_.minimum_msl_m);
    add_selected(leg, sample);
    add_landing_aids(state, sample);
    add_route(leg, state, sample);
    add_director(time_s, sample);
}

/// The flaps follow their lever at the speed of full travel in `flaps_travel_s`.
double ScenarioGuidance::flaps_position(double time_s) const {
    double position = scenario_.legs.front().flaps;
    for (std::size_t i = 0; i < scenario_.legs.size() && flight_.legs()[i].begin_s <= time_s; ++i) {
        const double moved = (std::min(time_s, flight_.legs()[i].end_s) - flight_.legs()[i].begin_s) / guidance_.flaps_travel_s;
        position += std::clamp(scenario_.legs[i].flaps - position, -moved, moved);
    }
    return position;
}

/// Before and on the strip, and on final, the altitude of the next leg that has one is selected already.
void ScenarioGuidance::add_selected(std::size_t leg, SignalSample& sample) const {
    const auto& legs = scenario_.legs;
    const Leg& flown = legs[leg];
    for (std::size_t i = leg; i < legs.size() && !sample.has(Signal::selected_altitude); ++i)
        if (has_target(legs[i])) sample[Signal::selected_altitude] = instruments_.baro_altitude_m(legs[i].altitude_msl_m);
    if (flown.kind != LegKind::fly_to)
        sample[Signal::selected_heading] = flown.kind == LegKind::hold ? flown.heading_rad : scenario_.strip.heading_rad;
    if (flown.speed_mps > 0) {
        const double altitude_m = has_target(flown) ? flown.altitude_msl_m : scenario_.strip.elevation_msl_m;
        sample[Signal::selected_airspeed] = flown.speed_mps * instruments_.airspeed_ratio(altitude_m);
    }
    if (!has_target(flown)) return;
    const double climb_m = flown.altitude_msl_m - state_near(flight_.legs()[leg].begin_s).altitude_msl_m;
    if (std::abs(climb_m) > kLevelledWithin_m) sample[Signal::selected_vertical_speed] = std::copysign(flown.climb_mps, climb_m);
}

void ScenarioGuidance::add_landing_aids(const ScenarioFlight::State& state, SignalSample& sample) const {
    const auto landing = std::find_if(scenario_.legs.begin(), scenario_.legs.end(), is_landing);
    if (landing == scenario_.legs.end()) return;
    sample[Signal::selected_course] = scenario_.strip.heading_rad;
    sample[Signal::selected_glidepath] = landing->glide_rad;
    const FromStrip place = from_strip(state);
    const double to_antenna_m = scenario_.strip.length_m / 2 + kLocalizerBeyond_m - place.along_m;
    const double off_course = std::atan2(place.right_m, to_antenna_m);
    const bool is_covered = std::hypot(to_antenna_m, place.right_m) < kCoverage_m && std::abs(off_course) < kCoverage_rad;
    if (!is_covered || to_antenna_m < kNearStrip_m) return;
    sample[Signal::ils1_localizer_deviation] = off_course;
    const double to_aim_m = to_touchdown_zone_m(state);
    const double height_m = state.altitude_msl_m - scenario_.aircraft.antenna_height_m - scenario_.strip.elevation_msl_m;
    const double above_path = std::atan2(height_m, to_aim_m) - landing->glide_rad;
    if (to_aim_m > kNearStrip_m && std::abs(above_path) < kGlideCoverage_rad)
        sample[Signal::ils1_glideslope_deviation] = above_path;
}

/// The desired track leads straight from where the leg begins to its point.
void ScenarioGuidance::add_route(std::size_t leg, const ScenarioFlight::State& state, SignalSample& sample) const {
    const Leg& flown = scenario_.legs[leg];
    if (flown.kind != LegKind::fly_to) return;
    const ScenarioFlight::State& begin = state_near(flight_.legs()[leg].begin_s);
    const PlaneOffset whole = plane_offset(begin.latitude_rad, begin.longitude_rad, flown.latitude_rad, flown.longitude_rad);
    const PlaneOffset left = plane_offset(state.latitude_rad, state.longitude_rad, flown.latitude_rad, flown.longitude_rad);
    const double track = std::atan2(whole.east_m, whole.north_m);
    sample[Signal::desired_track] = earth::wrap_heading(track);
    sample[Signal::cross_track_deviation] = left.north_m * std::sin(track) - left.east_m * std::cos(track);
    sample[Signal::waypoint_bearing] = earth::wrap_heading(std::atan2(left.east_m, left.north_m));
}

void ScenarioGuidance::add_director(double time_s, SignalSample& sample) const {
    const ScenarioFlight::State &now = state_near(time_s), &later = state_near(time_s + kDirectorLead_s);
    sample[Signal::flight_director_pitch] = later.pitch_rad - now.pitch_rad;
    sample[Signal::flight_director_roll] = later.roll_rad - now.roll_rad;
}

}  // namespace tedavis::host_sim
