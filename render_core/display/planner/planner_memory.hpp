/// All that decides in one frame because of the frames before it. Plain data: to plan a frame again, or one that lies elsewhere,
/// is to plan it from a copy. A replay keeps copies as the state of the log's decision intervals (flight/decision_interval.hpp).
///
/// What the planner keeps besides (chunks that have arrived, geometry that is built) only saves time.
#pragma once

#include <algorithm>
#include <type_traits>

#include "render_core/display/planner/declutter_control.hpp"
#include "render_core/display/planner/element_labels.hpp"
#include "render_core/display/planner/saliency_schedule.hpp"
#include "render_core/display/planner/view_transition.hpp"
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
    bool had_warning = true;        ///< of the last frame
    bool terrain_failed = false;    ///< the painter could not draw it
    DesignTransition transition;
    ViewTransition view;
    policy::PriorityBoost boost;
    LabelHistory labels;
    DeclutterControl clutter;
    SaliencySchedule saliency;
    effects::FrameBudget budget;

    /// The next frame does not follow the last one: the phase that it is told has its design at once.
    void cut() {
        transition.cut();
        saliency.forget();
        clutter.forget();
    }
    /// True where a later frame shows the planned one again, or what is measured of it: it must be drawn, even if nobody looks at
    /// it.
    [[nodiscard]] bool must_be_drawn() const { return transition.keeps || saliency.must_be_drawn() || clutter.must_be_drawn(); }
    /// From when on, besides, frames that must be drawn are a part of the one at `time`.
    [[nodiscard]] base::Time needed_since(base::Time time) const {
        return std::min(saliency.needed_since(time), clutter.needed_since(time));
    }
    /// Takes over the labels and the priorities that FramePlanner::decide_interval() has left in `decided`. What the last frame
    /// showed of the labels remains this memory's.
    void take_interval(const PlannerMemory& decided) {
        boost = decided.boost;
        labels.take_interval(decided.labels);
    }
};
static_assert(std::is_trivially_copyable_v<PlannerMemory>);

}  // namespace tedavis::display
