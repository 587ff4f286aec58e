/// A value that carries its age and its quality; there is no way to the value that does not ask for both.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::base {

/// What a reader may do with a value at a given instant.
enum class SignalState : std::uint8_t {
    missing,  ///< never received
    valid,
    stale,    ///< older than the stale limit: may be shown only with its flag
    lost,     ///< older than the lost limit: must not be shown
    invalid,  ///< the sender says invalid, or the value is out of range or not a number
};
[[nodiscard]] const char* to_string(SignalState state) noexcept;

/// Ages at which a value turns stale and lost; 0 < stale <= lost.
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

    /// A value from the future by up to the stale limit counts as fresh (source clocks are fitted, not exact); beyond
    /// that the stamp cannot be trusted and the value is lost.
    [[nodiscard]] SignalState state(Time now, const FreshnessLimits& limits) const {
        if (!received_) return SignalState::missing;
        if (quality_ == Quality::bad) return SignalState::invalid;
        const Duration age = now - time_;
        if (age > limits.lost || Duration{} - age > limits.stale) return SignalState::lost;
        return age > limits.stale ? SignalState::stale : SignalState::valid;
    }
    /// The value for a reader that has looked at `state` first; `fallback` when nothing was ever received.
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
