/// The chapter of the report on effects that were left out because they would be invisible, and the same as lines of text.
#pragma once

#include <string>

#include "host_sim/accuracy/uncalled_effects.hpp"

namespace tedavis::host_sim {

/// Returns HTML: a summary in one sentence, and a table with a row for each effect.
[[nodiscard]] std::string effects_chapter(const UncalledEffects& measured);

/// Returns a line for each effect that was left out of at least one picture.
[[nodiscard]] std::string uncalled_text(const UncalledEffects& measured);

}  // namespace tedavis::host_sim
