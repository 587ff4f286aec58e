#include "host_sim/evaluation/flight_report.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/evaluation/evaluation_views.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/evaluation/moment_card.hpp"
#include "host_sim/evaluation/report_look.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/phase_color.hpp"
#include "host_sim/version.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kFirstColor = "#0b57a4";
constexpr const char* kSecondColor = "#b26a00";
constexpr std::size_t kMaxValueRows = 80;

ComparedFlight side_of(const FlightReport& report, std::size_t n) {
    if (n >= report.flights.size()) return {};
    const std::string name = !report.comparison ? std::string()
                             : n == 0           ? "A " + report.comparison->name_a
                                                : "B " + report.comparison->name_b;
    return {&report.flights[n], name};
}

SpanSummary whole(const EvaluatedFlight& flight) { return summary_of(flight, 0, flight.run.frames.size()); }

std::string span_words(const EvaluatedFlight& flight) {
    const auto& frames = flight.run.frames;
    return std::to_string(frames.size()) + (frames.size() == 1 ? " frame" : " frames") + " from " +
           seconds_text(frames.front().time_s) + " to " + seconds_text(frames.back().time_s);
}

std::string run_words(const EvaluatedFlight& flight) {
    const FlightRun& run = flight.run;
    std::string text = run.folder;
    if (!run.log.empty()) text += ", " + run.log;
    if (!run.design.empty()) text += ", design " + run.design;
    if (!run.device.empty()) text += ", device " + run.device;
    if (!run.size.empty()) text += ", " + run.size + " pixels";
    return text;
}

std::string header(const FlightReport& report) {
    std::string html = "<header><h1>Flight evaluation: clutter and saliency</h1>";
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        const EvaluatedFlight& flight = report.flights[n];
        const std::string name = side_of(report, n).name;
        html += "<p>" + (name.empty() ? std::string() : "<b>" + escaped_html(name) + "</b>: ") + escaped_html(run_words(flight)) +
                ". " + span_words(flight) + (flight.interrupted ? "; interrupted, the rest was not evaluated" : "") + ".</p>";
    }
    return html + "</header>\n";
}

std::string facts_of_one(const FlightReport& report) {
    const EvaluatedFlight& flight = report.flights.front();
    const SpanSummary all = whole(flight);
    const FlightFrame& highest = flight.run.frames[all.highest_at];
    std::string html =
        html_fact(clutter_text(all.mean), "mean clutter: share of pixels that are edges") +
        html_fact(clutter_text(all.highest), "highest clutter, " + seconds_text(highest.time_s) + ", " + highest.phase);
    const std::vector<double> grid = mean_grid(flight);
    if (!grid.empty()) {
        const std::size_t busiest = busiest_region(grid);
        const int columns = report.settings.grid.columns;
        html += html_fact(clutter_text(grid[busiest]), "mean clutter of the busiest region, " +
                                                           region_name(report.settings.grid, static_cast<int>(busiest) % columns,
                                                                       static_cast<int>(busiest) / columns));
    }
    if (const std::optional<double> share = mean_prioritized_share(flight))
        html += html_fact(percent_text(*share), "of saliency lies on the aspect that comes first in the design");
    return html;
}

std::string facts_of_two(const FlightReport& report) {
    const PhaseDifference& all = report.comparison->all;
    const double change = all.mean_b - all.mean_a;
    return html_fact(clutter_text(all.mean_a), "mean clutter of " + side_of(report, 0).name) +
           html_fact(clutter_text(all.mean_b), "mean clutter of " + side_of(report, 1).name) +
           html_fact((change > 0 ? "+" : "") + clutter_text(change),
                     "B over A, mean of " + std::to_string(all.frames) + " frames of the same time");
}

LineChart clutter_chart(const FlightReport& report) {
    const EvaluatedFlight& first = report.flights.front();
    LineChart chart{
        report.comparison ? "Clutter of two designs" : "Clutter", "share of pixels that are edges", times_of(first), {}, {}};
    chart.curves.push_back({report.comparison ? side_of(report, 0).name : "clutter", kFirstColor, clutter_of(first)});
    for (const FlightPhaseSpan& span : phase_spans(first.run.frames)) {
        const std::size_t next = std::min(span.end, first.run.frames.size() - 1);
        chart.spans.push_back(
            {first.run.frames[span.first].time_s, first.run.frames[next].time_s, span.phase, phase_color(span.phase)});
    }
    if (!report.comparison) return chart;
    std::vector<double> second(first.run.frames.size(), std::nan(""));
    for (const auto& [a, b] : report.comparison->pairs) second[a] = report.flights[1].measures[b].clutter;
    chart.curves.push_back({side_of(report, 1).name, kSecondColor, second, true});
    return chart;
}

