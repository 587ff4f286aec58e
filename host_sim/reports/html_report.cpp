#include "host_sim/reports/html_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/atomic_file.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/closest_section.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/phase_color.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/reports/run_words.hpp"
#include "host_sim/reports/track_map.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kStyle =
    ":root{color-scheme:light dark}"
    "body{font:16px/1.45 system-ui,sans-serif;max-width:70rem;margin:0 auto;padding:1rem}"
    "h1{font-size:1.4rem;margin:.2rem 0}h2{font-size:1.1rem;margin:1.4rem 0 .4rem;border-bottom:1px solid #8886}"
    ".strip{display:grid;grid-template-columns:repeat(auto-fill,minmax(9rem,1fr));gap:.5rem}"
    ".large{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,30rem),1fr));gap:.8rem}"
    "figure{margin:0}figure img{width:100%;height:auto;display:block;border:1px solid #8886}"
    "figcaption{font-size:.75rem;overflow-wrap:anywhere}"
    ".charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,22rem),1fr));gap:.5rem}"
    ".chart{width:100%;height:auto}.chart text{font:11px system-ui,sans-serif;fill:currentColor}"
    ".chart .span{font-size:9px;fill:#111}"
    ".grid{stroke:#8886;stroke-width:.5}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.85rem}"
    "th,td{text-align:left;padding:.2rem .6rem .2rem 0;border-bottom:1px solid #8884;vertical-align:top}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}"
    ".key{display:inline-block;width:.8rem;height:.8rem;margin-right:.3rem;vertical-align:-.05rem}"
    ".bad{color:#c22;font-weight:600}li,td,p{overflow-wrap:anywhere}"
    ".map{max-height:40rem}.map-text{fill:#111!important}.map-halo{stroke:#fff;stroke-width:3px;fill:#fff!important}"
    ".mark line{stroke:#b3261e}.mark .place{fill:#b3261e}.mark .label{fill:#fff;stroke:#b3261e;stroke-width:1.5}"
    ".mark text{fill:#111!important;font-weight:600}"
    "details>summary{cursor:pointer;font-weight:600;margin:1.2rem 0 .4rem}"
    "@media print{@page{size:A4;margin:12mm}body{max-width:none;padding:0;font-size:10px}details{display:none}"
    "section{break-inside:avoid}.wide{overflow:visible}h2{margin:.6rem 0 .2rem;font-size:12px}table{font-size:9px}"
    "th,td{padding:.05rem .5rem .05rem 0}.map{max-height:8cm}.charts{grid-template-columns:repeat(3,1fr)}"
    ".strip{grid-template-columns:repeat(8,1fr);gap:.2rem}.strip figure:nth-child(n+9){display:none}figcaption{font-size:7px}}";

std::string cell(const std::string& text) { return "<td>" + escaped_html(text) + "</td>"; }
std::string number_cell(const std::string& text) { return "<td class='n'>" + text + "</td>"; }
std::string section(const std::string& title, const std::string& content) {
    return "<section><h2>" + title + "</h2>" + content + "</section>\n";
}
std::string table(const std::string& head, const std::string& rows) {
    return "<div class='wide'><table><thead><tr>" + head + "</tr></thead><tbody>" + rows + "</tbody></table></div>";
}

