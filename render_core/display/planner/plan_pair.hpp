/// A planned frame and the memory it was planned with. A display has one pair for the frame that is shown, its planner another
/// one for the intervals that are decided between frames.
///
/// Memory    of the arenas given to start(), in which both stay.
/// Failure   start() names the budget line that is too small for two pairs.
#pragma once

#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/display/planner/planned_frame.hpp"
#include "render_core/display/planner/planner_memory.hpp"

namespace tedavis::display {

struct PlanPair {
    /// `frames`, `memories`: of the budget lines planned_frames and planner_memory.
    [[nodiscard]] base::Error start(base::Arena& frames, base::Arena& memories);

    PlannedFrame* frame = nullptr;  ///< null before start()
    PlannerMemory* memory = nullptr;
};

}  // namespace tedavis::display
