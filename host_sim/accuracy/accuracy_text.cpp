#include "host_sim/accuracy/accuracy_text.hpp"

#include <algorithm>
#include <set>

#include "host_sim/accuracy/compare_accuracy.hpp"
#include "host_sim/accuracy/effects_chapter.hpp"
#include "host_sim/accuracy/flight_errors_chapter.hpp"
#include "host_sim/accuracy/governor_chapter.hpp"
#include "host_sim/accuracy/time_answer.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string level_line(const MeasuredLevel& level) {
    const char* const remark = !level.is_offered         ? "  not offered"
                               : level.is_dominated      ? "  dominated"
                               : level.is_near_reference ? "  at the reference"
                                                         : "";
    return printed("\n  %-24s %10.3f %10.3f %10.3f  %10.3g %10.3g %10.3g %10llu%s", level.name.c_str(), level.ms.median,
                   level.ms.p5, level.ms.p95, level.error.mean, level.error.p99, level.error.max,
                   static_cast<unsigned long long>(level.bytes), remark);
}

std::string law_text(const char* what, const FittedLaw& law) {
    if (!law.holds) return std::string("\n  ") + what + ": no law, " + law.reason;
    return printed("\n  %s ~ amount^%.2f (R2 %.3f, points within a factor of %.2f)", what, law.exponent, law.r2,
                   law.worst_residual);
}

std::string work_text(const MeasuredWork& work) {
    return law_text(work.thing.c_str(), work.law) + "\n  expected: " + work.law_expected +
           (work.law_agrees ? ": agrees" : ": differs") +
           printed("\n  a sample takes %.3f ms, and %.3f ms for each thousand ", work.fixed_ms, work.ms_per_thousand) +
           work.thing;
}

std::string knob_text(const MeasuredKnob& knob) {
    std::string text = "\n\n" + knob.name + ": " + knob.title + "\n  error: " + knob.metric + ", " + knob.unit + "; against " +
                       knob.reference + printed(" (itself within %.2g)", knob.reference_bound) +
                       printed("\n  %zu rounds of %zu samples; medians that differ by less than %.1f %% are not ranked",
                               knob.rounds, knob.samples, 100 * knob.noise) +
                       printed("\n  %-24s %10s %10s %10s  %10s %10s %10s %10s", "level", "ms median", "p5", "p95", "mean", "p99",
                               "max", "bytes");
    for (const MeasuredLevel& level : knob.levels) text += level_line(level);
    if (knob.has_one_level()) return text + "\n  one level: " + knob.only_level;
    text += law_text("error", knob.error_law) + law_text("time", knob.time_law);
    if (!knob.law_expected.empty()) text += "\n  expected: " + knob.law_expected + (knob.law_agrees ? ": agrees" : ": differs");
    if (knob.work) text += work_text(*knob.work);
    return text;
}

/// Name, time, error; without a level that none keeps to it.
std::string choice_text(const MeasuredKnob& knob, const MeasuredLevel* level) {
    const std::string name = "\n  " + knob.name + ": ";
    if (level == nullptr) return name + "no level keeps to it";
    const double ms = is_of_frames(knob) ? level->sample_ms.median : level->ms.median;
    return name + level->name + printed(" (%.3f ms, at most %.3g ", ms, level->trusted_error()) + knob.unit +
           (level->proven ? printed(", proven; %.3g measured)", level->error.max) : ")");
}

std::string options_text(const MeasuredLevel* level) {
    return level == nullptr || level->options.empty() ? "" : "; tedavis replay LOG -o DIR " + level->options;
}

std::string answer_text(const MeasuredKnob& knob, double budget_ms) {
    const std::optional<TimeAnswer> answer = answer_within(knob, budget_ms);
    if (!answer) return choice_text(knob, nullptr);
    return choice_text(knob, answer->level) + "; " + need_words(knob, answer->need) + share_words(*answer) +
           options_text(answer->level);
}

}  // namespace

std::string accuracy_text(const AccuracyReport& report) {
    const MeasuringConditions& on = report.conditions;
    std::string text = "tedavis " + on.version + (on.is_quick ? ", quick" : "") + ", " + on.processor + " x " +
                       std::to_string(on.processors) + printed(", load %.1f", on.load) + ", " + on.terrain + ", " + on.flight;
    for (const MeasuredKnob& knob : report.knobs) text += knob_text(knob);
    for (const std::string& name : report.not_measured) text += "\n\n" + name + ": not measured";
    text += flight_errors_text(report.flights);
    if (report.uncalled) text += uncalled_text(*report.uncalled);
    if (report.governor) text += governor_text(*report.governor);
    if (report.control) text += "\n\n" + control_text(*report.control);
    for (const ComparedReport& compared : report.comparisons) text += comparison_text(compared);
    return text;
}

std::string budget_text(const AccuracyReport& report, double budget_ms) {
    std::string text = printed("\n\nthe most accurate within %g ms", budget_ms);
    bool is_possible = report.knobs.empty();
    double least_ms = 1e300;
    for (const MeasuredKnob& knob : report.knobs) {
        text += answer_text(knob, budget_ms);
        const double needed_ms = time_need(knob, least_needing(knob)).needed_ms();
        is_possible = is_possible || needed_ms <= budget_ms;
        least_ms = std::min(least_ms, needed_ms);
    }
    if (!is_possible)
        throw UserError(
            printed("--budget-ms %g: no level of any measured setting keeps to it; the quickest needs %.3g ms, with "
                    "the margin that was measured",
                    budget_ms, least_ms));
    return text;
}

std::string target_text(const AccuracyReport& report, double target_error, const std::string& unit, const std::string& option) {
    std::string text = printed("\n\nthe quickest with at most %g ", target_error) + unit, units;
    std::set<std::string> known;
    for (const MeasuredKnob& knob : report.knobs) {
        if (known.insert(knob.unit).second) units += (units.empty() ? "" : ", ") + knob.unit;
        if (knob.unit != unit) continue;
        const MeasuredLevel* const quickest = cheapest_for(knob, target_error);
        text += choice_text(knob, quickest) + options_text(quickest);
    }
    if (known.count(unit) == 0)
        throw UserError(option + ": no measured knob has errors in '" + unit + "'; the units are " + units);
    return text;
}

}  // namespace tedavis::host_sim
