#include "bus/state/own_ship_filter.hpp"

#include <cmath>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::bus {
namespace {

constexpr double kMinSigma_m = 0.05;
constexpr double kMaxSigma_m = 500;
constexpr double kMinCosine = 1e-6;  // keeps metres per longitude positive at the poles

double sigma_of(double accuracy_m) {
    const double sigma = accuracy_m / 2;
    return sigma < kMinSigma_m ? kMinSigma_m : sigma > kMaxSigma_m ? kMaxSigma_m : sigma;
}

AxisModel model_of(const OwnShipSettings& settings, bool wraps) {
    return {settings.acceleration_mps2, settings.lost_after, wraps};
}

/// How far a state is from being usable; the worse of two axes counts.
base::SignalState state_of(const AxisEstimate& axis, const OwnShipSettings& settings) {
    if (!axis.started) return base::SignalState::missing;
    if (axis.age > settings.lost_after || base::Duration{} - axis.age > settings.lost_after) return base::SignalState::lost;
    return axis.age > settings.extrapolation_limit ? base::SignalState::stale : base::SignalState::valid;
}

base::SignalState worse(base::SignalState a, base::SignalState b) {
    constexpr int kRank[] = {4, 0, 1, 3, 2};  // missing, valid, stale, lost, invalid
    return kRank[static_cast<std::size_t>(a)] >= kRank[static_cast<std::size_t>(b)] ? a : b;
}

}  // namespace

OwnShipFilter::OwnShipFilter(const OwnShipSettings& settings)
    : settings_(settings),
      latitude_(model_of(settings, false)),
      longitude_(model_of(settings, true)),
      position_sigma_m_(settings.position_noise_m),
      height_sigma_m_(settings.height_noise_m) {
    for (AxisFilter& height : heights_) height = AxisFilter(model_of(settings, false));
}

double OwnShipFilter::latitude() const { return latitude_.estimate({}, {}).position; }
double OwnShipFilter::metres_per_latitude() const { return earth::meridian_radius_m(latitude()); }
double OwnShipFilter::metres_per_longitude() const {
    const double cosine = std::cos(latitude());
    return earth::prime_vertical_radius_m(latitude()) * (cosine > kMinCosine ? cosine : kMinCosine);
}

void OwnShipFilter::add_latitude(double latitude_rad, base::Time at) {
    const double radius_m = earth::meridian_radius_m(latitude_rad);
    if (latitude_.add({at, latitude_rad, position_sigma_m_, radius_m, false})) position_invalid_ = false;
}

void OwnShipFilter::add_longitude(double longitude_rad, base::Time at) {
    if (longitude_.add({at, longitude_rad, position_sigma_m_, metres_per_longitude(), false})) position_invalid_ = false;
}

void OwnShipFilter::add_height(HeightSource source, double height_m, base::Time at) {
    const auto index = static_cast<std::size_t>(source);
    if (heights_[index].add({at, height_m, height_sigma_m_, 1, false})) height_invalid_[index] = false;
}

void OwnShipFilter::add_ground_speed(double speed_mps, base::Time at) {
    ground_speed_ = {speed_mps, at, true};
    pair_velocity();
}

void OwnShipFilter::add_true_track(double track_rad, base::Time at) {
    true_track_ = {track_rad, at, true};
    pair_velocity();
}

void OwnShipFilter::pair_velocity() {
    const base::Duration apart = ground_speed_.at - true_track_.at;
    const bool near = apart <= kPairing && base::Duration{} - apart <= kPairing;
    if (!near || !ground_speed_.unused || !true_track_.unused) return;
    ground_speed_.unused = false;
    true_track_.unused = false;
    // The track's instant: in a turn the direction changes faster than the speed.
    add_north_velocity(ground_speed_.value * std::cos(true_track_.value), true_track_.at);
    add_east_velocity(ground_speed_.value * std::sin(true_track_.value), true_track_.at);
}

void OwnShipFilter::add_velocity(AxisFilter& axis, double velocity_mps, base::Time at) {
    (void)axis.add({at, velocity_mps, settings_.velocity_noise_mps, 1, true});
}

void OwnShipFilter::add_north_velocity(double velocity_mps, base::Time at) { add_velocity(latitude_, velocity_mps, at); }
void OwnShipFilter::add_east_velocity(double velocity_mps, base::Time at) { add_velocity(longitude_, velocity_mps, at); }
void OwnShipFilter::add_up_velocity(double velocity_mps, base::Time at) {
    for (AxisFilter& height : heights_) add_velocity(height, velocity_mps, at);
}

void OwnShipFilter::set_horizontal_accuracy(double accuracy_m) { position_sigma_m_ = sigma_of(accuracy_m); }
void OwnShipFilter::set_vertical_accuracy(double accuracy_m) { height_sigma_m_ = sigma_of(accuracy_m); }

/// The first source that is valid; else the best of the others.
std::size_t OwnShipFilter::usable_height(base::Time now) const {
    std::size_t best = 0;
    base::SignalState best_state = base::SignalState::missing;
    for (std::size_t i = kHeightSources; i-- > 0;) {
        if (height_invalid_[i]) continue;
        const base::SignalState own = state_of(heights_[i].estimate(now, settings_.extrapolation_limit), settings_);
        if (worse(best_state, own) == best_state) {
            best = i;
            best_state = own;
        }
    }
    return best;
}

flight::OwnShipEstimate OwnShipFilter::estimate(base::Time now) const {
    const base::Duration limit = settings_.extrapolation_limit;
    const AxisEstimate north = latitude_.estimate(now, limit);
    const AxisEstimate east = longitude_.estimate(now, limit);
    const std::size_t source = usable_height(now);
    const AxisEstimate up = heights_[source].estimate(now, limit);
    flight::OwnShipEstimate result;
    result.position = {north.position, east.position, {up.position}};
    result.velocity_north_mps = north.velocity_mps;
    result.velocity_east_mps = east.velocity_mps;
    result.velocity_up_mps = up.velocity_mps;
    result.at = now;
    result.state = worse(worse(state_of(north, settings_), state_of(east, settings_)), state_of(up, settings_));
    if (position_invalid_ || height_invalid_[source]) result.state = base::SignalState::invalid;
    result.height_is_on_qnh = source == static_cast<std::size_t>(HeightSource::baro) && up.started;
    result.height_is_geometric = source == static_cast<std::size_t>(HeightSource::ellipsoid) && up.started;
    return result;
}

}  // namespace tedavis::bus
