/// A task that stands for a range of work and expands by itself ("inserting a single task of ray traversal that expands
/// automatically", thesis 6.2.2.3): `first end range` becomes up to `pieces` calls of its next task, `n n+grain next`, and
/// then a call of itself for the rest. Earlier parts of the stream have precedence for room, so the rest waits until
/// they are done.
#pragma once

#include "render_core/raytrace/stream/task_network.hpp"

namespace tedavis::raytrace {

struct RangeSteps {
    std::uint32_t grain = 1;    ///< range of a call of the next task, 1 or more; the last one may be smaller
    std::uint32_t pieces = 64;  ///< 1 to 4096
};

inline constexpr std::uint32_t kRangeArguments = 2;  ///< first and end, of the range and of each piece

/// `steps` is borrowed; its number of pieces must not grow.
[[nodiscard]] Task make_range_task(base::FixedString<31> name, RangeSteps& steps, TaskId next);

}  // namespace tedavis::raytrace
