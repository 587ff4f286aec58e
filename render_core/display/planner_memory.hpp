/// All that decides in one frame because of the frames before it. Plain data: to plan a frame again, or one that lies elsewhere,
/// is to plan it from a copy.
///
/// What the planner keeps besides (chunks that have arrived, geometry that is built) only saves time.
#pragma once

#include <type_traits>

#include "render_core/display/clutter_control.hpp"
#include "render_core/display/element_labels.hpp"
#include "render_core/display/saliency_schedule.hpp"
#include "render_core/display/view_transition.hpp"
#include "render_core/effects/frame_budget.hpp"
#include "render_core/policy/priority_boost.hpp"

namespace tedavis::display {

/// From the design of one phase to another's: one frame is planned as it was, and kept; the next has the new one.
struct DesignTransition {
    bool keeps = false;        ///< the planned frame is the one that is kept
    std::size_t to = 0;        ///< with it: the place of the next design
    base::Time at{0};          ///< with it
    bool is_first = true;      ///< no frame came before: the phase has its design at once
    bool fades_next = false;   ///< from the next frame on, from what was kept by hand
    base::Time fade_began{0};  ///< with fade_lasts
    bool fade_lasts = false;
    terrain::View kept_view;  ///< of the scene as it was

    /// The next frame does not follow the last one.
    void cut() {
        keeps = false;
        is_first = true;
    }
};

struct PlannerMemory {
    std::uint64_t frames = 0;       ///< planned so far
    std::size_t shown = 0;          ///< the place of the design that is shown
    design::AspectWeights weights;  ///< of it, in the last frame
    bool shows_alert = false;       ///< terrain is ahead: the shown design has warning colours
    bool had_warning = true;        ///< of the last frame
    bool terrain_failed = false;    ///< the painter could not draw it
    DesignTransition transition;
    ViewTransition view;
    policy::PriorityBoost boost;
    LabelHistory labels;
    ClutterControl clutter;
    SaliencySchedule saliency;
    effects::FrameBudget budget;
};
static_assert(std::is_trivially_copyable_v<PlannerMemory>);

}  // namespace tedavis::display
