#include "host_sim/accuracy/measured_knob.hpp"

#include <cmath>
#include <cstdio>

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

std::string expected_text(const ExpectedLaw& law) {
    char text[96];
    std::snprintf(text, sizeof text, "error ~ amount^%.2f, +- %.2f (", law.exponent, law.tolerance);
    return text + law.source.text() + ")";
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
    if (!facts.law) return;
    knob.law_expected = expected_text(*facts.law);
    knob.law_agrees = knob.error_law.holds && std::abs(knob.error_law.exponent - facts.law->exponent) <= facts.law->tolerance;
}

const MeasuredLevel* best_within(const MeasuredKnob& knob, double budget_ms) {
    const MeasuredLevel* best = nullptr;
    for (const MeasuredLevel& level : knob.levels)
        if (level.is_offered && level.ms.median <= budget_ms && (best == nullptr || level.error.max < best->error.max))
            best = &level;
    return best;
}

const MeasuredLevel* cheapest_for(const MeasuredKnob& knob, double target_error) {
    const MeasuredLevel* best = nullptr;
    for (const MeasuredLevel& level : knob.levels)
        if (level.is_offered && level.error.max <= target_error && (best == nullptr || level.ms.median < best->ms.median))
            best = &level;
    return best;
}

}  // namespace tedavis::host_sim
