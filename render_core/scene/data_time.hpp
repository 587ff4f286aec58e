/// The times at which the display evaluates data: whole minutes, so that all frames of a minute show the same values, which need
/// not be computed for each frame. Pure functions; any thread.
#pragma once

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

inline constexpr std::int64_t kDataStep_ns = 60'000'000'000;

/// Returns the start of the minute that contains `time_ns`, which may be negative.
[[nodiscard]] constexpr std::int64_t start_of_data_step(std::int64_t time_ns) noexcept {
    const std::int64_t into = time_ns % kDataStep_ns;
    return time_ns - (into < 0 ? into + kDataStep_ns : into);
}

/// Returns the time for which a layer is shown while the flight's time is not a date: the first of the layer's times; the time of
/// its data if it has no times; 0 if neither is stated.
[[nodiscard]] inline std::int64_t own_time_ns(const Layer& layer) noexcept {
    if (!layer.times_ns.empty()) return layer.times_ns[0];
    return layer.entry->data_time_ns == kNoTime ? 0 : layer.entry->data_time_ns;
}

}  // namespace tedavis::scene
