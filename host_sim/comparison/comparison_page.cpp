#include "host_sim/comparison/comparison_page.hpp"

#include <cmath>

#include "host_sim/comparison/comparison_charts.hpp"
#include "host_sim/comparison/comparison_words.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/page_parts.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "host_sim/reports/track_map.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kComparisonStyle =
    ".pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,17rem),1fr));gap:.4rem;margin-bottom:.3rem}"
    ".states{min-width:42rem}h3{font-size:.95rem;margin:1rem 0 .3rem}"
    ".a{color:#3a78c2;font-weight:700}.b{color:#c8641b;font-weight:700}"
    "@media print{.pair{grid-template-columns:1fr 1fr}.moment{break-inside:avoid}}";

std::string listed_sentences(const std::vector<std::string>& sentences) {
    std::string items;
    for (const std::string& sentence : sentences) items += "<li>" + escaped_html(sentence) + "</li>";
    return "<ul>" + items + "</ul>";
}

std::string warning_part(const RunComparison& runs) {
    std::string items;
    for (const std::string& warning : comparison_warnings(runs)) items += "<li class='bad'>" + escaped_html(warning) + ".</li>";
    return items.empty() ? items : page_section("Warnings", "<ul>" + items + "</ul>");
}

MapTrack map_track(const ComparedRun& run, const char* name, const char* color, double width) {
    MapTrack track{name, color, width, {}};
    for (const ComparedFrame& frame : run.frames)
        if (frame.has_place) track.places.push_back({frame.time_s, frame.latitude_deg, frame.longitude_deg});
    return track;
}

std::string feet_text(double metres) { return decimal(metres / base::kMetresPerFoot, 0) + " ft"; }

void add_closest_mark(const ComparedRun& run, const std::optional<RunClosest>& closest, const std::string& name,
                      std::vector<MapMark>& marks) {
    if (!closest || !closest->has_place()) return;
    const std::string height = feet_text(closest->height_m);
    for (MapMark& mark : marks) {
        if (mark.latitude_deg != closest->latitude_deg || mark.longitude_deg != closest->longitude_deg) continue;
        mark.label = "A, B: " + height;
        mark.description = "both are closest to the ground, " + height + " above it";
        return;
    }
    marks.push_back({closest->latitude_deg, closest->longitude_deg, name + ": " + height,
                     name + " is closest to the ground, " + height + " above it, at " + frame_time_words(run, closest->time_s)});
}

std::string closest_rows_of(const ComparedRun& run, const std::optional<RunClosest>& closest, const char* name) {
    if (!closest) return {};
    return "<tr>" + text_cell(name) + number_cell(feet_text(closest->height_m)) +
           number_cell(escaped_html(frame_time_words(run, closest->time_s))) + text_cell(closest->phase) +
           text_cell(searched_words(*closest)) + "</tr>";
}

std::string closest_part(const RunComparison& runs) {
    const std::string rows = closest_rows_of(runs.a, runs.closest_a, "A") + closest_rows_of(runs.b, runs.closest_b, "B");
    if (rows.empty()) return {};
    return page_section("Closest to the ground in flight",
                        page_table("<th>run</th><th>above the terrain</th><th>at</th><th>phase</th><th>searched</th>", rows));
}

std::string map_part(const RunComparison& runs, const MapTerrain& terrain) {
    constexpr double kBelow = 5, kAbove = 2;
    std::vector<MapMark> marks;
    add_closest_mark(runs.a, runs.closest_a, "A", marks);
    add_closest_mark(runs.b, runs.closest_b, "B", marks);
    const std::string svg = tracks_map_svg({map_track(runs.a, "A", kColorOfA, kBelow), map_track(runs.b, "B", kColorOfB, kAbove)},
                                           terrain.database, marks);
    if (svg.empty()) return {};
    const std::string closest =
        marks.empty() ? std::string() : " Red: where a run is closest to the ground, and how high above it.";
    return page_section("Tracks", svg + "<p><span class='a'>A: wide line.</span> <span class='b'>B: thin line.</span>" + closest +
                                      (terrain.why_none.empty() ? "" : " " + escaped_html(terrain.why_none)) + "</p>");
}

std::string numbers_of(const RunComparison& runs, std::size_t instant, bool is_a) {
    static constexpr const char* kAlerts[] = {"", ", terrain caution", ", terrain warning"};
    const ComparedFrame& frame = is_a ? runs.frame_a(instant) : runs.frame_b(instant);
    std::string text = frame.phase + kAlerts[frame.terrain_alert];
    const double height_m = frame.values[kHeightAboveTerrain], labels = frame.values[kLabelsPlaced];
    if (std::isfinite(height_m)) text += ", " + feet_text(height_m) + " above the terrain";
    if (std::isfinite(labels)) text += ", " + decimal(labels, 0) + (labels == 1 ? " label" : " labels");
    return text;
}

std::string moment_figure(const RunComparison& runs, std::size_t instant, bool is_a) {
    constexpr std::uint32_t kWidth = 640;
    const ComparedFrame& frame = is_a ? runs.frame_a(instant) : runs.frame_b(instant);
    const std::string caption = std::string(is_a ? "A" : "B") + ", frame " + std::to_string(frame.frame) + " at " +
                                frame_time_words(is_a ? runs.a : runs.b, frame.time_s) + ": " + numbers_of(runs, instant, is_a);
    return page_figure(caption, encode_small_png(view_of(shrunk(view_of(read_png(frame.picture)), kWidth))));
}

