#include "host_sim/accuracy/accuracy_page.hpp"

#include <algorithm>

#include "host_sim/accuracy/compare_accuracy.hpp"
#include "host_sim/accuracy/effects_chapter.hpp"
#include "host_sim/accuracy/first_screen.hpp"
#include "host_sim/accuracy/flight_errors_chapter.hpp"
#include "host_sim/accuracy/governor_chapter.hpp"
#include "host_sim/accuracy/next_level.hpp"
#include "host_sim/accuracy/picture_section.hpp"
#include "host_sim/accuracy/work_precision_chart.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/evaluation/report_look.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

/// On a phone tables are smaller, and all their cells wrap.
constexpr const char* kAccuracyStyle =
    ".dominated td,.dominated th{color:#b3261e}.knob{break-inside:avoid}tbody th{font-weight:600;white-space:nowrap}"
    "tbody th a{white-space:normal}@media(max-width:40rem){table{font-size:.78rem}"
    "th,td,thead th,tbody th,th.n{white-space:normal;padding-right:.35rem}}";

std::string significant(double value) { return printed("%.3g", value); }

std::string bytes_text(double bytes) { return bytes == 0 ? "0" : printed("%.1f kB", bytes / 1000); }

struct Head {
    const char *text, *css = "";
};
constexpr const char *kNumberHead = "n", *kAsideHead = "n aside";

std::string heads(std::initializer_list<Head> columns) {
    std::string row = "<tr>";
    for (const Head& column : columns)
        row += "<th class='" + std::string(column.css) + "'>" + escaped_html(column.text) + "</th>";
    return row + "</tr>";
}

std::string level_row(const MeasuredLevel& level) {
    const char* const remark = !level.is_offered         ? "not offered"
                               : level.is_dominated      ? "dominated"
                               : level.is_near_reference ? "at the reference"
                                                         : "";
    return "<tr" + std::string(level.is_dominated ? " class='dominated'" : "") + "><th>" + escaped_html(level.name) + "</th>" +
           html_number(decimal(level.ms.median, 3)) + html_aside(decimal(level.ms.p5, 3) + " - " + decimal(level.ms.p95, 3)) +
           html_number(significant(level.error.mean)) + html_aside(significant(level.error.p95)) +
           html_aside(significant(level.error.p99)) + html_number(significant(level.error.max)) +
           html_aside(bytes_text(static_cast<double>(level.bytes))) +
           html_aside(level.uploaded_bytes ? bytes_text(static_cast<double>(*level.uploaded_bytes)) : "-") +
           html_aside(decimal(level.build_ms, 2)) + html_cell(remark) + "</tr>";
}

std::string level_table(const MeasuredKnob& knob) {
    std::string rows;
    for (const MeasuredLevel& level : knob.levels) rows += level_row(level);
    return html_table(heads({{"level"},
                             {"ms", kNumberHead},
                             {"5 - 95 %", kAsideHead},
                             {"mean error", kNumberHead},
                             {"95 %", kAsideHead},
                             {"99 %", kAsideHead},
                             {"greatest", kNumberHead},
                             {"memory", kAsideHead},
                             {"a frame to the GPU", kAsideHead},
                             {"build ms", kAsideHead},
                             {""}}),
                      rows);
}

std::string next_table(const MeasuredKnob& knob) {
    std::string rows;
    for (const NextLevel& step : next_levels(knob))
        rows += "<tr>" + html_cell(step.from->name) + html_cell(step.to->name) +
                html_number("x " + significant(step.error_ratio)) + html_number("x " + significant(step.time_ratio)) +
                html_number(bytes_text(step.more_bytes)) + "</tr>";
    if (rows.empty()) return "<p>Only one level is worth its time.</p>\n";
    return "<h3>What the next level costs</h3>\n" +
           html_table(heads({{"from"}, {"to"}, {"mean error", kNumberHead}, {"time", kNumberHead}, {"memory", kNumberHead}}),
                      rows);
}

std::string law_words(const char* what, const FittedLaw& law) {
    if (!law.holds) return std::string(what) + ": no law, since " + law.reason + ". ";
    return printed("%s ~ amount^%.2f (R2 %.3f; every point within a factor of %.2f of it). ", what, law.exponent, law.r2,
                   law.worst_residual);
}

std::string work_words(const MeasuredKnob& knob) {
    if (!knob.work) return "";
    const MeasuredWork& work = *knob.work;
    std::string counts;
    for (const double count : work.counts) counts += (counts.empty() ? "" : ", ") + decimal(count, 0);
    return "<p>" +
           escaped_html("The levels have, in the mean of a sample, " + counts + " " + work.thing + ". " +
                        law_words(work.thing.c_str(), work.law) + "Expected: " + work.law_expected +
                        (work.law_agrees ? "; the measurement agrees. " : "; the measurement differs. ") +
                        printed("A sample takes %.3f ms, and %.3f ms for each thousand ", work.fixed_ms, work.ms_per_thousand) +
                        work.thing + ".") +
           "</p>\n";
}

