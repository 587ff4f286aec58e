/// Describes a run and what the display showed, in sentences for readers who have not seen one before.
#pragma once

#include <string>
#include <vector>

#include "host_sim/reports/run_story.hpp"
#include "host_sim/reports/run_summary.hpp"

namespace tedavis::host_sim {

/// "2 h 05 min", "33 min 29 s", "12 s"; `seconds` not negative.
[[nodiscard]] std::string duration_words(double seconds);
/// "Flight of 2020-04-12, 09:47:00 to 12:40:12 UTC", or the log's name where no date is known.
[[nodiscard]] std::string run_title(const RunSummary& summary, const RunStory& story);
/// Returns a time of the run as UTC, "12:46:05", or in seconds, "312.5 s", where no date is known.
[[nodiscard]] std::string time_words(double time_s, const RunStory& story);
/// Returns one sentence each on the flight, its phases, the aspect with the highest priority, the terrain, and terrain alerts.
[[nodiscard]] std::vector<std::string> run_sentences(const RunSummary& summary, const RunStory& story);

}  // namespace tedavis::host_sim