std::string moment_part(const RunComparison& runs, const std::vector<ComparisonMoment>& moments) {
    std::string html;
    for (const ComparisonMoment& moment : moments) {
        std::string why;
        for (const std::string& reason : moment.reasons) why += (why.empty() ? ": " : ", ") + reason;
        html += "<div class='moment'><h3>" + escaped_html(instant_words(runs, moment.instant) + why) + "</h3><div class='pair'>" +
                moment_figure(runs, moment.instant, true) + moment_figure(runs, moment.instant, false) + "</div></div>\n";
    }
    return html.empty() ? html : page_section("Side by side", html);
}

/// Without the sign of what rounds to 0.
std::string signed_text(double value, int digits) {
    const std::string text = decimal(value, digits);
    return text.find_first_of("123456789") == std::string::npos ? decimal(0, digits) : text;
}

/// With its unit, and the number of instants that the row is of where it is not all of them.
std::string title_with_count(const RunComparison& runs, const QuantityDifference& one) {
    const std::size_t instants = runs.aligned.instants.size();
    const std::string unit = kQuantities[one.quantity].shown_unit;
    const std::string title = kQuantities[one.quantity].title + (unit.empty() ? unit : ", " + unit);
    return one.count == instants ? title : title + " (" + part_of(one.count, instants) + " instants)";
}

std::string place_of_greatest(const RunComparison& runs, const QuantityDifference& one) {
    if (one.greatest != 0) return instant_words(runs, one.greatest_at);
    return one.count == runs.aligned.instants.size() ? "equal everywhere" : "equal where both know it";
}

std::string quantity_rows(const RunComparison& runs) {
    std::string rows;
    for (const QuantityDifference& one : runs.quantities) {
        const Quantity& quantity = kQuantities[one.quantity];
        const int mean_digits = std::max(quantity.digits, 1);
        const auto cell = [&](double value, int digits) { return number_cell(signed_text(value * quantity.per_unit, digits)); };
        rows += "<tr>" + text_cell(title_with_count(runs, one)) + cell(one.mean_a, mean_digits) + cell(one.mean_b, mean_digits) +
                cell(one.mean_b - one.mean_a, mean_digits) + cell(one.greatest, quantity.digits) +
                text_cell(place_of_greatest(runs, one)) + "</tr>";
    }
    return rows;
}

std::string numbers_part(const RunComparison& runs) {
    const std::string rows = quantity_rows(runs);
    if (rows.empty()) return {};
    return page_section("In numbers",
                        page_table("<th>quantity</th><th>mean of A</th><th>mean of B</th><th>mean of B - A</th>"
                                   "<th>greatest B - A</th><th>at</th>",
                                   rows) +
                            "<p>Means of heights and distances are of the instants; other means are of the frames that are "
                            "compared, each once: " +
                            std::to_string(runs.compared_a.size()) + " of A, " + std::to_string(runs.compared_b.size()) +
                            " of B.</p>");
}

std::string effects_part(const RunComparison& runs) {
    std::string rows, equal;
    for (const EffectDifference& effect : runs.effects) {
        if (effect.share_a == effect.share_b) {
            equal += (equal.empty() ? "" : ", ") + effect.name;
            continue;
        }
        rows += "<tr>" + text_cell(effect.name) + number_cell(std::to_string(effect.frames_a)) +
                number_cell(std::to_string(effect.frames_b)) + "</tr>";
    }
    if (runs.effects.empty()) return {};
    std::string html;
    if (!rows.empty())
        html += page_table("<th>effect</th><th>of " + counted(runs.compared_a.size(), "frame") + " of A</th><th>of " +
                               counted(runs.compared_b.size(), "frame") + " of B</th>",
                           rows);
    if (!equal.empty()) html += "<p>In equal parts of the frames of both: " + escaped_html(equal) + ".</p>";
    return page_section("Effects drawn", html);
}

}  // namespace

std::string comparison_page(const RunComparison& runs, const std::vector<ComparisonMoment>& moments, const MapTerrain& terrain) {
    const std::string title = comparison_title(runs);
    std::string introduction;
    for (const std::string& sentence : run_introductions(runs))
        introduction += (introduction.empty() ? "" : " ") + escaped_html(sentence);
    const std::string charts = comparison_states(runs) + comparison_charts(runs);
    const std::string page = html_page(
        title,
        "<header><h1>" + escaped_html(title) + "</h1>" + listed_sentences(difference_sentences(runs)) + "<p>" + introduction +
            "</p><p>TEDAVIS " + version() + ". A simulation; not certified for use in flight.</p></header>\n" +
            warning_part(runs) + map_part(runs, terrain) + closest_part(runs) + moment_part(runs, moments) +
            (charts.empty() ? charts : page_section("Over the " + runs.aligned.axis, charts)) + numbers_part(runs) +
            effects_part(runs),
        kComparisonStyle);
    const std::string common = "<!DOCTYPE html>\n<html lang='en'>";
    return kComparisonPageBeginning + page.substr(common.size());
}

}  // namespace tedavis::host_sim
