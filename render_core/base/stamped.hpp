/// A value with its time stamp and quality. Readers get the value only together with its state at a given time.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::base {

/// The state of a value at a given instant, which decides how it may be shown.
enum class SignalState : std::uint8_t {
    missing,  ///< never received
    valid,
    stale,    ///< older than the stale limit: may be shown only with its flag
    lost,     ///< older than the lost limit: must not be shown
    invalid,  ///< the sender states invalid, or the value is out of range or not a number
};
[[nodiscard]] const char* to_string(SignalState state) noexcept;

/// Ages at which a value becomes stale and lost; 0 < stale <= lost.
struct FreshnessLimits {
    Duration stale = Duration::milliseconds(500);
    Duration lost = Duration::seconds(1);
};

enum class Quality : std::uint8_t { good, degraded, bad };

template <class T>
class Stamped {
public:
    Stamped() = default;
    Stamped(T value, Time source_time, Quality quality = Quality::good)
        : value_(value), time_(source_time), quality_(quality), received_(true) {}

    /// A stamp that lies in the future by up to the stale limit counts as fresh, because source times are estimated; a later
    /// stamp cannot be trusted, and the value is lost.
    [[nodiscard]] SignalState state(Time now, const FreshnessLimits& limits) const {
        if (!received_) return SignalState::missing;
        if (quality_ == Quality::bad) return SignalState::invalid;
        const Duration age = now - time_;
        if (age > limits.lost || Duration{} - age > limits.stale) return SignalState::lost;
        return age > limits.stale ? SignalState::stale : SignalState::valid;
    }
    /// Returns the value, or `fallback` when none was ever received. Check state() first.
    [[nodiscard]] T value_or(T fallback) const { return received_ ? value_ : fallback; }
    [[nodiscard]] Time source_time() const { return time_; }
    [[nodiscard]] Quality quality() const { return quality_; }
    [[nodiscard]] bool received() const { return received_; }

private:
    T value_{};
    Time time_{};
    Quality quality_ = Quality::good;
    bool received_ = false;
};
static_assert(std::is_trivially_copyable_v<Stamped<double>>);

}  // namespace tedavis::base
