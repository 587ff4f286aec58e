#include "render_core/policy/speed_bands.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::policy {
namespace {

using design::AircraftSettings;
using design::FlapSetting;

/// A measured position is that of a setting within this distance; settings are farther apart.
constexpr double kFlapTolerance = 0.02;
static_assert(2 * kFlapTolerance < design::kMinFlapStep);

FlapsRange possible_flaps(const FlapsRange& stated) {
    const bool is_range = stated.least >= 0 && stated.least <= stated.most && stated.most <= 1;
    return is_range ? stated : FlapsRange{};
}

/// Of the first setting that is as far out as the flaps may be.
double limit_of_flaps_mps(const AircraftSettings& aircraft, double most) {
    for (const FlapSetting& setting : aircraft.flaps)
        if (setting.position >= most - kFlapTolerance) return setting.limit_mps;
    return aircraft.flaps.back().limit_mps;
}

/// Of the last setting that is not farther out than the flaps must be.
double stall_with_flaps_mps(const AircraftSettings& aircraft, double least) {
    double stall_mps = aircraft.flaps[0].stall_mps;
    for (const FlapSetting& setting : aircraft.flaps)
        if (setting.position <= least + kFlapTolerance) stall_mps = setting.stall_mps;
    return stall_mps;
}

void add_band(SpeedBands& shown, double low_mps, double high_mps, SpeedBandRole role) {
    if (low_mps < high_mps) static_cast<void>(shown.bands.try_push_back({low_mps, high_mps, role}));
}

/// No aircraft stalls on its wheels. `limit_mps`: no band of low speeds reaches beyond it.
void add_low_speeds(const AircraftSettings& aircraft, const SpeedConditions& conditions, double stall_mps, double limit_mps,
                    SpeedBands& shown) {
    if (conditions.is_on_ground) return;
    const double warned_mps = std::fmin(stall_mps, limit_mps);
    add_band(shown, 0, warned_mps, SpeedBandRole::low_warning);
    add_band(shown, warned_mps, std::fmin(stall_mps * aircraft.caution_factor, limit_mps), SpeedBandRole::low_caution);
}

void add_speeds_of_flight(const AircraftSettings& aircraft, double stall_mps, double limit_mps, SpeedBands& shown) {
    const double cautioned_mps = std::fmin(stall_mps * aircraft.caution_factor, limit_mps);
    const bool has_caution = aircraft.normal_limit_mps > 0;
    const double normal_mps = has_caution ? std::clamp(aircraft.normal_limit_mps, cautioned_mps, limit_mps) : limit_mps;
    add_band(shown, cautioned_mps, normal_mps, SpeedBandRole::normal);
    add_band(shown, normal_mps, limit_mps, SpeedBandRole::caution);
    add_band(shown, limit_mps, kEndOfBands_mps, SpeedBandRole::above_limit);
}

bool knows_limit(const AircraftSettings& aircraft, double pressure_altitude_m) {
    return std::isinf(aircraft.limit_up_to_m) || pressure_altitude_m <= aircraft.limit_up_to_m;
}

}  // namespace

SpeedBands speed_bands(const AircraftSettings& aircraft, const SpeedConditions& conditions) noexcept {
    SpeedBands shown;
    if (!aircraft.is_stated() || aircraft.flaps.empty()) return shown;
    shown.flags = aircraft.flags;
    shown.has_pole = aircraft.has_vmo;
    const FlapsRange flaps = possible_flaps(conditions.flaps);
    const double load_factor = std::fmin(std::fmax(conditions.load_factor, 1.0), kMaxLoadFactor);  // 1 where it is NaN
    const double stall_mps = stall_with_flaps_mps(aircraft, flaps.least) * std::sqrt(load_factor);
    if (!knows_limit(aircraft, conditions.pressure_altitude_m)) {  // the stall speed is shown at every altitude
        add_low_speeds(aircraft, conditions, stall_mps, kEndOfBands_mps, shown);
        return shown;
    }
    const double limit_mps = limit_of_flaps_mps(aircraft, flaps.most);
    add_low_speeds(aircraft, conditions, stall_mps, limit_mps, shown);
    add_speeds_of_flight(aircraft, stall_mps, limit_mps, shown);
    const FlapSetting& all_out = aircraft.flaps.back();
    if (aircraft.flaps.size() > 1) add_band(shown, all_out.stall_mps, all_out.limit_mps, SpeedBandRole::flaps_range);
    return shown;
}

}  // namespace tedavis::policy
