/// A task that stands for a range of work and expands by itself ("inserting a single task of ray traversal that expands
/// automatically", thesis 6.2.2.3): `first end range` becomes calls of its next, `n n+grain next`, up to `pieces` of them, and
/// behind them a call of itself for the rest. As what lies ahead in the stream has room first, the rest waits until its turn
/// comes.
#pragma once

#include "render_core/raytrace/stream/task_network.hpp"

namespace tedavis::raytrace {

struct RangeSteps {
    std::uint32_t grain = 1;    ///< of a call of the next, 1 or more; the last may have less
    std::uint32_t pieces = 64;  ///< 1 to 4096
};

inline constexpr std::uint32_t kRangeArguments = 2;  ///< first and end, of the range and of each piece

/// `steps` is borrowed and must not change to more pieces.
[[nodiscard]] Task make_range_task(base::FixedString<31> name, RangeSteps& steps, TaskId next);

}  // namespace tedavis::raytrace
