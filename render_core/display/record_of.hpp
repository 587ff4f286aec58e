/// The record of a frame, from what was planned and what was drawn. Pure; any thread.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/display/frame_painter.hpp"
#include "render_core/display/planner/planned_frame.hpp"

namespace tedavis::display {

/// `reports`: of the frame's elements. `table`: the device's budget.
[[nodiscard]] FrameRecord record_of(const PlannedFrame& plan, const DrawnFrame& drawn, const ElementReports& reports,
                                    const base::BudgetTable& table);

}  // namespace tedavis::display
