/// All state of earlier frames that influences the decisions of a frame. It is plain data: from a copy of it a frame can be
/// planned again, or planning can continue at another instant. A replay keeps copies as the state of the log's decision intervals
/// (flight/decision_interval.hpp).
///
/// Everything else that the planner keeps (chunks that have arrived, geometry that is built) only saves time.
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

/// The transition between the designs of two phases: one frame is planned with the earlier design and kept; the next one has the
/// new design.
struct DesignTransition {
    bool keeps = false;        ///< the planned frame is the one that is kept
    std::size_t to = 0;        ///< with it: the place of the next design
    base::Time at{0};          ///< with it
    bool is_first = true;      ///< no frame came before: the phase has its design at once
    bool fades_next = false;   ///< a fade from the picture of FramePlanner::keep_scene() begins with the next frame
    base::Time fade_began{0};  ///< with fade_lasts
    bool fade_lasts = false;
    terrain::View kept_view;  ///< of the kept picture

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

    /// Cuts: the next frame does not continue the last one, and has the design of its phase at once.
    void cut() {
        transition.cut();
        saliency.forget();
        clutter.forget();
    }
    /// Returns true where a later frame shows the planned one again, or what is measured of it: it must then be drawn even if it
    /// is not shown.
    [[nodiscard]] bool must_be_drawn() const { return transition.keeps || saliency.must_be_drawn() || clutter.must_be_drawn(); }
    /// Returns the time from which frames that must be drawn influence the frame at `time`.
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
