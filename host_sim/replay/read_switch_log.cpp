#include "host_sim/replay/read_switch_log.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "host_sim/input_file.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// A panel's levels may have been noted when it was switched on, well before the flight.
constexpr base::Duration kLongestBefore = base::Duration::seconds(24 * 3600);

std::string line_of(std::string_view text, std::uint64_t number) {
    std::size_t at = 0;
    for (std::uint64_t n = 1; n < number && at != std::string_view::npos; ++n) {
        at = text.find('\n', at);
        at = at == std::string_view::npos ? at : at + 1;
    }
    if (at == std::string_view::npos) return {};
    std::string line(text.substr(at, text.find('\n', at) - at));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    return line;
}

std::string first_line_words(std::string_view text, const PanelReading& reading, bool is_unknown) {
    for (const bus::SwitchLineReport& report : reading.reports)
        if ((report.fault == bus::SwitchLineFault::line_name) == is_unknown)
            return "the first: line " + std::to_string(report.line) +
                   (is_unknown ? " '" + line_of(text, report.line) + "'" : std::string(", ") + bus::describe(report.fault));
    return "after the first " + std::to_string(reading.reports.size()) + " such lines";
}

std::size_t phase_line_count(const bus::SwitchConfig& panel) { return panel.lines.size() - (panel.has_legend_line ? 1 : 0); }

/// Of the lines that state the phase; without a level, the legend's line only does not ask for it.
std::string names_never_stated(const bus::SwitchConfig& panel, const PanelReading& reading, std::uint64_t& count) {
    std::uint32_t stated = 0;
    for (const bus::SwitchEdge& edge : reading.edges) stated |= std::uint32_t{1} << edge.line;
    std::string names;
    for (std::size_t n = 0; n < phase_line_count(panel); ++n) {
        if ((stated >> n & 1u) != 0) continue;
        ++count;
        names +=
            (names.empty() ? "" : ", ") + std::string(panel.lines[n].chip.view()) + "." + std::string(panel.lines[n].name.view());
    }
    return names;
}

}  // namespace

std::string read_switch_log(const std::string& path) {
    std::string text = read_file(path);
    if (bus::has_switch_log_header(text)) return text;
    const std::string_view header = bus::kSwitchLogHeader;
    throw UserError(path + ":1: not a switch log; give one whose first line is '" +
                    std::string(header.substr(0, header.size() - 1)) + "'");
}

PanelReading read_panel(std::string_view log_text, const bus::SwitchConfig& panel) {
    PanelReading reading;
    bus::SwitchLogSource source(log_text, panel);
    std::array<bus::SwitchEdge, 256> batch;
    constexpr base::Time kEndOfTime{std::numeric_limits<std::int64_t>::max()};
    while (const std::size_t count = source.read(kEndOfTime, {batch.data(), batch.size()}))
        reading.edges.insert(reading.edges.end(), batch.begin(), batch.begin() + static_cast<std::ptrdiff_t>(count));
    reading.statistics = source.statistics();
    reading.reports.assign(source.reports().begin(), source.reports().end());
    return reading;
}

Findings switch_findings(const std::string& log, std::string_view log_text, const std::string& panel_name,
                         const bus::SwitchConfig& panel, const PanelReading& reading) {
    Findings findings;
    const bus::SwitchStatistics& counts = reading.statistics;
    const std::uint64_t lines = counts.edges + counts.malformed + counts.unknown_lines;
    if (counts.malformed > 0)
        findings.push_back({"switches.broken_lines",
                            log + ": broken lines, " + part_of(counts.malformed, lines) + " (" +
                                first_line_words(log_text, reading, false) + ")",
                            counts.malformed});
    if (counts.edges == 0) {
        const bool is_empty = counts.unknown_lines == 0;
        findings.push_back({is_empty ? "switches.empty" : "switches.other_panel",
                            log + (is_empty ? ": states no level of any line"
                                            : ": none of " + counted(lines, "line") + " is of the panel " + panel_name + " (" +
                                                  first_line_words(log_text, reading, true) +
                                                  "); name the log's own panel with --switch-config"),
                            std::max<std::uint64_t>(lines, 1)});
        return findings;
    }
    if (counts.unknown_lines > 0)
        findings.push_back({"switches.unknown_line",
                            log + ": names that the panel " + panel_name + " does not have in " +
                                part_of(counts.unknown_lines, lines) + " lines (" + first_line_words(log_text, reading, true) +
                                ")",
                            counts.unknown_lines});
    std::uint64_t missing = 0;
    const std::string names = names_never_stated(panel, reading, missing);
    if (missing > 0)
        findings.push_back({"switches.never_stated",
                            log + ": no level for " + std::to_string(missing) + " of " + std::to_string(phase_line_count(panel)) +
                                " phase lines of the panel " + panel_name + " (" + names + "), so that it states no phase",
                            missing});
    return findings;
}

Findings switch_time_findings(const std::string& log, const std::vector<bus::SwitchEdge>& edges, base::Time first,
                              base::Time last) {
    if (edges.empty()) return {};
    const base::Time begin = edges.front().time, end = edges.back().time;
    if (begin <= last && end >= first - kLongestBefore) return {};
    const bool is_late = begin > last;
    const double apart_s = (is_late ? begin - last : first - end).to_seconds();
    return {{"switches.another_time",
             log + ": all " + counted(edges.size(), "edge") + " lie " + decimal(apart_s, 0) + " s " +
                 (is_late ? "after the log's end" : "and more before the log's begin") + "; give the switch log of this flight",
             edges.size()}};
}

}  // namespace tedavis::host_sim
