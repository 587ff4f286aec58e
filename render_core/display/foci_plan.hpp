/// The foci of a frame: where each is, what its record says.
///
/// Pure but for the ground, which is asked. Bounded. Thread  the ground's.
#pragma once

#include "render_core/display/element_planner.hpp"
#include "render_core/display/frame_record.hpp"
#include "render_core/draw/data/focus_values.hpp"

namespace tedavis::display {

struct FociPlan {
    draw::FrameFoci foci;
    std::array<draw::FocusState, scene::kMaxFoci> states{};
    std::array<double, scene::kMaxFoci> heights_m{};  ///< of the things themselves over the ellipsoid; NaN: not known
};

/// `foci` must stay. Empty where there are none.
[[nodiscard]] FociPlan plan_foci(const design::FocusList& foci, const draw::FocusFrame& frame);

/// What a frame's record says of its foci; after ElementPlanner::plan_signs().
void record_foci(const FociPlan& plan, const ElementPlanner& elements, const ElementFrame& frame, FrameStatement& record);

}  // namespace tedavis::display
