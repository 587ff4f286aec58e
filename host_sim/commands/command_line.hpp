/// The command line of `tedavis`: parses it, runs the command, and converts faults to exit codes.
#pragma once

#include <iosfwd>

namespace tedavis::host_sim {

/// Returns 0 on success, 1 when a check failed, 2 for wrong usage or input (one sentence on `notes`). `live`: `notes` is a
/// terminal. `answers` is the stream of the user's answers to questions; null: there is no user.
[[nodiscard]] int run_command_line(int argc, const char* const* argv, std::ostream& results, std::ostream& notes, bool live,
                                   std::istream* answers = nullptr);

}  // namespace tedavis::host_sim
