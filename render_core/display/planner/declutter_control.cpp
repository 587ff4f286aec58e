#include "render_core/display/planner/declutter_control.hpp"

#include <algorithm>

#include "render_core/flight/decision_interval.hpp"

namespace tedavis::display {
namespace {

constexpr double kHaste = 2;   // most data are reduced near the least detail
constexpr double kSpared = 1;  // budgets of excess, of all regions together, for which detail elsewhere is not given up

}  // namespace

void DeclutterControl::start(effects::Lane lane, draw::DrawnDesigns designs) {
    constexpr std::int64_t kIntervals[] = {2, 1};
    interval_.ns = flight::kDecisionInterval.ns * kIntervals[lane == effects::Lane::es2 ? 0 : 1];
    for (const draw::DrawnDesign& drawn : designs) {
        shows_ = shows_ || drawn.design->effects.clutter != design::ClutterView::none;
        has_budget_ = has_budget_ || drawn.design->priority.held_clutter() < 1;
    }
}

bool DeclutterControl::can_show(const design::DesignSettings& design) const {
    const bool is_viewed = design.effects.clutter != design::ClutterView::none;
    return (has_budget_ || design.priority.held_clutter() >= 1) && (shows_ || !is_viewed);
}

std::int64_t DeclutterControl::interval_of(base::Time now) const {
    const std::int64_t interval = now.ns / interval_.ns;
    return now.ns % interval_.ns < 0 ? interval - 1 : interval;
}

DeclutterControl::Held& DeclutterControl::place_of(std::int64_t interval) {
    constexpr auto kPlaces = static_cast<std::int64_t>(kMaxHeld + 1);
    return held_[static_cast<std::size_t>((interval % kPlaces + kPlaces) % kPlaces)];
}

void DeclutterControl::follow(base::Time now, const terrain::View& view) {
    if (now == last_now_ && (last_eye_ != view.eye || last_forward_ != view.forward)) forget();
    last_now_ = now;
    last_eye_ = view.eye;
    last_forward_ = view.forward;
}

void DeclutterControl::forget() {
    for (Held& held : held_) held.is_known = false;
}

/// Whether a measurement is of an earlier interval within the last kHeld.
bool DeclutterControl::counts(const Held& held, base::Time now, std::size_t design) const {
    const std::int64_t age = interval_of(now) - held.interval;
    return held.is_known && held.design == design && age >= 1 && age * interval_.ns <= kHeld.ns;
}

bool DeclutterControl::is_own(const Held& held, base::Time now, std::size_t design) const {
    return held.is_known && held.design == design && held.interval == interval_of(now);
}

bool DeclutterControl::follows(base::Time now, std::size_t design) const {
    for (const Held& held : held_)
        if (counts(held, now, design)) return true;
    return false;
}

DeclutterControl::Deciding DeclutterControl::deciding(base::Time now, std::size_t design) const {
    Deciding all;
    const bool has_before = follows(now, design);
    for (const Held& held : held_)
        if (has_before ? counts(held, now, design) : is_own(held, now, design)) (void)all.try_push_back(&held);
    return all;
}

scene::DetailRegions DeclutterControl::regions(base::Time now, std::size_t design) const {
    scene::DetailRegions left;
    for (const Held* held : deciding(now, design))
        for (std::size_t n = 0; n < left.factor.size(); ++n) left.factor[n] = std::min(left.factor[n], held->left.factor[n]);
    return left;
}

DeclutterControl::Measured DeclutterControl::measured(base::Time now, std::size_t design) const {
    const Held* newest = nullptr;
    for (const Held* held : deciding(now, design))
        if (newest == nullptr || held->interval > newest->interval) newest = held;
    return newest == nullptr ? Measured() : newest->measured;
}

void DeclutterControl::plan(bool runs, base::Time now, std::size_t design, double budget) {
    now_ = now;
    design_ = design;
    budget_ = budget;
    ask_for(Step::none, {});
    if (!runs || budget >= 1 || !has_budget_) return;
    if (!is_own(place_of(interval_of(now)), now, design)) ask_for(Step::whole, {});
}

base::Time DeclutterControl::needed_since(base::Time time) const {
    if (!has_budget_) return time;
    return base::Time{interval_of(time) * interval_.ns - kHeld.ns};
}

void DeclutterControl::take(const effects::ClutterMap& map) {
    Held& held = place_of(interval_of(now_));
    if (step_ == Step::whole) {
        held = Held();
        held.is_known = true;
        held.interval = interval_of(now_);
        held.design = design_;
        held.measured.clutter.whole = map;
        ask_for(effects::is_beyond(map, budget_) ? Step::least : Step::none, effects::least_detail());
    } else if (step_ == Step::least) {
        held.measured.clutter.least = map;
        tries_ = 0;
        const scene::DetailRegions tried = effects::detail_within(held.measured.clutter, budget_);
        ask_for(tried.is_whole() ? Step::none : Step::tried, tried);
    } else {
        take_try(held, map);
    }
}

/// Keeps the best try so far; of equal ones the first, which keeps more detail. Where none of them is good enough, all regions
/// keep the least detail.
void DeclutterControl::take_try(Held& held, const effects::ClutterMap& reached) {
    const effects::ClutterMeasures& clutter = held.measured.clutter;
    const double excess = effects::excess(reached, clutter, budget_);
    if (tries_ == 0 || excess < effects::excess(held.measured.reached, clutter, budget_)) {
        held.measured.reached = reached;
        held.left = step_regions_;
    }
    const bool is_over = ++tries_ == kMaxTries || excess <= 0;
    if (is_over && effects::excess(held.measured.reached, clutter, budget_) > kSpared * budget_) {
        held.measured.reached = clutter.least;
        held.left = effects::least_detail();
    }
    const bool is_last = tries_ + 1 == kMaxTries;
    const scene::DetailRegions less = is_last ? effects::least_round(step_regions_, reached, clutter, budget_)
                                              : effects::less_detail(step_regions_, reached, clutter, budget_, kHaste);
    ask_for(is_over ? Step::none : Step::tried, less);
}

void DeclutterControl::ask_for(Step step, const scene::DetailRegions& regions) {
    step_ = step;
    step_regions_ = regions;
}

}  // namespace tedavis::display