std::string worst_words(const MeasuredKnob& knob) {
    const auto worst = std::max_element(knob.levels.begin(), knob.levels.end(),
                                        [](const auto& a, const auto& b) { return a.error.max < b.error.max; });
    if (worst == knob.levels.end() || worst->error.max <= 0) return "";
    return "The greatest error, " + significant(worst->error.max) + " " + knob.unit + ", is that of " + worst->name + " at " +
           worst->worst_place + " (again: " + worst->worst_command + "). ";
}

/// What follows from the table: laws and the next level, or why there is one level only.
std::string conclusions(const MeasuredKnob& knob) {
    if (knob.has_one_level())
        return "<p>" + escaped_html("The product has the first level only: " + knob.only_level + ". " + worst_words(knob)) +
               "</p>\n";
    const std::string expected =
        knob.law_expected.empty()
            ? std::string()
            : "Expected: " + knob.law_expected + (knob.law_agrees ? "; the measurement agrees. " : "; the measurement differs. ");
    return "<p>" +
           escaped_html("The amount is " + knob.amount + ". " + law_words("Error", knob.error_law) +
                        law_words("Time", knob.time_law) + expected + worst_words(knob)) +
           "</p>\n" + work_words(knob) + next_table(knob);
}

std::string knob_section(const MeasuredKnob& knob) {
    const std::string facts =
        "<p>" +
        escaped_html("Error: " + knob.metric + ", in " + knob.unit + ". Reference: " + knob.reference + ", itself within " +
                     significant(knob.reference_bound) + ": " + knob.reference_reason + ". Second oracle: " + knob.second_oracle +
                     ".") +
        "</p>\n<p class='soft'>" +
        escaped_html("Setting: " + knob.setting + ". " + knob.never_trades + " " + std::to_string(knob.rounds) + " rounds of " +
                     std::to_string(knob.samples) + " samples; medians that differ by less than " + decimal(100 * knob.noise, 1) +
                     " % are not ranked.") +
        "</p>\n";
    return "<section class='knob' id='" + escaped_html(knob.name) + "'><h2>" + escaped_html(knob.title) + " <code>" +
           escaped_html(knob.name) + "</code></h2>\n" + facts + work_precision_svg(knob) + level_table(knob) + conclusions(knob) +
           (knob.pictures ? picture_section(*knob.pictures) : "") + "</section>\n";
}

/// A line a knob: its cheapest and its most accurate level that are worth their time.
std::string summary_table(const AccuracyReport& report) {
    std::string rows;
    for (const MeasuredKnob& knob : report.knobs) {
        if (knob.has_one_level()) continue;
        const MeasuredLevel *quick = nullptr, *exact = nullptr;
        for (const MeasuredLevel& level : knob.levels) {
            if (level.is_dominated) continue;
            if (quick == nullptr || level.ms.median < quick->ms.median) quick = &level;
            if (exact == nullptr || level.ms.median > exact->ms.median) exact = &level;
        }
        if (quick == nullptr) continue;
        rows += "<tr><th><a href='#" + escaped_html(knob.name) + "'>" + escaped_html(knob.title) + "</a></th>" +
                html_cell(quick->name) + html_number(decimal(quick->ms.median, 3)) + html_number(significant(quick->error.mean)) +
                html_cell(exact->name) + html_number(decimal(exact->ms.median, 3)) + html_number(significant(exact->error.mean)) +
                html_cell(knob.unit) + "</tr>";
    }
    return html_table(heads({{"setting"},
                             {"quickest"},
                             {"ms", kNumberHead},
                             {"mean error", kNumberHead},
                             {"most accurate"},
                             {"ms", kNumberHead},
                             {"mean error", kNumberHead},
                             {"unit"}}),
                      rows);
}

/// A line a setting with one level.
std::string one_level_section(const AccuracyReport& report) {
    std::string rows;
    for (const MeasuredKnob& knob : report.knobs) {
        if (!knob.has_one_level() || knob.levels.empty()) continue;
        const MeasuredLevel& level = knob.levels.front();
        rows += "<tr><th><a href='#" + escaped_html(knob.name) + "'>" + escaped_html(knob.title) + "</a></th>" +
                html_cell(level.name) + html_number(decimal(level.ms.median, 3)) + html_number(significant(level.error.mean)) +
                html_number(significant(level.error.max)) + html_cell(knob.unit) + "</tr>";
    }
    if (rows.empty()) return "";
    return html_section("Settings with one level", html_table(heads({{"setting"},
                                                                     {"level"},
                                                                     {"ms", kNumberHead},
                                                                     {"mean error", kNumberHead},
                                                                     {"greatest error", kNumberHead},
                                                                     {"unit"}}),
                                                              rows));
}

