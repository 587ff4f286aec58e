#include "render_core/effects/renderer_choice.hpp"

#include <array>

namespace tedavis::effects {
namespace {

bool exceeds_deadline(const RendererCosts& costs) {
    return costs.deadline_ms > 0 && costs.frame_ms + costs.rays_ms > costs.deadline_ms;
}

/// Without regard to the deadline.
bool rays_are_preferred(const RendererCosts& costs, TriangleFit fit) {
    return costs.is_known && (fit == TriangleFit::is_short || costs.rays_ms <= costs.triangles_ms);
}

bool rays_are_better(const RendererCosts& costs, TriangleFit fit) {
    return fit == TriangleFit::none || (rays_are_preferred(costs, fit) && !exceeds_deadline(costs));
}

/// Whether the better renderer is better by so much that a change is worthwhile.
bool is_worthwhile(bool to_rays, const RendererCosts& costs, TriangleFit fit) {
    if (!costs.is_known || exceeds_deadline(costs) || (to_rays && fit != TriangleFit::exact_enough)) return true;
    const double from_ms = to_rays ? costs.triangles_ms : costs.rays_ms, to_ms = to_rays ? costs.rays_ms : costs.triangles_ms;
    return to_ms < RendererChoice::kLargestShare * from_ms;
}

}  // namespace

std::string_view to_string(RendererWhy why) noexcept {
    constexpr std::array<std::string_view, static_cast<std::size_t>(RendererWhy::count_)> kTexts{
        "no calibration states what rays cost", "it costs no more than the other renderer", "rays exceed the deadline",
        "a change is not worthwhile yet", "triangles are not exact enough"};
    return kTexts[static_cast<std::size_t>(why)];
}

void RendererChoice::begin(base::Time now) {
    if (has_time_ && now == time_)
        now_ = before_;
    else if (has_time_ && now < time_)
        now_ = State();
    before_ = now_;
    time_ = now;
    has_time_ = true;
}

void RendererChoice::rest(base::Time now) {
    begin(now);
    now_ = State();
}

RendererDecision RendererChoice::decide(base::Time now, std::size_t design, const RendererCosts& costs, TriangleFit fit) {
    begin(now);
    const bool better_by_rays = rays_are_better(costs, fit);
    const bool is_first = !now_.has_begun || now_.design != design;
    const bool other_is_better = better_by_rays != now_.by_rays && is_worthwhile(better_by_rays, costs, fit);
    if (other_is_better && !now_.other_is_better) now_.better_since = now;
    now_.other_is_better = other_is_better;
    const bool has_lasted = other_is_better && now - now_.better_since >= kDwell;
    if (is_first || has_lasted || fit == TriangleFit::none || !costs.is_known) {
        now_.by_rays = better_by_rays;
        now_.other_is_better = false;
    }
    now_.has_begun = true;
    now_.design = design;
    if (now_.by_rays != better_by_rays) return {now_.by_rays, RendererWhy::waits, costs};
    if (now_.by_rays && fit != TriangleFit::exact_enough) return {true, RendererWhy::triangles_short, costs};
    if (!costs.is_known) return {now_.by_rays, RendererWhy::costs_unknown, costs};
    const bool is_late = !now_.by_rays && rays_are_preferred(costs, fit);
    return {now_.by_rays, is_late ? RendererWhy::rays_too_late : RendererWhy::costs_no_more, costs};
}

}  // namespace tedavis::effects
