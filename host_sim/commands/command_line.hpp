/// The command line of `tedavis`: parses it, runs the command, turns faults into exit codes.
#pragma once

#include <iosfwd>

namespace tedavis::host_sim {

/// 0 done, 1 a check did not hold, 2 wrong usage or input (one sentence on `notes`). `live`: notes is a terminal.
[[nodiscard]] int run_command_line(int argc, const char* const* argv, std::ostream& results, std::ostream& notes, bool live);

}  // namespace tedavis::host_sim
