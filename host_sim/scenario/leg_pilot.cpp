#include "host_sim/scenario/leg_pilot.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kTurnGain_per_s = 0.5;  // turn rate for one radian of track error
constexpr double kAltitudeGain_per_s = 0.25;
constexpr double kSpeedGain_per_s = 0.4;
constexpr double kGlideGain_per_s = 0.35;
constexpr double kBankBandwidth = 2.5, kClimbBandwidth = 1.2, kPitchBandwidth = 2.0, kThrustBandwidth = 1.5;
constexpr double kLargestVerticalAcceleration_mps2 = 5.0;
constexpr double kLargestPitchRate_radps = 0.2;
constexpr double kLargestJerk_mps3 = 2.0;
constexpr double kWindFullAbove_m = 80.0;        // free wind from this height above the strip
constexpr double kCentreLineLead_m = 350.0;      // distance ahead at which the centre line is aimed at
constexpr double kAimBeyondThreshold_m = 200.0;  // touchdown zone
constexpr double kFlareBelow_m = 14.0;
constexpr double kTouchdownSink_mps = 0.7;
constexpr double kFlareTime_s = 3.5;
constexpr double kReferenceSpeed_mps = 60.0;
constexpr double kReferenceAttack_rad = base::radians(4.0);
constexpr double kLargestAttack_rad = base::radians(9.0);
constexpr double kRollEndsBefore_m = 60.0;  // start of the take-off roll from the strip's end
constexpr double kLevelledOff_m = 4.0;

double smooth_step(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

}  // namespace

LegPilot::LegPilot(const Scenario& scenario, const FlownAir& air)
    : scenario_(scenario),
      air_(air),
      bank_(0, kBankBandwidth, scenario.aircraft.roll_rate_radps),
      climb_(0, kClimbBandwidth, kLargestVerticalAcceleration_mps2),
      pitch_(0, kPitchBandwidth, kLargestPitchRate_radps),
      thrust_(0, kThrustBandwidth, kLargestJerk_mps3) {
    const LandingStrip& strip = scenario.strip;
    const double back_m = strip.length_m / 2 - kRollEndsBefore_m;
    state_.latitude_rad =
        strip.latitude_rad - back_m * std::cos(strip.heading_rad) / earth::meridian_radius_m(strip.latitude_rad);
    state_.longitude_rad =
        strip.longitude_rad - back_m * std::sin(strip.heading_rad) /
                                  (earth::prime_vertical_radius_m(strip.latitude_rad) * std::cos(strip.latitude_rad));
    state_.altitude_msl_m = strip.elevation_msl_m + scenario.aircraft.antenna_height_m;
    state_.heading_rad = strip.heading_rad;
}

void LegPilot::begin(const Leg&) {
    leg_time_s_ = 0;
    stopped_ = false;
}

bool LegPilot::step(const Leg& leg) {
    leg_time_s_ += kScenarioStep_s;
    if (leg.kind == LegKind::stand) roll_on_ground(0);
    if (leg.kind == LegKind::roll) {
        thrust_.step(leg.acceleration_mps2, kScenarioStep_s);
        roll_on_ground(thrust_.value());
    } else if (leg.kind == LegKind::land && !airborne_) {
        thrust_.step(-leg.acceleration_mps2, kScenarioStep_s);
        roll_on_ground(thrust_.value());
        stopped_ = state_.airspeed_mps <= 0;
    } else if (leg.kind != LegKind::stand) {
        airborne_ = true;
        fly(leg);
        if (leg.kind == LegKind::land && wheels_above_strip_m() <= 0) {
            airborne_ = false;
            state_.altitude_msl_m = scenario_.strip.elevation_msl_m + scenario_.aircraft.antenna_height_m;
        }
    }
    move();
    return ended(leg);
}

void LegPilot::roll_on_ground(double acceleration_mps2) {
    airborne_ = false;
    bank_.step(0, kScenarioStep_s);
    pitch_.step(0, kScenarioStep_s);
    climb_ = SmoothedValue(0, kClimbBandwidth, kLargestVerticalAcceleration_mps2);
    state_.airspeed_mps = std::max(0.0, state_.airspeed_mps + acceleration_mps2 * kScenarioStep_s);
    // Steering on the ground: what is left of a crab angle runs out over a second.
    state_.heading_rad += earth::angle_difference(scenario_.strip.heading_rad, state_.heading_rad) * kScenarioStep_s;
}

void LegPilot::fly(const Leg& leg) {
    const double error = earth::angle_difference(course(leg), track_rad());
    const double wanted_rate = kTurnGain_per_s * error;
    const double wanted_bank = std::atan(state_.airspeed_mps * wanted_rate / base::kStandardGravity);
    const bool close_to_ground = wheels_above_strip_m() < kFlareBelow_m;
    const double bank_limit = close_to_ground ? scenario_.aircraft.bank_rad / 6 : scenario_.aircraft.bank_rad;
    bank_.step(std::clamp(wanted_bank, -bank_limit, bank_limit), kScenarioStep_s);
    state_.heading_rad += base::kStandardGravity * std::tan(bank_.value()) / state_.airspeed_mps * kScenarioStep_s;
    climb_.step(vertical_target_mps(leg), kScenarioStep_s);
    const double limit = scenario_.aircraft.acceleration_mps2;
    thrust_.step(std::clamp(kSpeedGain_per_s * (leg.speed_mps - state_.airspeed_mps), -limit, limit), kScenarioStep_s);
    state_.airspeed_mps += thrust_.value() * kScenarioStep_s;
    const double ratio = kReferenceSpeed_mps / state_.airspeed_mps;
    const double attack = std::min(kLargestAttack_rad, kReferenceAttack_rad * ratio * ratio / std::cos(bank_.value()));
    pitch_.step(std::atan2(climb_.value(), state_.airspeed_mps) + attack, kScenarioStep_s);
}

