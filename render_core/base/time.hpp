/// Instants and durations on the source's time scale: signed 64-bit nanoseconds, which cover 292 years. The origin is the
/// source's own (for a log, the Unix epoch of its stamps). No clock is read.
#pragma once

#include <cstdint>
#include <type_traits>

namespace tedavis::base {

inline constexpr std::int64_t kSecondsPerDay = 86'400, kNanosecondsPerHour = 3'600'000'000'000;

struct Duration {
    std::int64_t ns = 0;

    [[nodiscard]] static constexpr Duration milliseconds(std::int64_t ms) { return {ms * 1'000'000}; }
    [[nodiscard]] static constexpr Duration seconds(std::int64_t s) { return {s * 1'000'000'000}; }
    /// Rounds to the nearest nanosecond; |s| must be below 9.2e9.
    [[nodiscard]] static constexpr Duration from_seconds(double s) {
        return {static_cast<std::int64_t>(s * 1e9 + (s < 0 ? -0.5 : 0.5))};
    }
    [[nodiscard]] constexpr double to_seconds() const { return static_cast<double>(ns) * 1e-9; }

    friend constexpr Duration operator+(Duration a, Duration b) { return {a.ns + b.ns}; }
    friend constexpr Duration operator-(Duration a, Duration b) { return {a.ns - b.ns}; }
    friend constexpr bool operator==(Duration a, Duration b) { return a.ns == b.ns; }
    friend constexpr bool operator!=(Duration a, Duration b) { return a.ns != b.ns; }
    friend constexpr bool operator<(Duration a, Duration b) { return a.ns < b.ns; }
    friend constexpr bool operator<=(Duration a, Duration b) { return a.ns <= b.ns; }
    friend constexpr bool operator>(Duration a, Duration b) { return a.ns > b.ns; }
    friend constexpr bool operator>=(Duration a, Duration b) { return a.ns >= b.ns; }
};

struct Time {
    std::int64_t ns = 0;

    friend constexpr Duration operator-(Time a, Time b) { return {a.ns - b.ns}; }
    friend constexpr Time operator+(Time a, Duration d) { return {a.ns + d.ns}; }
    friend constexpr Time operator-(Time a, Duration d) { return {a.ns - d.ns}; }
    friend constexpr bool operator==(Time a, Time b) { return a.ns == b.ns; }
    friend constexpr bool operator!=(Time a, Time b) { return a.ns != b.ns; }
    friend constexpr bool operator<(Time a, Time b) { return a.ns < b.ns; }
    friend constexpr bool operator<=(Time a, Time b) { return a.ns <= b.ns; }
    friend constexpr bool operator>(Time a, Time b) { return a.ns > b.ns; }
    friend constexpr bool operator>=(Time a, Time b) { return a.ns >= b.ns; }
};
static_assert(std::is_trivially_copyable_v<Time> && std::is_trivially_copyable_v<Duration>);

}  // namespace tedavis::base