std::string summary_table(const RunSummary& s) {
    std::string rows;
    const auto row = [&](const char* name, const std::string& value, bool bad = false) {
        if (value.empty()) return;
        rows +=
            "<tr><th>" + std::string(name) + "</th><td" + (bad ? " class='bad'" : "") + ">" + escaped_html(value) + "</td></tr>";
    };
    row("log", s.log);
    row("terrain", s.terrain);
    row("switches", s.switches);
    row("scene", s.scene);
    row("design", s.design);
    row("aircraft", s.aircraft);
    row("palette of the symbology", s.palette);
    row("light", s.light);
    row("device", s.device);
    row("size", std::to_string(s.width) + " x " + std::to_string(s.height));
    row("surface", s.gl);
    row("frames", std::to_string(s.frames) + (s.interrupted ? " (interrupted)" : ""), s.interrupted);
    row("frames a second, median", decimal(s.fps_median, 1));
    row("frame time, 99th percentile", decimal(s.ms_p99, 2) + " ms");
    row("worst terrain error", s.terrain_frames > 0 ? decimal(s.worst_error_px, 3) + " px" : "no terrain was drawn");
    if (s.worst_start_error_px > 0)
        row("worst terrain error while its first chunks arrived", decimal(s.worst_start_error_px, 3) + " px");
    row("heap allocations after start", std::to_string(s.heap_allocations_after_start), s.heap_allocations_after_start > 0);
    row("GL calls outside the device's list", std::to_string(s.gl_calls_outside_device), s.gl_calls_outside_device > 0);
    row("bus frames", std::to_string(s.can.frames) + ": " + std::to_string(s.can.decoded) + " decoded, " +
                          std::to_string(s.can.alien) + " alien, " + std::to_string(s.can.errors) + " errors, " +
                          std::to_string(s.can.dropped) + " dropped");
    row("lines of the log that are no frames",
        std::to_string(s.can.broken_lines) + " broken, " + std::to_string(s.can.other_lines) + " other", s.can.broken_lines > 0);
    return "<div class='wide'><table>" + rows + "</table></div>";
}

std::string warnings_list(const RunSummary& summary) {
    std::string items;
    for (const Finding& finding : summary.warnings) items += "<li class='bad'>" + escaped_html(finding.text) + "</li>";
    return items.empty() ? items : section("Warnings", "<ul>" + items + "</ul>");
}

std::string notes_list(const RunSummary& summary) {
    std::string items;
    for (const std::string& note : summary.notes) items += "<li>" + escaped_html(note) + "</li>";
    return items.empty() ? items : section("Notes", "<ul>" + items + "</ul>");
}

std::string closest_to_terrain(const RunSummary& summary) {
    const std::string html = closest_html(summary.closest);
    return html.empty() ? html : section("Closest to the terrain", html);
}

std::string figure(const std::string& caption, const std::string& png) {
    return "<figure><img alt='" + escaped_html(caption) + "' src='data:image/png;base64," + base64(png) + "'><figcaption>" +
           escaped_html(caption) + "</figcaption></figure>\n";
}

std::string strip(const RunStory& story) {
    std::string figures;
    for (const RunStory::Thumbnail& picture : story.thumbnails()) {
        const std::string caption =
            "frame " + std::to_string(picture.frame) + ", " + time_words(picture.time_s, story) + ", " + picture.phase;
        figures += figure(caption, picture.png);
    }
    return figures.empty() ? figures : section("Frames", "<div class='strip'>" + figures + "</div>");
}

std::string legends(const RunStory& story) {
    std::string figures;
    for (const RunStory::Legend& picture : story.legends()) {
        const std::string caption =
            "design " + picture.design + ": frame " + std::to_string(picture.frame) + ", " + decimal(picture.time_s, 1) + " s, " +
            picture.phase +
            (picture.is_whole ? ", drawn again with its whole legend" : "; the display is too small for more than the key");
        figures += figure(caption, picture.png);
    }
    return figures.empty() ? figures : section("Legends", "<div class='large'>" + figures + "</div>");
}

template <class Value>
std::vector<double> curve_of(const RunStory& story, Value value) {
    std::vector<double> values;
    for (const RunStory::Sample& sample : story.samples()) values.push_back(value(sample));
    return values;
}

