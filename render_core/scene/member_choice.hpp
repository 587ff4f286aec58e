/// Chooses the members of an ensemble to show where not all can be shown, and the member at a time where they alternate. Pure
/// functions; any thread.
#pragma once

#include <cstdint>

namespace tedavis::scene {

/// Returns the n-th of `shown` members out of `count`, evenly spaced from the first to the last; the middle one if only one is
/// shown. Members are numbered from 0; 1 <= shown <= count, n < shown.
[[nodiscard]] constexpr std::uint32_t spaced_member(std::uint32_t n, std::uint32_t shown, std::uint32_t count) noexcept {
    if (shown <= 1) return (count - 1) / 2;
    return (2 * n * (count - 1) + shown - 1) / (2 * (shown - 1));
}

/// Returns which of `shown` alternating members is shown at a time, each for `step_ns` > 0, counted in steps since 1970, so
/// that the result depends only on the time.
[[nodiscard]] std::uint32_t member_turn(std::int64_t time_ns, std::int64_t step_ns, std::uint32_t shown) noexcept;
/// Returns the time at which the next member follows.
[[nodiscard]] std::int64_t next_turn_ns(std::int64_t time_ns, std::int64_t step_ns) noexcept;

}  // namespace tedavis::scene
