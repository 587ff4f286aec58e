#include "render_core/flight/flight_trail.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::flight {
namespace {

float valid_or_nan(const AircraftState& aircraft, Signal signal, base::Time now) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return static_cast<float>(aircraft.is_valid(signal, now) ? aircraft[signal].value_or(kNone) : kNone);
}

bool leaps(const FlownPoint& from, const FlownPoint& to) {
    const glm::dvec3 a = earth::to_ecef({from.latitude_rad, from.longitude_rad, {0}}),
                     b = earth::to_ecef({to.latitude_rad, to.longitude_rad, {0}});
    return glm::distance(a, b) > FlightTrail::kLeap_m + FlightTrail::kFastest_mps * (to.at - from.at).to_seconds();
}

}  // namespace

FlownPoint flown_point(const AircraftState& aircraft, base::Time now) noexcept {
    const OwnShipEstimate& own = aircraft.own_ship;
    FlownPoint point;
    point.latitude_rad = own.position.latitude_rad;
    point.longitude_rad = own.position.longitude_rad;
    point.at = now;
    point.height_m = static_cast<float>(own.position.height.m);
    point.is_geometric = own.height_is_geometric;
    point.position_accuracy_m = valid_or_nan(aircraft, Signal::horizontal_accuracy, now);
    point.height_accuracy_m = valid_or_nan(aircraft, Signal::vertical_accuracy, now);
    point.wind_speed_mps = valid_or_nan(aircraft, Signal::wind_speed, now);
    point.wind_from_rad = valid_or_nan(aircraft, Signal::wind_direction, now);
    if (!std::isfinite(point.wind_speed_mps + point.wind_from_rad))
        point.wind_speed_mps = point.wind_from_rad = std::numeric_limits<float>::quiet_NaN();
    point.temperature_k = valid_or_nan(aircraft, Signal::outside_temperature, now);
    return point;
}

void FlightTrail::step(const AircraftState& aircraft, base::Time now) {
    if (count_ > 0 && now < last_step_) clear();
    FlownPoint point = flown_point(aircraft, now);
    const bool has_place =
        aircraft.own_ship.state == base::SignalState::valid && std::isfinite(point.latitude_rad + point.longitude_rad);
    is_broken_ = is_broken_ || !has_place || now - last_step_ > kLongestGap;
    last_step_ = now;
    if (!has_place) return;
    if (count_ > 0 && leaps(last(), point)) clear();
    if (count_ > 0 && !is_broken_ && now - last().at < kSpacing) return;
    point.begins = !goes_on_to(point);
    add(point);
    is_broken_ = false;
}

bool FlightTrail::goes_on_to(const FlownPoint& next) const {
    return count_ > 0 && !is_broken_ && next.at >= last_step_ && next.at - last_step_ <= kLongestGap &&
           next.is_geometric == last().is_geometric && !leaps(last(), next);
}

void FlightTrail::clear() {
    passed_ += count_;
    first_ = count_ = 0;
}

void FlightTrail::add(const FlownPoint& point) {
    if (count_ == kMax) {
        first_ = (first_ + 1) % kMax;
        ++passed_;
        --count_;
    }
    points_[(first_ + count_++) % kMax] = point;
}

}  // namespace tedavis::flight