/// Where frames lie much farther apart than usual, as between two spans over the terrain, no line joins them.
LineChart with_gaps(LineChart chart) {
    constexpr double kUsualSteps = 4;
    std::vector<double> steps;
    for (std::size_t n = 1; n < chart.times_s.size(); ++n) steps.push_back(chart.times_s[n] - chart.times_s[n - 1]);
    if (steps.empty()) return chart;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    const double longest_s = kUsualSteps * std::abs(steps[steps.size() / 2]);
    for (std::size_t n = chart.times_s.size() - 1; n > 0; --n) {
        const double before_s = chart.times_s[n - 1], after_s = chart.times_s[n];
        if (std::abs(after_s - before_s) <= longest_s) continue;
        const auto at = static_cast<std::ptrdiff_t>(n);
        chart.times_s.insert(chart.times_s.begin() + at, (before_s + after_s) / 2);
        for (ChartCurve& curve : chart.curves)
            curve.values.insert(curve.values.begin() + at, std::numeric_limits<double>::quiet_NaN());
    }
    return chart;
}

std::string charts(const RunStory& story) {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    LineChart altitude{"Altitude and phase", "m", {}, {}, {}};
    altitude.times_s = curve_of(story, [](const auto& s) { return s.time_s; });
    altitude.curves.push_back(
        {"own ship", "#3a78c2", curve_of(story, [&](const auto& s) { return s.position_valid ? s.altitude_msl_m : kGap; })});
    altitude.curves.push_back({"terrain", "#9a6b3f", curve_of(story, [&](const auto& s) {
                                   return s.position_valid && s.height_above_terrain_known
                                              ? s.altitude_msl_m - s.height_above_terrain_m
                                              : kGap;
                               })});
    for (const RunStory::PhaseSpan& span : story.phases())
        altitude.spans.push_back({span.begin_s, span.end_s, span.phase + " (" + span.source + ")", phase_color(span.phase)});
    LineChart speed{"Ground speed", "m/s", altitude.times_s, {}, {}};
    speed.curves.push_back({"ground speed", "#3f9a5a", curve_of(story, [](const auto& s) { return s.ground_speed_mps; })});
    LineChart time{"Frame time", "ms", altitude.times_s, {}, {}};
    time.curves.push_back({"total", "#c23b4e", curve_of(story, [](const auto& s) { return s.total_ms; })});
    return section("Over time", "<div class='charts'>" + line_chart_svg(with_gaps(altitude)) + line_chart_svg(with_gaps(speed)) +
                                    line_chart_svg(with_gaps(time)) + "</div>");
}

std::string phase_table(const RunStory& story) {
    std::string rows;
    for (const RunStory::PhaseSpan& span : story.phases()) {
        rows += "<tr><td><span class='key' style='background:" + phase_color(span.phase) + "'></span>" +
                escaped_html(span.phase) + "</td>" + cell(span.source) + number_cell(decimal(span.begin_s, 1)) +
                number_cell(decimal(span.end_s, 1)) + cell(span.design) + cell(span.first) + "</tr>";
    }
    return section(
        "Phases, and what came first",
        table("<th>phase</th><th>stated by</th><th>from s</th><th>to s</th><th>design</th><th>first aspect</th>", rows));
}

std::string flag_table(const RunStory& story) {
    if (story.flags().empty()) return section("Flags", "<p>None were raised.</p>");
    std::string rows;
    for (const auto& [name, span] : story.flags()) {
        rows += "<tr>" + cell(name) + number_cell(decimal(span.first_s, 1)) + number_cell(decimal(span.last_s, 1)) +
                number_cell(std::to_string(span.frames)) + "</tr>";
    }
    return section("Flags", table("<th>flag</th><th>first s</th><th>last s</th><th>frames</th>", rows));
}

/// The commonest reason of the frames without it.
std::string reason_of(const EffectCount& effect) {
    const EffectReason* commonest = nullptr;
    for (const EffectReason& reason : effect.reasons)
        if (commonest == nullptr || reason.frames > commonest->frames) commonest = &reason;
    return commonest == nullptr ? "" : commonest->text;
}

