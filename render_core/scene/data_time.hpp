/// The times at which data are evaluated: whole minutes, so that the same time shows the same data and they are not computed
/// again in every frame. Pure functions; any thread.
#pragma once

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

inline constexpr std::int64_t kDataStep_ns = 60'000'000'000;

/// Returns the start of the step that contains a time.
[[nodiscard]] constexpr std::int64_t start_of_data_step(std::int64_t time_ns) noexcept {
    const std::int64_t into = time_ns % kDataStep_ns;
    return time_ns - (into < 0 ? into + kDataStep_ns : into);
}

/// Returns the time at which a layer's data begin, for a source without a date: their first time, else the layer's time, else
/// 0.
[[nodiscard]] inline std::int64_t own_time_ns(const Layer& layer) noexcept {
    if (!layer.times_ns.empty()) return layer.times_ns[0];
    return layer.entry->data_time_ns == kNoTime ? 0 : layer.entry->data_time_ns;
}

}  // namespace tedavis::scene
