/// The program `tedavis-display`, from the command line to the exit code.
#pragma once

#include <cstdio>

namespace tedavis::target {

/// `arguments` are those after the program's name; results go to `out`, faults and events to stderr. Returns 0 on success, 1
/// when a check failed or the display was lost, 2 for wrong usage or input, 130 when a calibration was stopped.
[[nodiscard]] int run_board_program(int count, const char* const* arguments, std::FILE* out);

}  // namespace tedavis::target