std::string chart_description(const FlightReport& report) {
    std::string text = "Line graph of clutter over time in seconds, with the flight phases below it.";
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        const EvaluatedFlight& flight = report.flights[n];
        const SpanSummary all = whole(flight);
        text += " " + (side_of(report, n).name.empty() ? std::string() : side_of(report, n).name + ": ") + "mean " +
                clutter_text(all.mean) + ", highest " + clutter_text(all.highest) + " at " +
                seconds_text(flight.run.frames[all.highest_at].time_s) + ".";
        for (const FlightMoment& moment : flight.moments) text += " " + moment_words(flight, moment) + ".";
    }
    return text + " The values stand in the tables below.";
}

/// One drawing for wide screens and paper, one for narrow ones.
std::string graph(const FlightReport& report) {
    LineChart chart = clutter_chart(report);
    chart.description = chart_description(report);
    for (const EvaluatedFlight& flight : report.flights)
        for (const FlightMoment& moment : flight.moments)
            chart.marks.push_back({flight.run.frames[moment.index].time_s, flight.measures[moment.index].clutter, moment.label,
                                   "#" + moment_id(moment), moment_words(flight, moment)});
    std::string html;
    chart.width = 1120, chart.height = 340;
    html += "<div class='wide'>" + line_chart_svg(chart) + "</div>\n";
    chart.width = 400, chart.height = 300;
    chart.unit.clear();
    return html + "<div class='narrow'>" + line_chart_svg(chart) + "</div>\n";
}

std::string rule_words(const EvaluatedFlight& flight) {
    return "Peaks rise by at least " + clutter_text(flight.peak_rule.least_prominence) +
           " over the valleys on both sides and stand at least " + seconds_text(flight.peak_rule.least_distance_s) +
           " apart; at most " + std::to_string(flight.peak_rule.most) + " are shown. " +
           agreement_words(agreement_over_moments(flight), "peaks");
}

std::string moments(const FlightReport& report) {
    std::string tabs, cards;
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        const EvaluatedFlight& flight = report.flights[n];
        for (const FlightMoment& moment : flight.moments) {
            tabs += moment_tab(flight, moment);
            cards += moment_card(side_of(report, n), moment, side_of(report, 1 - n), report.settings);
        }
    }
    return "<nav aria-label='moments'><ul class='tabs'>" + tabs + "</ul></nav>\n" + cards;
}

std::string phase_row(const EvaluatedFlight& flight, const SpanSummary& span, const std::string& name, bool is_all) {
    const auto& frames = flight.run.frames;
    return "<tr" + std::string(is_all ? " class='all'" : "") + "><td>" + name + "</td>" +
           html_aside(decimal(frames[span.first].time_s, 1)) + html_aside(decimal(frames[span.end - 1].time_s, 1)) +
           html_aside(std::to_string(span.end - span.first)) + html_number(clutter_text(span.mean)) +
           html_number(clutter_text(span.highest)) + html_aside(decimal(frames[span.highest_at].time_s, 1)) +
           html_cell(span.comes_first) + "</tr>\n";
}

std::string phase_table(const EvaluatedFlight& flight) {
    std::string rows;
    for (const SpanSummary& span : summaries_by_phase(flight)) rows += phase_row(flight, span, html_phase(span.phase), false);
    rows += phase_row(flight, whole(flight), "all", true);
    return html_section(
        "By phase",
        html_table(
            "<tr><th>phase</th><th class='n aside'>from s</th><th class='n aside'>to s</th><th class='n aside'>frames</th><th "
            "class='n'>mean clutter</th><th class='n'>highest</th><th class='n aside'>at s</th><th>comes first</th></tr>",
            rows));
}