std::string summary_words(const AccuracyReport& report) {
    std::size_t levels = 0, dominated = 0, agree = 0, expected = 0;
    for (const MeasuredKnob& knob : report.knobs) {
        for (const MeasuredLevel& level : knob.levels) {
            levels += level.is_offered ? 1 : 0;
            dominated += level.is_dominated ? 1 : 0;
        }
        expected += knob.law_expected.empty() ? 0 : 1;
        agree += knob.law_agrees ? 1 : 0;
    }
    return "<div class='facts'>" + html_fact(std::to_string(report.knobs.size()), "settings measured") +
           html_fact(std::to_string(dominated) + " of " + std::to_string(levels), "levels that another one beats") +
           html_fact(std::to_string(agree) + " of " + std::to_string(expected), "expected laws that the measurements follow") +
           html_fact(decimal(report.conditions.load, 1), "load of the machine at the start") + "</div>\n";
}

std::string page_header(const AccuracyReport& report) {
    const MeasuringConditions& on = report.conditions;
    const std::string extent =
        (on.is_quick ? "; quick run" : "") + std::string(report.interrupted ? "; interrupted, the rest is missing" : "");
    return "<header><h1>What accuracy costs in time</h1><p>" +
           escaped_html(on.processor + ", " + std::to_string(on.processors) + " processors, load " + decimal(on.load, 1) +
                        " at the start; " + on.renderer + "; " + on.terrain + "; " + on.flight + "; pictures of the flight " +
                        on.size + ", device " + on.device + ", design " + on.design + extent) +
           ".</p><p class='soft'>" +
           escaped_html("Measured " + on.date + " with tedavis " + on.version + " (commit " + on.commit + "), built by " +
                        on.compiler + ", with fixed seeds for all random inputs: " + on.command) +
           "</p></header>\n";
}

std::string not_measured_section(const AccuracyReport& report) {
    if (report.not_measured.empty()) return "";
    std::string names;
    for (const std::string& name : report.not_measured) names += (names.empty() ? "" : ", ") + name;
    return html_section("Not measured", "<p>" + escaped_html(names) + ". The same command goes on with them.</p>\n");
}

std::string flights_section(const AccuracyReport& report) {
    if (report.flights.empty()) return "";
    return html_section("The terrain's error: asked for, proven, measured", flight_errors_chapter(report.flights));
}

std::string effects_section(const AccuracyReport& report) {
    if (!report.uncalled) return "";
    return html_section("What the scene did not call for", effects_chapter(*report.uncalled));
}

std::string governor_section(const AccuracyReport& report) {
    if (!report.governor) return "";
    return html_section("What the governor may choose", governor_chapter(*report.governor));
}

std::string control_section(const AccuracyReport& report) {
    if (!report.control) return "";
    return html_section("A level that is wrong on purpose",
                        "<p id='control'>" + escaped_html(control_text(*report.control)) + "</p>\n<p class='soft'>" +
                            escaped_html("Its greatest error is at " + report.control->worst_place + ".") + "</p>\n");
}

std::string comparison_section(const AccuracyReport& report) {
    if (report.comparisons.empty()) return "";
    return html_section("Beside earlier reports", comparison_table(report.comparisons));
}

}  // namespace

std::string accuracy_page(const AccuracyReport& report) {
    std::string page =
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width,initial-scale=1'><title>What accuracy costs in time</title><style>" +
        std::string(kReportStyle) + kAccuracyStyle + picture_style() + "</style></head><body>\n" + page_header(report) +
        "<main>\n" + first_screen(report) + summary_words(report) +
        html_section("From the quickest to the most accurate", summary_table(report)) + one_level_section(report);
    for (const MeasuredKnob& knob : report.knobs) page += knob_section(knob);
    return page + flights_section(report) + effects_section(report) + governor_section(report) + comparison_section(report) +
           control_section(report) + not_measured_section(report) +
           "</main>\n<footer><p>Charts: a disc is a level that is worth its time, a cross one that another level beats, a ring "
           "an alternative that the product does not offer, a square on the lower border a level without an error. The bar is "
           "the 5th to the 95th percentile of the times, the dashed line reaches up to the greatest "
           "error.</p></footer></body></html>\n";
}

}  // namespace tedavis::host_sim
