/// `tedavis sheet trace`: cost and quality of the ray tracer's presets and operators.
#pragma once

#include "host_sim/commands/sheet.hpp"
#include "host_sim/console.hpp"

namespace tedavis::host_sim {

inline constexpr const char* kTraceSheetName = "trace";

/// Writes the files of run_sheet(). Uses the options terrain, size, pose, time and the folder; refuses others. Returns the exit
/// code; throws UserError and Interrupted.
[[nodiscard]] int run_trace_sheet(const SheetOptions& options, Console& console);

}  // namespace tedavis::host_sim
