/// The chapter of the report on the quality levels that the governor may choose, and the same as lines of text.
#pragma once

#include <string>

#include "host_sim/accuracy/governor_choice.hpp"

namespace tedavis::host_sim {

/// HTML: charts of both errors over the time, and a table with a row for each level.
[[nodiscard]] std::string governor_chapter(const GovernorChoice& choice);

/// A line for each level.
[[nodiscard]] std::string governor_text(const GovernorChoice& choice);

}  // namespace tedavis::host_sim
