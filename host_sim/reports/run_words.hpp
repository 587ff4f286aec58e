/// What a run was and what the display showed in it, in sentences for somebody who has never seen one.
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
/// A second of the run as the time of day, "12:46:05", or as it is, "312.5 s", where no date is known.
[[nodiscard]] std::string time_words(double time_s, const RunStory& story);
/// One sentence each: what was flown, phases, what came first, terrain, terrain alerts.
[[nodiscard]] std::vector<std::string> run_sentences(const RunSummary& summary, const RunStory& story);

}  // namespace tedavis::host_sim
