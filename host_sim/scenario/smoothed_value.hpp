/// A value that follows its target without jumps in itself or its rate: a critically damped second-order response with
/// limited rate.
#pragma once

#include <algorithm>

namespace tedavis::host_sim {

class SmoothedValue {
public:
    /// `bandwidth` in rad/s: the step response is within 5 % after about 4.7 / bandwidth seconds.
    SmoothedValue(double value, double bandwidth, double rate_limit)
        : value_(value), bandwidth_(bandwidth), rate_limit_(rate_limit) {}

    void step(double target, double dt_s) {
        const double acceleration = bandwidth_ * bandwidth_ * (target - value_) - 2 * bandwidth_ * rate_;
        rate_ = std::clamp(rate_ + acceleration * dt_s, -rate_limit_, rate_limit_);
        value_ += rate_ * dt_s;
    }
    [[nodiscard]] double value() const { return value_; }
    [[nodiscard]] double rate() const { return rate_; }

private:
    double value_, rate_ = 0, bandwidth_, rate_limit_;
};

}  // namespace tedavis::host_sim
