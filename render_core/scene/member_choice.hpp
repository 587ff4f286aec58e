/// Which members of an ensemble are shown where not all of them can be, and which one when they come one after the other.
/// Pure functions of the data's or the flight's time; any thread.
#pragma once

#include <cstdint>

namespace tedavis::scene {

/// The n-th of `shown` members out of `count`, evenly spaced from the first to the last; of one the middle one. Members are
/// numbered from 0; 1 <= shown <= count, n < shown.
[[nodiscard]] constexpr std::uint32_t spaced_member(std::uint32_t n, std::uint32_t shown, std::uint32_t count) noexcept {
    if (shown <= 1) return (count - 1) / 2;
    return (2 * n * (count - 1) + shown - 1) / (2 * (shown - 1));
}

/// One of `shown` after the other, each for `step_ns` > 0, by the steps since 1970: the same at the same time, from wherever it
/// is reached.
[[nodiscard]] std::uint32_t member_turn(std::int64_t time_ns, std::int64_t step_ns, std::uint32_t shown) noexcept;
/// When the next one's turn begins.
[[nodiscard]] std::int64_t next_turn_ns(std::int64_t time_ns, std::int64_t step_ns) noexcept;

}  // namespace tedavis::scene
