/// How long a piece of work will still take, in words.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// "1 h 05 min left", "12 min left", "40 s left", at the pace so far; empty in the first two seconds and where nothing is
/// done yet. `share_done`: 0 to 1.
[[nodiscard]] std::string time_left(double elapsed_s, double share_done);

}  // namespace tedavis::host_sim