/// Velocities from the air path and the wind, then one step of the position on the ellipsoid.
void LegPilot::move() {
    state_.wind_share = smooth_step(wheels_above_strip_m() / kWindFullAbove_m);
    const double wind_mps = state_.wind_share * air_.wind_speed_mps;
    state_.north_mps = state_.airspeed_mps * std::cos(state_.heading_rad) - wind_mps * std::cos(air_.wind_from_rad);
    state_.east_mps = state_.airspeed_mps * std::sin(state_.heading_rad) - wind_mps * std::sin(air_.wind_from_rad);
    state_.up_mps = climb_.value();
    state_.roll_rad = bank_.value();
    state_.pitch_rad = pitch_.value();
    const double height = state_.altitude_msl_m;
    state_.latitude_rad += state_.north_mps * kScenarioStep_s / (earth::meridian_radius_m(state_.latitude_rad) + height);
    state_.longitude_rad += state_.east_mps * kScenarioStep_s /
                            ((earth::prime_vertical_radius_m(state_.latitude_rad) + height) * std::cos(state_.latitude_rad));
    state_.altitude_msl_m += state_.up_mps * kScenarioStep_s;
}

LegPilot::StripCoordinates LegPilot::on_strip() const {
    const LandingStrip& strip = scenario_.strip;
    const double north = (state_.latitude_rad - strip.latitude_rad) * earth::meridian_radius_m(strip.latitude_rad);
    const double east = earth::angle_difference(state_.longitude_rad, strip.longitude_rad) *
                        earth::prime_vertical_radius_m(strip.latitude_rad) * std::cos(strip.latitude_rad);
    const double c = std::cos(strip.heading_rad), s = std::sin(strip.heading_rad);
    return {north * c + east * s, east * c - north * s};
}

double LegPilot::wheels_above_strip_m() const {
    return state_.altitude_msl_m - scenario_.aircraft.antenna_height_m - scenario_.strip.elevation_msl_m;
}

double LegPilot::track_rad() const { return std::atan2(state_.east_mps, state_.north_mps); }

double LegPilot::course(const Leg& leg) const {
    if (leg.kind == LegKind::hold) return leg.heading_rad;
    if (leg.kind == LegKind::fly_to) {
        const double north = (leg.latitude_rad - state_.latitude_rad) * earth::meridian_radius_m(leg.latitude_rad);
        const double east = earth::angle_difference(leg.longitude_rad, state_.longitude_rad) *
                            earth::prime_vertical_radius_m(leg.latitude_rad) * std::cos(leg.latitude_rad);
        return std::atan2(east, north);
    }
    return scenario_.strip.heading_rad - std::atan2(on_strip().right_m, kCentreLineLead_m);
}

double LegPilot::glide_vertical_mps(const Leg& leg) const {
    const double ground_speed = std::hypot(state_.north_mps, state_.east_mps);
    const double to_aim_m = -scenario_.strip.length_m / 2 + kAimBeyondThreshold_m - on_strip().along_m;
    const double off_glide_m = to_aim_m * std::tan(leg.glide_rad) - wheels_above_strip_m();
    // From above the glide path the aircraft descends at most twice as steeply; from below it levels off.
    const double on_glide = -ground_speed * std::tan(leg.glide_rad);
    return std::clamp(on_glide + kGlideGain_per_s * off_glide_m, 2 * on_glide, 0.0);
}

double LegPilot::vertical_target_mps(const Leg& leg) const {
    if (leg.kind == LegKind::final_leg) return glide_vertical_mps(leg);
    if (leg.kind == LegKind::land) {
        const double height = wheels_above_strip_m();
        return height > kFlareBelow_m ? glide_vertical_mps(leg) : -std::max(kTouchdownSink_mps, height / kFlareTime_s);
    }
    return std::clamp(kAltitudeGain_per_s * (leg.altitude_msl_m - state_.altitude_msl_m), -leg.climb_mps, leg.climb_mps);
}

bool LegPilot::ended(const Leg& leg) const {
    switch (leg.kind) {
        case LegKind::stand: return leg_time_s_ >= leg.duration_s;
        case LegKind::roll: return state_.airspeed_mps >= leg.speed_mps;
        case LegKind::hold:
            return std::abs(leg.altitude_msl_m - state_.altitude_msl_m) < kLevelledOff_m ||
                   (leg.duration_s > 0 && leg_time_s_ >= leg.duration_s);
        case LegKind::fly_to: {
            const double distance = earth::surface_distance_m({state_.latitude_rad, state_.longitude_rad, {}},
                                                              {leg.latitude_rad, leg.longitude_rad, {}});
            return distance <= leg.capture_m;
        }
        case LegKind::final_leg: return wheels_above_strip_m() <= leg.until_height_m;
        case LegKind::land: return stopped_;
    }
    return true;
}

}  // namespace tedavis::host_sim
