/// The times at which data are shown: whole minutes, so that the same moment shows the same picture and no frame makes them anew.
/// Pure functions; any thread.
#pragma once

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

inline constexpr std::int64_t kDataStep_ns = 60'000'000'000;

/// The start of the step that holds a time.
[[nodiscard]] constexpr std::int64_t start_of_data_step(std::int64_t time_ns) noexcept {
    const std::int64_t into = time_ns % kDataStep_ns;
    return time_ns - (into < 0 ? into + kDataStep_ns : into);
}

/// Where the data of a layer begin: their first time, else what the layer states, else 0. For a source without a date.
[[nodiscard]] inline std::int64_t own_time_ns(const Layer& layer) noexcept {
    if (!layer.times_ns.empty()) return layer.times_ns[0];
    return layer.entry->data_time_ns == kNoTime ? 0 : layer.entry->data_time_ns;
}

}  // namespace tedavis::scene
