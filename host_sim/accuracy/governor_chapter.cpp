#include "host_sim/accuracy/governor_chapter.hpp"

#include <cstdio>
#include <numeric>

#include "host_sim/accuracy/work_precision_chart.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

using effects::QualityLevel;

std::string governor_figure(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string level_name(std::size_t n) { return n == 0 ? std::string("the design's picture") : "level " + std::to_string(n); }

std::string given_up_names(const QualityLevel& level) {
    std::string names;
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<effects::Effect>(n);
        if (level.given_up.has(effect)) names += (names.empty() ? "" : ", ") + std::string(effects::row_of(effect).name);
    }
    return names;
}

std::string share_text(const GovernorChoice& choice, std::size_t n) {
    const auto all = static_cast<double>(std::accumulate(choice.frames.begin(), choice.frames.end(), std::uint64_t{0}));
    return governor_figure("%.1f %%", all > 0 ? 100 * static_cast<double>(choice.frames[n]) / all : 0);
}

/// The levels as a knob's, so that they are drawn in the same way.
std::string level_chart(const GovernorChoice& choice, const char* title, const char* unit, double QualityLevel::*error) {
    MeasuredKnob knob;
    knob.title = title;
    knob.unit = unit;
    for (std::size_t n = 0; n < choice.levels.count; ++n) {
        const QualityLevel& level = choice.levels.at[n];
        MeasuredLevel drawn;
        drawn.name = level_name(n);
        drawn.ms.median = drawn.ms.p5 = drawn.ms.p95 = level.ms;
        drawn.error.mean = drawn.error.max = level.*error;
        knob.levels.push_back(drawn);
    }
    return work_precision_svg(knob);
}

std::string level_row(const GovernorChoice& choice, std::size_t n) {
    const QualityLevel& level = choice.levels.at[n];
    return "<tr><th>" + escaped_html(level_name(n)) + "</th>" + html_number(governor_figure("%g", level.tau_factor)) +
           html_number(governor_figure("%g", level.detail_factor)) + html_cell(given_up_names(level)) +
           html_number(governor_figure("%.3f", level.ms)) + html_number(governor_figure("%.3g", level.error_px)) +
           html_number(governor_figure("%.3g", level.error_color)) + html_number(std::to_string(choice.frames[n])) +
           html_number(share_text(choice, n)) + "</tr>";
}

}  // namespace

std::string governor_chapter(const GovernorChoice& choice) {
    std::string rows;
    for (std::size_t n = 0; n < choice.levels.count; ++n) rows += level_row(choice, n);
    const std::string words = "The levels that " + choice.costs + " holds, for " + choice.device + " on " + choice.renderer +
                              ". None is dominated by another one. Frames: those of " + choice.flight + " with a deadline of " +
                              governor_figure("%g", choice.deadline_ms) + " ms, planned by the modelled costs; " +
                              std::to_string(choice.missed) + " of them exceed the deadline nevertheless.";
    return "<p>" + escaped_html(words) + "</p>\n" +
           level_chart(choice, "Quality levels, terrain", "px", &QualityLevel::error_px) +
           level_chart(choice, "Quality levels, picture", "CIEDE2000", &QualityLevel::error_color) +
           html_table(
               "<tr><th>level</th><th class='n'>tau x</th><th class='n'>detail x</th><th>given up</th><th "
               "class='n'>ms</th><th class='n'>terrain, px</th><th class='n'>picture, CIEDE2000</th><th "
               "class='n'>frames</th><th class='n'>share</th></tr>",
               rows);
}

std::string governor_text(const GovernorChoice& choice) {
    std::string text = "\n\nwhat the governor may choose, and the frames of a flight with a deadline of " +
                       governor_figure("%g", choice.deadline_ms) + " ms";
    for (std::size_t n = 0; n < choice.levels.count; ++n) {
        const QualityLevel& level = choice.levels.at[n];
        text += "\n  " + level_name(n) + ": " + governor_figure("%.3f", level.ms) + " ms, " +
                governor_figure("%.3g", level.error_px) + " px, " + governor_figure("%.3g", level.error_color) + " CIEDE2000, " +
                std::to_string(choice.frames[n]) + " frames (" + share_text(choice, n) + ")";
    }
    return text;
}

}  // namespace tedavis::host_sim
