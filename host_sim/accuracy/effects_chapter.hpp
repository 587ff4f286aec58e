/// The chapter of the report on effects that the scene did not call for, and the same as lines of text.
#pragma once

#include <string>

#include "host_sim/accuracy/uncalled_effects.hpp"

namespace tedavis::host_sim {

/// HTML: a sentence that sums up, and a table with a row for each effect.
[[nodiscard]] std::string effects_chapter(const UncalledEffects& measured);

/// A line for each effect that at least one picture went without.
[[nodiscard]] std::string uncalled_text(const UncalledEffects& measured);

}  // namespace tedavis::host_sim
