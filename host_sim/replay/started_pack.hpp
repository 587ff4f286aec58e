/// Checks the pack from which a replay was started, once its files are open.
#pragma once

#include <string>

#include "platform/configuration/pack_check.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Throws UserError where a file of the pack was written or replaced since it was checked. Returns one sentence where the pack is
/// out of date, or not valid yet, on the day of the flight; else an empty text, as for a log whose stamps are no dates (before
/// 1990), and where there is no pack.
[[nodiscard]] std::string words_of_started(const platform::CheckedPack& pack, base::Time flight);

}  // namespace tedavis::host_sim
