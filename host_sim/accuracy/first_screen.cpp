#include "host_sim/accuracy/first_screen.hpp"

#include <algorithm>
#include <array>

#include "host_sim/accuracy/next_level.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

struct Budget {
    double ms;
    const char* name;
};
constexpr std::array<Budget, 5> kBudgets = {{{1000.0 / 120, "120 frames/s"},
                                             {12, "12 ms"},
                                             {1000.0 / 60, "60 frames/s"},
                                             {1000.0 / 30, "30 frames/s"},
                                             {100, "10 frames/s"}}};
constexpr std::size_t kFirstBudget = 2;

const MeasuredKnob* frame_knob(const AccuracyReport& report) {
    for (const MeasuredKnob& knob : report.knobs)
        if (knob.name == kFrameSettings) return &knob;
    return nullptr;
}

/// The knob has a level.
const MeasuredLevel& quickest_of(const MeasuredKnob& knob) {
    return *std::min_element(knob.levels.begin(), knob.levels.end(),
                             [](const auto& a, const auto& b) { return a.sample_ms.median < b.sample_ms.median; });
}

const NextLevel* next_of(const std::vector<NextLevel>& steps, const MeasuredLevel* level) {
    const auto found = std::find_if(steps.begin(), steps.end(), [&](const NextLevel& step) { return step.from == level; });
    return found == steps.end() ? nullptr : &*found;
}

std::string level_words(const MeasuredKnob& knob, const MeasuredLevel& level) {
    return level.name +
           printed(", %.1f ms (95 of 100 frames of the slowest place within %.1f ms), at most %.2g ", level.sample_ms.median,
                   level.kept_ms, level.trusted_error()) +
           knob.unit + (level.proven ? printed(" off (proven; %.2g measured)", level.error.max) : " off");
}

std::string sentence(const MeasuredKnob& knob, const std::vector<NextLevel>& steps, const Budget& budget) {
    const MeasuredLevel* const best = best_frame_within(knob, budget.ms);
    if (best == nullptr)
        return std::string("No settings keep to ") + budget.name + printed(" (%.1f ms). The quickest are ", budget.ms) +
               level_words(knob, quickest_of(knob)) + ".";
    std::string text = std::string("The best settings for ") + budget.name + printed(" (%.1f ms) are ", budget.ms) +
                       level_words(knob, *best) + ".";
    if (const NextLevel* const next = next_of(steps, best))
        text += " The next level, " + next->to->name +
                printed(", takes %.2f times as long and has %.2f times the error.", next->time_ratio, next->error_ratio);
    else
        text += " No other settings are more accurate.";
    return text;
}

/// Name, trusted and measured error, times.
std::string level_cells(const MeasuredLevel& level) {
    return html_cell(level.name) + html_number(printed("%.3g", level.trusted_error())) +
           html_aside(printed("%.3g", level.error.max)) + html_number(decimal(level.sample_ms.median, 2)) +
           html_aside(decimal(level.kept_ms, 2));
}

std::string budget_row(const MeasuredKnob& knob, const std::vector<NextLevel>& steps, const Budget& budget) {
    const std::string head = "<tr><th>" + std::string(budget.name) + "</th>" + html_aside(decimal(budget.ms, 1));
    const MeasuredLevel* const best = best_frame_within(knob, budget.ms);
    if (best == nullptr) return head + "<td colspan='8'>no settings keep to it</td></tr>";
    const NextLevel* const next = next_of(steps, best);
    return head + level_cells(*best) + html_cell(next == nullptr ? "" : next->to->name) +
           html_cell(next == nullptr ? "" : printed("x %.2f time, x %.2f error", next->time_ratio, next->error_ratio)) +
           html_cell(best->options) + "</tr>";
}

constexpr double kErrors_px[] = {0.5, 1, 2, 4, 8};

std::string target_row(const MeasuredKnob& knob, double error_px) {
    const std::string head = "<tr><th>" + printed("%g ", error_px) + escaped_html(knob.unit) + "</th>";
    const MeasuredLevel* const quickest = cheapest_for(knob, error_px);
    if (quickest == nullptr) return head + "<td colspan='6'>no settings keep to it</td></tr>";
    return head + level_cells(*quickest) + html_cell(quickest->options) + "</tr>";
}

std::string target_table(const MeasuredKnob& knob) {
    std::string rows;
    for (const double error_px : kErrors_px) rows += target_row(knob, error_px);
    return html_table(
        "<tr><th>an error of at most</th><th>quickest settings</th><th class='n'>error at most</th><th class='n "
        "aside'>measured</th><th class='n'>ms</th>"
        "<th class='n aside'>slowest place</th><th>in replay</th></tr>",
        rows);
}

}  // namespace

const MeasuredLevel* best_frame_within(const MeasuredKnob& knob, double budget_ms) {
    const MeasuredLevel* best = nullptr;
    for (const MeasuredLevel& level : knob.levels)
        if (level.kept_ms <= budget_ms && (best == nullptr || level.trusted_error() < best->trusted_error())) best = &level;
    return best;
}

std::string first_screen(const AccuracyReport& report) {
    const MeasuredKnob* const knob = frame_knob(report);
    if (knob == nullptr || knob->levels.empty())
        return html_section("What your frame time buys", "<p>This run did not measure " + std::string(kFrameSettings) +
                                                             ", the combinations of a picture's settings; add --knob " +
                                                             kFrameSettings + ".</p>\n");
    const std::vector<NextLevel> steps = next_levels(*knob);
    const MeasuredLevel* const best = best_frame_within(*knob, kBudgets[kFirstBudget].ms);
    const MeasuredLevel& quickest = quickest_of(*knob);
    const MeasuredLevel& shown = best != nullptr ? *best : quickest;
    std::string rows;
    for (const Budget& budget : kBudgets) rows += budget_row(*knob, steps, budget);
    return "<section id='first'><h2>What your frame time buys</h2>\n<p>" +
           escaped_html(sentence(*knob, steps, kBudgets[kFirstBudget])) + "</p>\n<div class='facts'>" +
           html_fact(decimal(shown.sample_ms.median, 1) + " ms", "a frame, median") +
           html_fact(printed("%.2g ", shown.trusted_error()) + knob->unit,
                     shown.proven ? "the proven error" : "the greatest error") +
           html_fact(decimal(quickest.sample_ms.median, 1) + " ms", "the quickest settings") + "</div>\n" +
           html_table(
               "<tr><th>a frame's time</th><th class='n aside'>ms</th><th>best settings</th><th class='n'>error at most, " +
                   escaped_html(knob->unit) +
                   "</th><th class='n aside'>measured</th><th class='n'>ms</th><th class='n aside'>slowest place</th><th>next "
                   "level</th><th></th><th>in "
                   "replay</th></tr>",
               rows) +
           target_table(*knob) + "</section>\n";
}

}  // namespace tedavis::host_sim
