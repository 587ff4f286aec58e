#include "render_core/display/planner/saliency_schedule.hpp"

#include "render_core/flight/decision_interval.hpp"

namespace tedavis::display {

void SaliencySchedule::plan(bool runs, base::Time now) {
    runs_ = runs && is_asked_for_;
    now_ = now;
    measures_ = runs_ && (!keeps_ || !has_map_ || now == measured_ ||
                          flight::decision_interval_of(now) != flight::decision_interval_of(measured_));
}

base::Time SaliencySchedule::needed_since(base::Time time) const {
    if (!keeps_ || !is_asked_for_) return time;
    return base::Time{flight::decision_interval_of(time) * flight::kDecisionInterval.ns};
}

}  // namespace tedavis::display
