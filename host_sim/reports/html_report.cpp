#include "host_sim/reports/html_report.hpp"

#include <cmath>
#include <limits>

#include "host_sim/atomic_file.hpp"
#include "host_sim/reports/closest_section.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/page_parts.hpp"
#include "host_sim/reports/phase_color.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/reports/run_words.hpp"
#include "host_sim/reports/track_map.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kGhostTrackColor = "#8a2fc0";  // as in the pictures, but dark, over a light map
constexpr std::size_t kMaxMapPlaces = 2000;          // more are no finer than its pixels

std::string summary_table(const RunSummary& s) {
    std::string rows;
    const auto row = [&](const char* name, const std::string& value, bool bad = false) {
        if (value.empty()) return;
        rows +=
            "<tr><th>" + std::string(name) + "</th><td" + (bad ? " class='bad'" : "") + ">" + escaped_html(value) + "</td></tr>";
    };
    row("log", s.log);
    for (const ShownGhost& ghost : s.ghosts)
        row("ghost", ghost.name + ": " + ghost.log + ", aligned by " + std::string(name_of(ghost.align)));
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
    return items.empty() ? items : page_section("Warnings", "<ul>" + items + "</ul>");
}

std::string notes_list(const RunSummary& summary) {
    std::string items;
    for (const std::string& note : summary.notes) items += "<li>" + escaped_html(note) + "</li>";
    return items.empty() ? items : page_section("Notes", "<ul>" + items + "</ul>");
}

std::string closest_to_terrain(const RunSummary& summary) {
    const std::string html = closest_html(summary.closest);
    return html.empty() ? html : page_section("Closest to the terrain", html);
}

std::string strip(const RunStory& story) {
    constexpr std::size_t kPrinted = 8;  // evenly over the flight: one row
    const std::size_t count = story.thumbnails().size();
    std::string figures;
    for (std::size_t n = 0; n < count; ++n) {
        const RunStory::Thumbnail& picture = story.thumbnails()[n];
        const std::string caption =
            "frame " + std::to_string(picture.frame) + ", " + time_words(picture.time_s, story) + ", " + picture.phase;
        const bool is_printed = n == 0 || n * kPrinted / count != (n - 1) * kPrinted / count;
        figures += page_figure(caption, picture.png, is_printed ? "printed" : "");
    }
    return figures.empty() ? figures : page_section("Frames", "<div class='strip'>" + figures + "</div>");
}

std::string legends(const RunStory& story) {
    std::string figures;
    for (const RunStory::Legend& picture : story.legends()) {
        const std::string caption =
            "design " + picture.design + ": frame " + std::to_string(picture.frame) + ", " + decimal(picture.time_s, 1) + " s, " +
            picture.phase +
            (picture.is_whole ? ", drawn again with its whole legend" : "; the display is too small for more than the key");
        figures += page_figure(caption, picture.png);
    }
    return figures.empty() ? figures : page_section("Legends", "<div class='large'>" + figures + "</div>");
}

template <class Value>
std::vector<double> curve_of(const RunStory& story, Value value) {
    std::vector<double> values;
    for (const RunStory::Sample& sample : story.samples()) values.push_back(value(sample));
    return values;
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
    return page_section("Over time", "<div class='charts'>" + line_chart_svg(with_gaps(altitude)) +
                                         line_chart_svg(with_gaps(speed)) + line_chart_svg(with_gaps(time)) + "</div>");
}

std::string phase_table(const RunStory& story) {
    std::string rows;
    for (const RunStory::PhaseSpan& span : story.phases()) {
        rows += "<tr><td><span class='key' style='background:" + phase_color(span.phase) + "'></span>" +
                escaped_html(span.phase) + "</td>" + text_cell(span.source) + number_cell(decimal(span.begin_s, 1)) +
                number_cell(decimal(span.end_s, 1)) + text_cell(span.design) + text_cell(span.first) + "</tr>";
    }
    return page_section(
        "Phases, and what came first",
        page_table("<th>phase</th><th>stated by</th><th>from s</th><th>to s</th><th>design</th><th>first aspect</th>", rows));
}

std::string flag_table(const RunStory& story) {
    if (story.flags().empty()) return page_section("Flags", "<p>None were raised.</p>");
    std::string rows;
    for (const auto& [name, span] : story.flags()) {
        rows += "<tr>" + text_cell(name) + number_cell(decimal(span.first_s, 1)) + number_cell(decimal(span.last_s, 1)) +
                number_cell(std::to_string(span.frames)) + "</tr>";
    }
    return page_section("Flags", page_table("<th>flag</th><th>first s</th><th>last s</th><th>frames</th>", rows));
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
        rows += "<tr>" + text_cell(effect.name) + number_cell(std::to_string(effect.run)) +
                number_cell(std::to_string(effect.replaced + effect.skipped)) + text_cell(reason_of(effect)) + "</tr>";
    if (rows.empty()) return {};
    return page_section(
        "What was drawn, and what was left out",
        page_table("<th>effect</th><th>frames with it</th><th>frames without</th><th>commonest reason</th>", rows));
}

