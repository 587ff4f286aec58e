#include "render_core/perception/condition_watch.hpp"

namespace tedavis::perception {

void ConditionWatch::add(const ConditionMoment& moment) noexcept {
    if (verdict_.measured == 0 || limit_.is_worse(moment.value, verdict_.tightest.value)) verdict_.tightest = moment;
    ++verdict_.measured;
    if (limit_.is_kept_by(moment.value)) return close(moment.time_s);
    ++verdict_.beyond;
    if (!is_beyond_) began_ = worst_ = moment;
    is_beyond_ = true;
    if (limit_.is_worse(moment.value, worst_.value)) worst_ = moment;
}

/// What stands beyond the limit ends there.
void ConditionWatch::close(double time_s) noexcept {
    if (!is_beyond_) return;
    is_beyond_ = false;
    const double lasted_s = time_s - began_.time_s;
    if (lasted_s > verdict_.longest_s) verdict_.longest_s = lasted_s;
    if (!(lasted_s >= limit_.for_s)) return;
    verdict_.broken_s += lasted_s;
    count();
}

void ConditionWatch::count() noexcept {
    if (!verdict_.is_broken) verdict_.first = began_;
    if (!verdict_.is_broken || limit_.is_worse(worst_.value, verdict_.worst.value)) verdict_.worst = worst_;
    verdict_.is_broken = true;
}

}  // namespace tedavis::perception
