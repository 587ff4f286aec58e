#include "host_sim/accuracy/first_screen.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "host_sim/accuracy/next_level.hpp"
#include "host_sim/accuracy/time_answer.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kFirstBudget = 2;

const MeasuredKnob* frame_knob(const AccuracyReport& report) {
    for (const MeasuredKnob& knob : report.knobs)
        if (knob.name == kFrameSettings) return &knob;
    return nullptr;
}

const NextLevel* next_of(const std::vector<NextLevel>& steps, const MeasuredLevel* level) {
    const auto found = std::find_if(steps.begin(), steps.end(), [&](const NextLevel& step) { return step.from == level; });
    return found == steps.end() ? nullptr : &*found;
}

std::string level_words(const MeasuredKnob& knob, const MeasuredLevel& level) {
    return level.name + printed(", %.1f ms, at most %.2g ", level.sample_ms.median, level.trusted_error()) + knob.unit +
           (level.proven ? printed(" off (proven; %.2g measured)", level.error.max) : " off");
}

/// What the level needs of a budget, as a sentence without its end.
std::string need_sentence(const MeasuredKnob& knob, const MeasuredLevel& level) {
    return ". " + need_words(knob, time_need(knob, level));
}

std::string sentence(const MeasuredKnob& knob, const std::vector<NextLevel>& steps, const FrameBudget& budget) {
    const std::optional<TimeAnswer> best = answer_within(knob, budget.ms);
    if (!best) {
        const MeasuredLevel& least = least_needing(knob);
        return std::string("No settings keep to ") + budget.name + printed(" (%.1f ms). The quickest are ", budget.ms) +
               level_words(knob, least) + need_sentence(knob, least) + ".";
    }
    std::string text = std::string("The best settings for ") + budget.name + printed(" (%.1f ms) are ", budget.ms) +
                       level_words(knob, *best->level) + need_sentence(knob, *best->level) + share_words(*best) + ".";
    if (const NextLevel* const next = next_of(steps, best->level))
        text += " The next level, " + next->to->name +
                printed(", takes %.2f times as long and has %.2f times the error.", next->time_ratio, next->error_ratio);
    else
        text += " No other settings are more accurate.";
    return text;
}

/// Name, trusted and measured error, times.
std::string level_cells(const MeasuredKnob& knob, const MeasuredLevel& level) {
    return html_cell(level.name) + html_number(printed("%.3g", level.trusted_error())) +
           html_aside(printed("%.3g", level.error.max)) + html_number(decimal(level.sample_ms.median, 2)) +
           html_aside(decimal(time_need(knob, level).needed_ms(), 2));
}

std::string budget_row(const MeasuredKnob& knob, const std::vector<NextLevel>& steps, const FrameBudget& budget) {
    const std::string head = "<tr><th>" + std::string(budget.name) + "</th>" + html_aside(decimal(budget.ms, 1));
    const std::optional<TimeAnswer> best = answer_within(knob, budget.ms);
    if (!best) return head + "<td colspan='8'>no settings keep to it</td></tr>";
    const NextLevel* const next = next_of(steps, best->level);
    return head + level_cells(knob, *best->level) + html_cell(next == nullptr ? "" : next->to->name) +
           html_cell(next == nullptr ? "" : printed("x %.2f time, x %.2f error", next->time_ratio, next->error_ratio)) +
           html_cell(best->level->options) + "</tr>";
}

constexpr double kErrors_px[] = {0.5, 1, 2, 4, 8};

std::string target_row(const MeasuredKnob& knob, double error_px) {
    const std::string head = "<tr><th>" + printed("%g ", error_px) + escaped_html(knob.unit) + "</th>";
    const MeasuredLevel* const quickest = cheapest_for(knob, error_px);
    if (quickest == nullptr) return head + "<td colspan='6'>no settings keep to it</td></tr>";
    return head + level_cells(knob, *quickest) + html_cell(quickest->options) + "</tr>";
}

std::string target_table(const MeasuredKnob& knob) {
    std::string rows;
    for (const double error_px : kErrors_px) rows += target_row(knob, error_px);
    return html_table(
        "<tr><th>an error of at most</th><th>quickest settings</th><th class='n'>error at most</th><th class='n "
        "aside'>measured</th><th class='n'>ms</th>"
        "<th class='n aside'>with margin</th><th>in replay</th></tr>",
        rows);
}

}  // namespace

std::string first_screen(const AccuracyReport& report) {
    const MeasuredKnob* const knob = frame_knob(report);
    if (knob == nullptr || knob->levels.empty())
        return html_section("What your frame time buys", "<p>This run did not measure " + std::string(kFrameSettings) +
                                                             ", the combinations of a picture's settings; add --knob " +
                                                             kFrameSettings + ".</p>\n");
    const std::vector<NextLevel> steps = next_levels(*knob);
    const std::optional<TimeAnswer> best = answer_within(*knob, kFrameBudgets[kFirstBudget].ms);
    const MeasuredLevel& quickest = least_needing(*knob);
    const MeasuredLevel& shown = best ? *best->level : quickest;
    const TimeNeed need = time_need(*knob, shown);
    std::string rows;
    for (const FrameBudget& budget : kFrameBudgets) rows += budget_row(*knob, steps, budget);
    return "<section id='first'><h2>What your frame time buys</h2>\n<p>" +
           escaped_html(sentence(*knob, steps, kFrameBudgets[kFirstBudget])) + "</p>\n<div class='facts'>" +
           html_fact(decimal(shown.sample_ms.median, 1) + " ms", "a frame, median") +
           html_fact(decimal(need.needed_ms(), 1) + " ms",
                     printed("95 of 100 frames, with a margin of %.0f %%", 100 * need.margin)) +
           html_fact(printed("%.2g ", shown.trusted_error()) + knob->unit,
                     shown.proven ? "the proven error" : "the greatest error") +
           html_fact(decimal(quickest.sample_ms.median, 1) + " ms", "the quickest settings") + "</div>\n" +
           html_table(
               "<tr><th>a frame's time</th><th class='n aside'>ms</th><th>best settings</th><th class='n'>error at most, " +
                   escaped_html(knob->unit) +
                   "</th><th class='n aside'>measured</th><th class='n'>ms</th><th class='n aside'>with margin</th><th>next "
                   "level</th><th></th><th>in "
                   "replay</th></tr>",
               rows) +
           target_table(*knob) + "</section>\n";
}

}  // namespace tedavis::host_sim