std::string lead(const RunSummary& summary, const RunStory& story) {
    std::string text;
    for (const std::string& sentence : run_sentences(summary, story)) text += (text.empty() ? "" : " ") + escaped_html(sentence);
    return "<p>" + text + "</p>\n";
}

/// Where places are left out, both ends of every gap are kept.
MapTrack ghost_map_track(const ShownGhost& ghost) {
    MapTrack track{"ghost " + ghost.name, kGhostTrackColor, 2, {}, true};
    const std::size_t stride = ghost.places.size() / kMaxMapPlaces + 1;
    for (std::size_t n = 0; n < ghost.places.size(); ++n) {
        const ShownGhost::Place& place = ghost.places[n];
        const bool ends = !place.joins_next, begins = n > 0 && !ghost.places[n - 1].joins_next;
        if (n % stride == 0 || ends || begins)
            track.places.push_back({place.time_s, place.latitude_deg, place.longitude_deg, place.joins_next});
    }
    return track;
}

/// Which flights are violet, where they are cut, and why their lines have gaps.
std::string ghost_legend(const RunSummary& summary, const RunStory& story, const std::vector<MapTrack>& ghosts) {
    if (ghosts.empty()) return {};
    std::string names, more;
    for (std::size_t n = 0; n < ghosts.size(); ++n) {
        const std::string name = escaped_html(ghosts[n].name);
        names += (names.empty() ? "" : ", ") + name;
        const MapTrackView view = view_of_track(story, ghosts, n);
        if (!view.is_shown) more += " All of " + name + " lies beyond this map, which is that of the flight shown.";
        if (view.is_shown && view.is_cut)
            more += " The line of " + name +
                    " is cut at the border: a part of its flight lies beyond this map, which is that of the "
                    "flight shown.";
        if (view.is_shown && view.has_gaps)
            more += " The line of " + name + " has gaps where its log has no position" +
                    (summary.ghosts[n].align == GhostAlign::place ? ", or where it was not near this flight." : ".");
    }
    return "<p>Violet, without phases: " + names + "." + more + "</p>\n";
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
    std::vector<MapTrack> ghosts;
    for (const ShownGhost& ghost : summary.ghosts) ghosts.push_back(ghost_map_track(ghost));
    const std::string svg = track_map_svg(story, terrain, marks, ghosts);
    return svg.empty() ? svg : page_section("Track", svg + ghost_legend(summary, story, ghosts));
}

std::string memory_table(const base::BudgetTable& memory) {
    std::string rows;
    for (const base::BudgetLine& line : memory.lines()) {
        rows += "<tr>" + text_cell(std::string(line.name.view())) +
                text_cell(line.kind == base::MemoryKind::cpu ? "cpu" : "gpu") + number_cell(std::to_string(line.bytes)) +
                number_cell(std::to_string(line.use.high_water)) + number_cell(std::to_string(line.use.refused)) +
                text_cell(std::string(line.owner.view())) + text_cell(std::string(line.reason.view())) + "</tr>";
    }
    for (const auto kind : {base::MemoryKind::cpu, base::MemoryKind::gpu}) {
        rows += "<tr><th>total</th>" + text_cell(kind == base::MemoryKind::cpu ? "cpu" : "gpu") +
                number_cell(std::to_string(memory.total(kind))) + number_cell(std::to_string(memory.in_use(kind))) +
                "<td></td><td></td><td>in use at the end</td></tr>";
    }
    return page_section(
        "Memory",
        page_table("<th>name</th><th>kind</th><th>bytes</th><th>most used</th><th>refused</th><th>owner</th><th>reason</th>",
                   rows));
}

}  // namespace

std::string html_report(const RunSummary& summary, const RunStory& story, const base::BudgetTable& memory,
                        const terrain::TerrainDatabase* terrain) {
    const std::string title = run_title(summary, story);
    return html_page(title, "<header><h1>" + escaped_html(title) + "</h1>" + lead(summary, story) + "<p>TEDAVIS " + version() +
                                ". A simulation; not certified for use in flight.</p></header>\n" + warnings_list(summary) +
                                closest_to_terrain(summary) + map(summary, story, terrain) + charts(story) + strip(story) +
                                phase_table(story) + effect_table(summary) + flag_table(story) + notes_list(summary) +
                                folded_part("Legends of the pictures", legends(story)) +
                                folded_part("For engineers: files, device, times, memory",
                                            page_section("Summary", summary_table(summary)) + memory_table(memory)));
}

void write_run_reports(const std::string& folder, const RunSummary& summary, const RunStory& story,
                       const base::BudgetTable& memory, const terrain::TerrainDatabase* terrain) {
    write_file_atomically(folder + "/" + kSummaryName, run_summary_json(summary, memory));
    write_file_atomically(folder + "/" + kReportName, html_report(summary, story, memory, terrain));
}

}  // namespace tedavis::host_sim
