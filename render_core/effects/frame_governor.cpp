#include "render_core/effects/frame_governor.hpp"

#include <cmath>
#include <utility>

namespace tedavis::effects {
namespace {

constexpr double kMaxGrowth = 2;
constexpr std::int64_t kRelapseDwells = 8;  // a return that lasted less was none

constexpr std::array<std::string_view, static_cast<std::size_t>(GovernorWhy::count_)> kWhyTexts{
    "no deadline is set",
    "the cost is not known: calibrate this device",
    "the design's picture fits",
    "the time does not suffice",
    "a richer picture would not fit for long enough",
    "a richer picture fits",
    "too dear, but the last change was less than the dwell ago",
    "the cheapest picture is too dear",
};

/// The richest quality level whose cost is at most `limit_ms`; where there is none, the richest one of the cheapest.
std::size_t richest_within(const GovernorInput& input, double growth, double limit_ms) {
    std::size_t cheapest = 0;
    for (std::size_t quality_level = 0; quality_level < input.level_count; ++quality_level) {
        if (input.ms[quality_level] * growth <= limit_ms) return quality_level;
        if (input.ms[quality_level] < input.ms[cheapest]) cheapest = quality_level;
    }
    return cheapest;
}

}  // namespace

std::string_view to_string(GovernorWhy why) noexcept { return kWhyTexts[static_cast<std::size_t>(why)]; }

void CostTrend::take(base::Time now, double ms) {
    if (has_last_ && now - last_time_ < kStep) return;
    if (has_last_) {
        ms_per_s_[next_] = (ms - last_ms_) / (now - last_time_).to_seconds();
        next_ = static_cast<std::uint8_t>((next_ + 1) % kSteps);
    }
    has_last_ = true;
    last_time_ = now;
    last_ms_ = ms;
}

double CostTrend::growth(double ms, base::Duration ahead) const {
    if (!(ms > 0)) return 1;
    std::array<double, kSteps> sorted = ms_per_s_;
    for (std::size_t n = 1; n < kSteps; ++n)
        for (std::size_t at = n; at > 0 && sorted[at] < sorted[at - 1]; --at) std::swap(sorted[at], sorted[at - 1]);
    // The lower one of the two in the middle: half a row of steps is no trend yet.
    return std::fmin(std::fmax(1 + sorted[kSteps / 2 - 1] * ahead.to_seconds() / ms, 1), kMaxGrowth);
}

void FrameGovernor::begin(const GovernorInput& input) {
    const bool is_again = now_.has_begun && input.now == now_.time;
    if (is_again) {
        now_ = before_;
        if (now_.has_begun) return;
    }
    const bool is_anew = !now_.has_begun || input.now < now_.time;
    if (is_anew) now_ = State{};
    before_ = now_;
    if (!is_anew) return;
    // What came before the first frame is not known; it may be as rich as it fits.
    for (base::Time& since : now_.cheap_since) since = input.now;
    now_.has_begun = true;
}

bool FrameGovernor::may_change(base::Time now, const GovernorSettings& settings) const {
    return !now_.has_changed || now - now_.last_change >= settings.dwell;
}

void FrameGovernor::record_cheap_quality_levels(const GovernorInput& input, const GovernorSettings& settings, double growth) {
    for (std::size_t quality_level = 0; quality_level < input.level_count; ++quality_level)
        if (input.ms[quality_level] * growth > settings.relax_at * input.deadline_ms) now_.cheap_since[quality_level] = input.now;
}

GovernorDecision FrameGovernor::change(std::size_t quality_level, GovernorWhy why, base::Time now) {
    now_.quality_level = static_cast<std::uint8_t>(quality_level);
    now_.has_changed = true;
    now_.last_change = now;
    return {quality_level, true, why};
}

GovernorDecision FrameGovernor::tighten(const GovernorInput& input, const GovernorSettings& settings, double growth) {
    const bool still_fits = input.ms[now_.quality_level] <= input.deadline_ms;
    const std::size_t quality_level = richest_within(input, growth, settings.aim_at * input.deadline_ms);
    if (!(input.ms[quality_level] < input.ms[now_.quality_level]))
        return {now_.quality_level, false, still_fits ? GovernorWhy::cheaper_for_now : GovernorWhy::cheapest_is_too_dear};
    if (!may_change(input.now, settings)) return {now_.quality_level, false, GovernorWhy::waits};
    const bool is_relapse = now_.has_relaxed && (input.now - now_.last_relaxed).ns < kRelapseDwells * settings.dwell.ns;
    const std::uint32_t more = now_.patience * 2;
    now_.patience = !is_relapse ? 1 : more < settings.most_patience ? more : settings.most_patience;
    return change(quality_level,
                  input.ms[quality_level] > input.deadline_ms ? GovernorWhy::cheapest_is_too_dear : GovernorWhy::too_dear,
                  input.now);
}

GovernorDecision FrameGovernor::relax(const GovernorInput& input, const GovernorSettings& settings) {
    const std::int64_t wait_ns = settings.dwell.ns * now_.patience;
    for (std::size_t quality_level = 0; quality_level < now_.quality_level; ++quality_level) {
        const bool is_cheap =
            (input.now - now_.cheap_since[quality_level]).ns >= wait_ns && now_.cheap_since[quality_level] < input.now;
        if (!is_cheap || !may_change(input.now, settings)) continue;
        now_.has_relaxed = true;
        now_.last_relaxed = input.now;
        return change(quality_level, GovernorWhy::relaxed, input.now);
    }
    return {now_.quality_level, false, now_.quality_level == 0 ? GovernorWhy::fits : GovernorWhy::cheaper_for_now};
}

GovernorDecision FrameGovernor::decide(const GovernorInput& input, const GovernorSettings& settings) {
    begin(input);
    now_.time = input.now;
    now_.trend.take(input.now, input.ms[0]);
    const double growth = now_.trend.growth(input.ms[0], settings.dwell);
    record_cheap_quality_levels(input, settings, growth);
    const bool is_too_dear = input.ms[now_.quality_level] > settings.act_at * input.deadline_ms;
    return is_too_dear ? tighten(input, settings, growth) : relax(input, settings);
}

}  // namespace tedavis::effects