std::string effect_table(const RunSummary& summary) {
    std::string rows;
    for (const EffectCount& effect : summary.effects)
        rows += "<tr>" + cell(effect.name) + number_cell(std::to_string(effect.run)) +
                number_cell(std::to_string(effect.replaced + effect.skipped)) + cell(reason_of(effect)) + "</tr>";
    if (rows.empty()) return {};
    return section("What was drawn, and what was left out",
                   table("<th>effect</th><th>frames with it</th><th>frames without</th><th>commonest reason</th>", rows));
}

std::string lead(const RunSummary& summary, const RunStory& story) {
    std::string text;
    for (const std::string& sentence : run_sentences(summary, story)) text += (text.empty() ? "" : " ") + escaped_html(sentence);
    return "<p>" + text + "</p>\n";
}

/// With the closest points by height, numbered as in their table.
std::string map(const RunSummary& summary, const RunStory& story, const terrain::TerrainDatabase* terrain) {
    std::vector<MapMark> marks;
    for (const StatedClosest& closest : summary.closest.by_height) {
        const earth::Geodetic& place = closest.point.sample.own.place;
        const std::string number = std::to_string(marks.size() + 1);
        marks.push_back({base::degrees(place.latitude_rad), base::degrees(place.longitude_rad), number,
                         "closest to the ground, " + number + ": " + when_text(closest)});
    }
    const std::string svg = track_map_svg(story, terrain, marks);
    return svg.empty() ? svg : section("Track", svg);
}

/// Folded away, and not printed.
std::string folded(const std::string& title, const std::string& content) {
    return "<details><summary>" + title + "</summary>" + content + "</details>\n";
}

std::string memory_table(const base::BudgetTable& memory) {
    std::string rows;
    for (const base::BudgetLine& line : memory.lines()) {
        rows += "<tr>" + cell(std::string(line.name.view())) + cell(line.kind == base::MemoryKind::cpu ? "cpu" : "gpu") +
                number_cell(std::to_string(line.bytes)) + number_cell(std::to_string(line.use.high_water)) +
                number_cell(std::to_string(line.use.refused)) + cell(std::string(line.owner.view())) +
                cell(std::string(line.reason.view())) + "</tr>";
    }
    for (const auto kind : {base::MemoryKind::cpu, base::MemoryKind::gpu}) {
        rows += "<tr><th>total</th>" + cell(kind == base::MemoryKind::cpu ? "cpu" : "gpu") +
                number_cell(std::to_string(memory.total(kind))) + number_cell(std::to_string(memory.in_use(kind))) +
                "<td></td><td></td><td>in use at the end</td></tr>";
    }
    return section(
        "Memory",
        table("<th>name</th><th>kind</th><th>bytes</th><th>most used</th><th>refused</th><th>owner</th><th>reason</th>", rows));
}

}  // namespace

std::string html_report(const RunSummary& summary, const RunStory& story, const base::BudgetTable& memory,
                        const terrain::TerrainDatabase* terrain) {
    const std::string title = escaped_html(run_title(summary, story));
    return std::string(
               "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
               "content='width=device-width,initial-scale=1'><title>") +
           title + "</title><style>" + kStyle + "</style></head><body>\n<header><h1>" + title + "</h1>" + lead(summary, story) +
           "<p>TEDAVIS " + version() + ". A simulation; not certified for use in flight.</p></header>\n" +
           warnings_list(summary) + closest_to_terrain(summary) + map(summary, story, terrain) + charts(story) + strip(story) +
           phase_table(story) + effect_table(summary) + flag_table(story) + notes_list(summary) +
           folded("Legends of the pictures", legends(story)) +
           folded("For engineers: files, device, times, memory",
                  section("Summary", summary_table(summary)) + memory_table(memory)) +
           "</body></html>\n";
}

void write_run_reports(const std::string& folder, const RunSummary& summary, const RunStory& story,
                       const base::BudgetTable& memory, const terrain::TerrainDatabase* terrain) {
    write_file_atomically(folder + "/" + kSummaryName, run_summary_json(summary, memory));
    write_file_atomically(folder + "/" + kReportName, html_report(summary, story, memory, terrain));
}

}  // namespace tedavis::host_sim