std::string difference_row(const PhaseDifference& one, const std::string& name, bool is_all) {
    const double change = one.mean_b - one.mean_a;
    constexpr double kShown = 0.0005;
    const char* tone = change > kShown ? " more" : change < -kShown ? " less" : "";
    return "<tr" + std::string(is_all ? " class='all'" : "") + "><td>" + name + "</td>" + html_aside(decimal(one.begin_s, 1)) +
           html_aside(decimal(one.end_s, 1)) + html_aside(std::to_string(one.frames)) + html_number(clutter_text(one.mean_a)) +
           html_number(clutter_text(one.mean_b)) + "<td class='n" + tone + "'>" + (change >= 0 ? "+" : "") +
           clutter_text(change) + "</td>" + html_aside(clutter_text(one.highest_a)) + html_aside(clutter_text(one.highest_b)) +
           "</tr>\n";
}

std::string difference_table(const FlightComparison& comparison) {
    std::string rows;
    for (const PhaseDifference& one : comparison.phases) rows += difference_row(one, html_phase(one.phase), false);
    rows += difference_row(comparison.all, "all", true);
    std::string words;
    if (comparison.only_a + comparison.only_b > 0)
        words = "<p class='soft'>Frames without a counterpart are left out here: " + std::to_string(comparison.only_a) +
                " of A, " + std::to_string(comparison.only_b) + " of B.</p>";
    return html_section("Differences by phase",
                        html_table("<tr><th>phase (of A)</th><th class='n aside'>from s</th><th class='n aside'>to s</th><th "
                                   "class='n aside'>frames</th><th class='n'>mean A</th><th class='n'>mean B</th><th class='n'>B "
                                   "over A</th><th class='n aside'>highest A</th><th class='n aside'>highest B</th></tr>",
                                   rows) +
                            words);
}

std::string region_table(const FlightReport& report, const EvaluatedFlight& flight) {
    const std::vector<double> means = mean_grid(flight);
    const perception::RegionGrid& grid = report.settings.grid;
    std::string rows;
    auto next = means.begin();
    for (int row = 0; row < grid.rows && !means.empty(); ++row) {
        rows += "<tr>";
        for (int column = 0; column < grid.columns; ++column) {
            const double mean = *next++;
            const double share = std::min(1.0, mean / 0.35);
            rows += "<td style='background:hsl(28 90% " + decimal(96 - 40 * share, 0) + "%)'>" + decimal(mean, 2) + "</td>";
        }
        rows += "</tr>";
    }
    return rows.empty() ? rows : "<div class='wide-table'><table class='regions'><tbody>" + rows + "</tbody></table></div>\n";
}

std::string regions(const FlightReport& report) {
    std::string html = "<p class='soft'>Mean clutter of each region of the picture, as it lies on the display.</p>";
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        const std::string name = side_of(report, n).name;
        html += (name.empty() ? name : "<h3>" + escaped_html(name) + "</h3>") + region_table(report, report.flights[n]);
    }
    return html_section("Where the clutter is", html);
}

std::string eye_row(const SpanSummary& span, const std::vector<LayerShare>& all, const std::string& name, bool is_all) {
    std::string row = "<tr" + std::string(is_all ? " class='all'" : "") + "><td>" + name + "</td><td class='eye'>" +
                      layer_bar(span.layers, span.prioritized) + "</td>";
    for (const LayerShare& column : all) {
        const auto found = std::find_if(span.layers.begin(), span.layers.end(),
                                        [&](const LayerShare& layer) { return layer.layer == column.layer; });
        const bool is_first = column.layer == span.prioritized;
        row += "<td class='n" + std::string(is_first ? " first" : "") + "'>" +
               (found == span.layers.end() ? std::string() : percent_text(found->share)) + (is_first ? " &#9670;" : "") + "</td>";
    }
    return row + "</tr>\n";
}

/// "Is the prioritized aspect the salient one?" is a number here.
std::string eye_section(const FlightReport& report) {
    std::string html;
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        const EvaluatedFlight& flight = report.flights[n];
        const SpanSummary all = whole(flight);
        if (all.layers.empty()) continue;
        const std::string name = side_of(report, n).name;
        std::string rows, head = "<tr><th>phase</th><th>share of saliency</th>";
        for (const LayerShare& layer : all.layers) head += "<th class='n'>" + escaped_html(layer.layer) + "</th>";
        for (const SpanSummary& span : summaries_by_phase(flight))
            rows += eye_row(span, all.layers, html_phase(span.phase), false);
        html += (name.empty() ? name : "<h3>" + escaped_html(name) + "</h3>") + layer_key(all.layers) +
                html_table(head + "</tr>", rows + eye_row(all, all.layers, "all", true));
    }
    return html.empty()
               ? html
               : html_section(
                     "What draws the eye",
                     "<p class='soft'>The saliency of each picture, summed over the pixels of each layer; &#9670; marks the "
                     "layer of the aspect that comes first in the design.</p>" +
                         html);
}

