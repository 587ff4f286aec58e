#include "bus/state/axis_filter.hpp"

#include <cmath>

#include "render_core/earth/geodetic.hpp"

namespace tedavis::bus {
namespace {

constexpr base::Duration kSameInstant = base::Duration::milliseconds(1);
constexpr double kUnknownVelocity_mps = 150;
constexpr double kNoiseCorrelation_s = 0.1;  // how long an acceleration lasts, for its spectral density
constexpr double kGateSigmas = 8;
constexpr double kGateFloor_m = 20;

}  // namespace

bool AxisFilter::add(const AxisMeasurement& measurement) {
    bool refused = !std::isfinite(measurement.value) || !(measurement.sigma > 0) || !(measurement.metres_per_unit > 0);
    refused = refused || (count_ == kRing && measurement.at < ring_[0].at);
    for (std::size_t i = 0; i < count_ && !refused; ++i) {
        const base::Duration apart = measurement.at - ring_[i].at;
        refused =
            ring_[i].is_velocity == measurement.is_velocity && apart < kSameInstant && base::Duration{} - apart < kSameInstant;
    }
    if (refused) {
        ++dropped_;
        return false;
    }
    push_sorted(measurement);
    return true;
}

void AxisFilter::push_sorted(const AxisMeasurement& measurement) {
    if (count_ == kRing) {
        before_ring_ = after(before_ring_, ring_[0]);
        for (std::size_t i = 1; i < kRing; ++i) ring_[i - 1] = ring_[i];
        --count_;
    }
    std::size_t place = count_;
    for (; place > 0 && measurement.at < ring_[place - 1].at; --place) ring_[place] = ring_[place - 1];
    ring_[place] = measurement;
    ++count_;
    if (place + 1 == count_) {
        current_ = after(current_, measurement);
        return;
    }
    current_ = before_ring_;
    for (std::size_t i = 0; i < count_; ++i) current_ = after(current_, ring_[i]);
}

AxisFilter::State AxisFilter::started_at(const AxisMeasurement& measurement) const {
    State state;
    state.at = measurement.at;
    state.last_position = measurement.at;
    state.position = measurement.value;
    state.metres_per_unit = measurement.metres_per_unit;
    state.p00 = measurement.sigma * measurement.sigma;
    state.p11 = kUnknownVelocity_mps * kUnknownVelocity_mps;
    state.started = true;
    return state;
}

void AxisFilter::predict(State& state, base::Time to) const {
    const double dt = (to - state.at).to_seconds();
    const double q = model_.acceleration_mps2 * model_.acceleration_mps2 * kNoiseCorrelation_s;
    state.position += state.velocity * dt / state.metres_per_unit;
    state.p00 += dt * (2 * state.p01 + dt * state.p11) + q * dt * dt * dt / 3;
    state.p01 += dt * state.p11 + q * dt * dt / 2;
    state.p11 += q * dt;
    state.at = to;
}

double AxisFilter::difference_m(const State& state, const AxisMeasurement& measurement) const {
    const double units =
        model_.wraps ? earth::angle_difference(measurement.value, state.position) : measurement.value - state.position;
    return units * measurement.metres_per_unit;
}

AxisFilter::State AxisFilter::after(const State& before, const AxisMeasurement& measurement) const {
    const bool fresh = before.started && measurement.at - before.last_position <= model_.restart_gap;
    if (!fresh) return measurement.is_velocity ? before : started_at(measurement);
    State state = before;
    predict(state, measurement.at);
    if (measurement.is_velocity) {
        correct_by_velocity(state, measurement);
        return state;
    }
    const double innovation_m = difference_m(state, measurement);
    if (std::fabs(innovation_m) <= kGateFloor_m + kGateSigmas * std::sqrt(state.p00 + measurement.sigma * measurement.sigma)) {
        correct_by_position(state, measurement, innovation_m);
        return state;
    }
    if (before.outliers + 1 >= kOutliersToRestart) return started_at(measurement);
    state = before;
    ++state.outliers;
    return state;
}

void AxisFilter::correct_by_velocity(State& state, const AxisMeasurement& measurement) const {
    const double innovation_mps = measurement.value - state.velocity;
    const double gain_position = state.p01 / (state.p11 + measurement.sigma * measurement.sigma);
    const double gain_velocity = state.p11 / (state.p11 + measurement.sigma * measurement.sigma);
    state.p00 -= gain_position * state.p01;
    state.p01 *= 1 - gain_velocity;
    state.p11 *= 1 - gain_velocity;
    move(state, gain_position * innovation_mps, gain_velocity * innovation_mps);
}

void AxisFilter::correct_by_position(State& state, const AxisMeasurement& measurement, double innovation_m) const {
    const double gain_position = state.p00 / (state.p00 + measurement.sigma * measurement.sigma);
    const double gain_velocity = state.p01 / (state.p00 + measurement.sigma * measurement.sigma);
    state.p11 -= gain_velocity * state.p01;
    state.p01 *= 1 - gain_position;
    state.p00 *= 1 - gain_position;
    state.outliers = 0;
    state.last_position = measurement.at;
    state.metres_per_unit = measurement.metres_per_unit;
    move(state, gain_position * innovation_m, gain_velocity * innovation_m);
}

void AxisFilter::move(State& state, double by_m, double by_mps) const {
    state.position += by_m / state.metres_per_unit;
    state.velocity += by_mps;
    if (model_.wraps) state.position = earth::wrap_longitude(state.position);
}

AxisEstimate AxisFilter::estimate(base::Time now, base::Duration limit) const {
    AxisEstimate result;
    result.started = current_.started;
    if (!current_.started) return result;
    result.age = now - current_.last_position;
    const base::Time furthest = current_.last_position + limit;
    const base::Time earliest = current_.last_position - limit;
    const base::Time at = now < earliest ? earliest : now < furthest ? now : furthest;
    result.velocity_mps = current_.velocity;
    result.position = current_.position + current_.velocity * (at - current_.at).to_seconds() / current_.metres_per_unit;
    if (model_.wraps) result.position = earth::wrap_longitude(result.position);
    return result;
}

}  // namespace tedavis::bus
