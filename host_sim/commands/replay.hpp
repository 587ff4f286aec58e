/// `tedavis replay X.log`: plays a recorded bus through the core and writes frames, records and a report.
#pragma once

#include "host_sim/console.hpp"
#include "host_sim/options/replay_options.hpp"

namespace tedavis::host_sim {

/// Runs the replay and returns the exit code; throws UserError.
[[nodiscard]] int run_replay(const ReplayOptions& options, Console& console);

}  // namespace tedavis::host_sim
