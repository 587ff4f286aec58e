/// `tedavis record LOG -o SCRIPT.toml`: plays a flight and writes a flight test that expects what it shows today, to be edited.
#pragma once

#include "host_sim/commands/record_input.hpp"
#include "host_sim/console.hpp"

namespace tedavis::host_sim {

/// Returns 0. Throws UserError, also where the script, or the log of a running display, exists and `options.yes` is false, and
/// Interrupted; then nothing is written.
[[nodiscard]] int run_record(const RecordOptions& options, Console& console);

}  // namespace tedavis::host_sim