/// Means and highest values of equal stretches of the flight.
std::string value_table(const EvaluatedFlight& flight) {
    const std::size_t count = flight.run.frames.size(), stride = (count + kMaxValueRows - 1) / kMaxValueRows;
    std::string rows;
    for (std::size_t first = 0; first < count; first += stride) {
        const SpanSummary span = summary_of(flight, first, std::min(first + stride, count));
        rows += "<tr>" + html_number(decimal(flight.run.frames[first].time_s, 1)) + html_cell(span.phase) +
                html_number(clutter_text(span.mean)) + html_number(clutter_text(span.highest)) + "</tr>\n";
    }
    const std::string each = stride == 1 ? "every frame" : "each " + std::to_string(stride) + " frames";
    return "<p class='soft'>Of " + each + "; those of all frames stand in evaluation.json.</p>" +
           html_table("<tr><th class='n'>from s</th><th>phase</th><th class='n'>mean clutter</th><th class='n'>highest</th></tr>",
                      rows);
}

std::string values(const FlightReport& report) {
    std::string html;
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        const std::string name = side_of(report, n).name;
        html += "<details><summary>Values of the graph" + (name.empty() ? name : ": " + escaped_html(name)) + "</summary>" +
                value_table(report.flights[n]) + "</details>\n";
    }
    return html;
}

/// "AUC 0.71, NSS 0.92"
std::string gaze_section(const FlightReport& report) {
    std::string rows;
    for (const EvaluatedFlight& flight : report.flights) {
        for (std::size_t n = 0; n < flight.measures.size(); ++n) {
            const std::optional<GazeScore>& score = flight.measures[n].gaze;
            if (!score) continue;
            rows += "<tr>" + html_number(decimal(flight.run.frames[n].time_s, 1)) + html_number(std::to_string(score->pixels)) +
                    html_number(decimal(score->auc, 3)) + html_number(score->nss ? decimal(*score->nss, 2) : "flat") + "</tr>";
        }
    }
    if (rows.empty()) return rows;
    return html_section("Recorded gaze",
                        "<p class='soft'>How well saliency tells where people looked: AUC 0.5 and NSS 0 are chance.</p>" +
                            html_table("<tr><th class='n'>at s</th><th class='n'>places</th><th class='n'>AUC</th><th "
                                       "class='n'>NSS</th></tr>",
                                       rows));
}

std::string method(const EvaluationSettings& settings) {
    return "<footer><p>Clutter: Canny's edges on each of the three colours, and their maximum (sigma " +
           decimal(settings.canny.sigma, 2) + " px, thresholds " + decimal(settings.canny.low, 0) + " and " +
           decimal(settings.canny.high, 0) +
           " on the length of the gradient of 8-bit channels). Saliency: Itti-CIO2 on CIE-Lab, each map normalised by its own "
           "picture, from "
           "means of 4 x 4 pixels for the numbers of frames and from every pixel for the pictures of moments. Feature Congestion "
           "and Subband Entropy: Rosenholtz, Li and Nakano 2007. All predict what the eye meets; none has seen the "
           "task.</p><p>TEDAVIS " +
           escaped_html(version()) + ". A simulation; not certified for use in flight.</p></footer>\n";
}

}  // namespace

std::string flight_report_page(const FlightReport& report) {
    std::string page =
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width,initial-scale=1'><title>Flight evaluation</title><style>" +
        std::string(kReportStyle) + "</style></head><body>\n" + header(report);
    page += "<div class='facts'>" + (report.comparison ? facts_of_two(report) : facts_of_one(report)) + "</div>\n<main>\n";
    page += html_section("Clutter over the flight", graph(report) + "<p class='soft'>" + rule_words(report.flights.front()) +
                                                        "</p>" + moments(report) + values(report));
    if (report.comparison) page += difference_table(*report.comparison);
    for (const EvaluatedFlight& flight : report.flights)
        if (!report.comparison) page += phase_table(flight);
    page += eye_section(report) + regions(report) + gaze_section(report);
    return page + "</main>\n" + method(report.settings) + "<script>" + kReportScript + "</script></body></html>\n";
}

}  // namespace tedavis::host_sim
