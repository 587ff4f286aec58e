/// Plans the foci of a frame: where each is, and what the record says of it.
///
/// Pure except for queries of the ground. Bounded. Thread  the ground's.
#pragma once

#include "render_core/display/planner/element_planner.hpp"
#include "render_core/display/planner/frame_record.hpp"
#include "render_core/draw/data/focus_values.hpp"

namespace tedavis::display {

struct FociPlan {
    draw::FrameFoci foci;
    std::array<draw::FocusState, scene::kMaxFoci> states{};
    std::array<double, scene::kMaxFoci> heights_m{};  ///< of the focused objects above the ellipsoid; NaN: not known
};

/// `foci` must stay valid. The result is empty where there are none.
[[nodiscard]] FociPlan plan_foci(const design::FocusList& foci, const draw::FocusFrame& frame);

/// Writes the foci into the frame's record; to be called after ElementPlanner::plan_signs().
void record_foci(const FociPlan& plan, const ElementPlanner& elements, const ElementFrame& frame, FrameStatement& record);

}  // namespace tedavis::display
