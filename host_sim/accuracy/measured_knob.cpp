#include "host_sim/accuracy/measured_knob.hpp"

#include <cmath>
#include <cstdio>

#include "render_core/effects/paired_cost.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kReferenceShare = 10;  // an error must be so many times the reference's own to be one of the level

/// More accurate, in the mean or at the worst place, and no slower, whatever the noise hides; or as accurate and certainly
/// quicker.
bool dominates(const MeasuredKnob& knob, const MeasuredLevel& a, const MeasuredLevel& b) {
    if (a.error.mean > b.error.mean || a.error.max > b.error.max) return false;
    if (a.error.mean < b.error.mean || a.error.max < b.error.max) return a.ms.median <= b.ms.median;
    return is_quicker(knob, a, b);
}

std::string expected_text(const std::string& what, const ExpectedLaw& law) {
    char text[96];
    std::snprintf(text, sizeof text, " ~ amount^%.2f, +- %.2f (", law.exponent, law.tolerance);
    return what + text + law.source.text() + ")";
}

bool agrees(const FittedLaw& found, const ExpectedLaw& law) {
    return found.holds && std::abs(found.exponent - law.exponent) <= law.tolerance;
}

void judge_work(const KnobFacts& facts, MeasuredKnob& knob) {
    MeasuredWork& work = *knob.work;
    std::vector<LawPoint> counts;
    std::vector<effects::CostPoint> costs;
    for (std::size_t n = 0; n < knob.levels.size(); ++n) {
        counts.push_back({knob.levels[n].amount, work.counts[n]});
        costs.push_back({work.counts[n], knob.levels[n].ms.median / static_cast<double>(knob.samples)});
    }
    work.law = fit_law(counts);
    work.law_expected = expected_text(work.thing, facts.work->law);
    work.law_agrees = agrees(work.law, facts.work->law);
    const effects::CostSlope slope = effects::cost_slope({costs.data(), costs.size()});
    work.fixed_ms = slope.offset;
    work.ms_per_thousand = 1000 * slope.slope;
}

}  // namespace

bool is_quicker(const MeasuredKnob& knob, const MeasuredLevel& a, const MeasuredLevel& b) {
    return a.ms.median * (1 + knob.noise) < b.ms.median;
}

void judge(const KnobFacts& facts, MeasuredKnob& knob) {
    std::vector<LawPoint> errors, times;
    for (MeasuredLevel& level : knob.levels) {
        level.is_dominated = false;
        level.is_near_reference = level.error.max < kReferenceShare * knob.reference_bound;
        if (knob.has_one_level()) continue;
        for (const MeasuredLevel& other : knob.levels) level.is_dominated = level.is_dominated || dominates(knob, other, level);
        if (!level.is_near_reference) errors.push_back({level.amount, level.error.mean});
        times.push_back({level.amount, level.ms.median});
    }
    if (knob.has_one_level()) return;
    knob.error_law = fit_law(errors);
    knob.time_law = fit_law(times);
    if (knob.work) judge_work(facts, knob);
    if (!facts.law) return;
    knob.law_expected = expected_text("error", *facts.law);
    knob.law_agrees = agrees(knob.error_law, *facts.law);
}

const MeasuredLevel* cheapest_for(const MeasuredKnob& knob, double target_error) {
    const MeasuredLevel* best = nullptr;
    for (const MeasuredLevel& level : knob.levels)
        if (level.is_offered && level.trusted_error() <= target_error && (best == nullptr || level.ms.median < best->ms.median))
            best = &level;
    return best;
}

}  // namespace tedavis::host_sim
