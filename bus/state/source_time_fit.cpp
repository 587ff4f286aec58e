#include "bus/state/source_time_fit.hpp"

#include <cmath>

namespace tedavis::bus {
namespace {

constexpr double kMinPeriod_ns = 0.5e6;
constexpr double kMaxPeriod_ns = 10e9;
constexpr double kLockedScatter = 0.35;  // standard deviation in periods
constexpr double kGate = 0.9;            // off the line by more periods than this: not used
constexpr double kMaxCorrection_ns = 0.5e9;
constexpr std::uint8_t kMissesToRestart = 16;
constexpr std::uint16_t kVarianceMemory = 64;

}  // namespace

bool SourceTimeFit::locked() const {
    return messages_ >= kMessagesToLock && variance_ns2_ < kLockedScatter * kLockedScatter * period_ns_ * period_ns_;
}

void SourceTimeFit::start(std::uint8_t code, base::Time received) {
    reset();
    line_ = received;
    code_ = code;
    messages_ = 1;
}

void SourceTimeFit::advance(double by_ns) {
    const double total = fraction_ns_ + by_ns;
    const double whole = std::nearbyint(total);
    line_.ns += static_cast<std::int64_t>(whole);
    fraction_ns_ = total - whole;
}

SourceTime SourceTimeFit::add(std::uint8_t code, base::Time received) {
    const auto steps = static_cast<double>(static_cast<std::uint8_t>(code - code_));
    if (messages_ == 0 || !follow_line(code, steps, received)) {
        start(code, received);
        return {received, false};
    }
    const double correction_ns = static_cast<double>((line_ - received).ns);
    if (!locked() || std::fabs(correction_ns) > kMaxCorrection_ns) return {received, false};
    return {line_, true};
}

/// False when these stamps lie on no line, and the fit has to start again.
bool SourceTimeFit::follow_line(std::uint8_t code, double steps, base::Time received) {
    const double gap_ns = static_cast<double>((received - line_).ns) - fraction_ns_;
    if (steps < 1 || std::fabs(gap_ns) > 256 * kMaxPeriod_ns) return false;
    if (messages_ == 1) period_ns_ = gap_ns / steps;
    if (!(period_ns_ >= kMinPeriod_ns && period_ns_ <= kMaxPeriod_ns)) return false;
    const bool was_locked = locked();
    if (messages_ >= kMessagesToLock && !was_locked) return false;
    const double residual_ns = gap_ns - steps * period_ns_;
    const bool used = !was_locked || std::fabs(residual_ns) <= kGate * period_ns_;
    misses_ = used ? std::uint8_t{0} : static_cast<std::uint8_t>(misses_ + 1);
    if (misses_ >= kMissesToRestart) return false;
    code_ = code;
    advance(steps * period_ns_);
    if (used) correct_line(residual_ns, steps);
    return true;
}

void SourceTimeFit::correct_line(double residual_ns, double steps) {
    messages_ = messages_ < kMaxMemory ? static_cast<std::uint16_t>(messages_ + 1) : kMaxMemory;
    const double n = messages_;
    advance(residual_ns * 2.0 * (2.0 * n - 1.0) / (n * (n + 1.0)));
    period_ns_ += residual_ns / steps * 6.0 / (n * (n + 1.0));
    const double memory = messages_ < kVarianceMemory ? n : kVarianceMemory;
    variance_ns2_ += (residual_ns * residual_ns - variance_ns2_) / memory;
}

}  // namespace tedavis::bus
