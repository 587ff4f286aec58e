/// The program `tedavis-display`: command line to exit code.
#pragma once

#include <cstdio>

namespace tedavis::target {

/// `arguments` behind the program's name; results go to `out`, faults and events to stderr. Returns 0 done, 1 a check did
/// not hold or the display was lost, 2 wrong usage or input.
[[nodiscard]] int run_board_program(int count, const char* const* arguments, std::FILE* out);

}  // namespace tedavis::target
