#include "host_sim/reports/run_words.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host_sim/calendar_time.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

std::string file_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// A name, and for how long it held, in the order of first appearance.
using Shares = std::vector<std::pair<std::string, double>>;

void add(Shares& shares, const std::string& name, double seconds) {
    for (auto& [known, sum] : shares) {
        if (known != name) continue;
        sum += seconds;
        return;
    }
    shares.emplace_back(name, seconds);
}

/// "cruise 33 min, approach 4 min".
std::string listed(const Shares& shares) {
    std::string text;
    for (const auto& [name, seconds] : shares) text += (text.empty() ? "" : ", ") + name + " " + duration_words(seconds);
    return text;
}

/// A phase lasts until the next one begins.
template <class Name>
Shares shares_of(const RunStory& story, Name name_of) {
    Shares shares;
    const auto& phases = story.phases();
    for (const RunStory::PhaseSpan& span : phases) add(shares, name_of(span), std::abs(span.end_s - span.begin_s));
    return shares;
}

std::string flown(const RunSummary& summary, const RunStory& story) {
    const auto& phases = story.phases();
    const double seconds = phases.empty() ? 0 : std::abs(phases.back().end_s - phases.front().begin_s);
    return counted(summary.frames, "frame") + " of " + duration_words(seconds) + " of " + file_name(summary.log) +
           ", shown by the design " + file_name(summary.design) + " on the device " + file_name(summary.device) +
           (summary.interrupted ? "; the run was interrupted." : ".");
}

/// "all": several aspects had the greatest weight.
std::string came_first(const Shares& first) {
    if (first.size() == 1 && first.front().first == "all") return "The picture put no aspect before the others.";
    return "The picture put first: " + listed(first) + ".";
}

std::string over_void(const RunSummary& summary) {
    if (summary.frames_over_void == 0) return "";
    return "; in " + counted(summary.frames_over_void, "frame") + " the height of the ground below the aircraft was not known";
}

std::string terrain_shown(const RunSummary& summary) {
    if (summary.terrain_frames == 0) return "No frame showed terrain.";
    return "Terrain was shown in " + std::to_string(summary.terrain_frames) + " of " + counted(summary.frames, "frame") +
           ", nowhere more than " + decimal(summary.worst_error_px, 2) + " pixels from the true surface" + over_void(summary) +
           ".";
}

/// Of the run's time, or of its frames where these are too far apart to have one.
std::string amount_words(const TerrainAlertCounts& counts, double hours, std::uint64_t frames) {
    return counts.has_gaps ? counted(frames, "frame") : duration_words(3600 * hours);
}

/// Why alerts were not possible, as main clauses, the longest first.
std::string hindrance_words(const TerrainAlertCounts& counts) {
    std::vector<std::size_t> found;
    for (std::size_t n = 1; n < kAlertHindranceCount; ++n)
        if (counts.frames_by[n] > 0) found.push_back(n);
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t a, std::size_t b) { return counts.frames_by[a] > counts.frames_by[b]; });
    std::string text;
    for (const std::size_t n : found) {
        text += (text.empty() ? "" : n == found.back() ? " and " : ", ") + std::string(words_of(static_cast<AlertHindrance>(n)));
        if (found.size() > 1) text += " (" + amount_words(counts, counts.hours_by[n], counts.frames_by[n]) + ")";
    }
    return text;
}

/// From "alerts were possible" on; empty where they always were.
std::string possible_words(const TerrainAlertCounts& counts) {
    if (counts.possible_frames() == counts.frames()) return {};
    return "alerts were possible in " +
           (counts.has_gaps ? std::to_string(counts.possible_frames()) : duration_words(3600 * counts.possible_hours())) +
           " of " + amount_words(counts, counts.hours, counts.frames()) + ", for in the others " + hindrance_words(counts) + ".";
}

std::string no_alert(const TerrainAlertCounts& counts) {
    if (counts.frames_by[static_cast<std::size_t>(AlertHindrance::no_terrain)] == counts.frames())
        return "Without terrain no terrain alert could be given.";
    if (counts.possible_frames() == 0) return "No terrain alert could be given: in all frames " + hindrance_words(counts) + ".";
    const std::string possible = possible_words(counts);
    return "No terrain alert was given" + (possible.empty() ? "." : "; " + possible);
}

std::string alerts(const RunSummary& summary) {
    const TerrainAlertCounts& counts = summary.terrain_alerts;
    if (counts.count == 0) return no_alert(counts);
    const std::string possible = possible_words(counts);
    return counted(counts.count, "terrain alert") + (counts.count == 1 ? " was" : " were") + " given, " +
           std::to_string(counts.warnings) + " with a warning; " + std::to_string(counts.false_count) +
           " were false, as the aircraft then kept clear of the ground" + (possible.empty() ? "." : "; " + possible);
}

}  // namespace

std::string duration_words(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::lround(seconds));
    const std::int64_t hours = whole / 3600, minutes = whole / 60 % 60, rest = whole % 60;
    const auto two = [](std::int64_t value) { return (value < 10 ? "0" : "") + std::to_string(value); };
    if (hours > 0) return std::to_string(hours) + " h " + two(minutes) + " min";
    if (minutes > 0) return std::to_string(minutes) + " min " + two(rest) + " s";
    return std::to_string(rest) + " s";
}

std::string run_title(const RunSummary& summary, const RunStory& story) {
    const RunStory::Utc& utc = story.utc();
    if (!utc.is_known) return "Run of " + file_name(summary.log);
    const std::string begin = utc_text(utc.begin), end = utc_text(utc.end);
    const std::string date = begin.substr(0, 10), other = end.substr(0, 10);
    return "Flight of " + date + ", " + begin.substr(11, 8) + " to " + (other == date ? "" : other + " ") + end.substr(11, 8) +
           " UTC" + (utc.is_confirmed ? "" : " (time not confirmed by the bus)");
}

std::string time_words(double time_s, const RunStory& story) {
    if (!story.utc().is_known) return decimal(time_s, 1) + " s";
    return utc_text(base::Time{} + base::Duration::from_seconds(time_s) + story.utc().from_run).substr(11, 8);
}

std::vector<std::string> run_sentences(const RunSummary& summary, const RunStory& story) {
    const Shares phases = shares_of(story, [](const auto& span) { return span.phase.substr(0, span.phase.find('.')); });
    const Shares first = shares_of(story, [](const auto& span) { return span.first; });
    std::vector<std::string> sentences = {flown(summary, story)};
    if (!phases.empty()) sentences.push_back("Flight phases: " + listed(phases) + ".");
    if (!first.empty()) sentences.push_back(came_first(first));
    sentences.push_back(terrain_shown(summary));
    sentences.push_back(alerts(summary));
    return sentences;
}

}  // namespace tedavis::host_sim
