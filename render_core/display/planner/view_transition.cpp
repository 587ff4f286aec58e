#include "render_core/display/planner/view_transition.hpp"

#include <cmath>

namespace tedavis::display {

void ViewTransition::step(design::ViewMode wanted, double whole_way_s, base::Time now) noexcept {
    const base::Duration passed = now - last_;
    const bool turns = wanted != wanted_, stands_still = passed.ns == 0;
    const bool cuts = turns && (wanted == design::ViewMode::orthographic || wanted_ == design::ViewMode::orthographic);
    const bool jumps = !has_begun_ || passed.ns < 0 || passed.to_seconds() > whole_way_s || (turns && stands_still) || cuts;
    if (turns) {
        from_ = last_;
        from_share_ = map_share_;
    }
    has_begun_ = true;
    wanted_ = wanted;
    last_ = now;
    if (jumps) return arrive();
    const double come = (now - from_).to_seconds() / whole_way_s;
    map_share_ = goal() > 0 ? std::fmin(from_share_ + come, 1.0) : std::fmax(from_share_ - come, 0.0);
}

void ViewTransition::arrive() noexcept {
    map_share_ = from_share_ = goal();
    from_ = last_;
}

}  // namespace tedavis::display
