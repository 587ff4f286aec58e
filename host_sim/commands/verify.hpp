/// `tedavis verify SCRIPT.toml… [--set name=value] [--junit F.xml] [-o DIR]`: flies flight tests on the desk; with `--target
/// SOCKET
/// --board BOARD.toml [--interface can0] [--panel-lines DIR] [--strict]` against a running display (verify_board.hpp).
#pragma once

#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct VerifyOptions {
    std::vector<std::string> scripts;     ///< files, shipped names, and folders, which stand for the scripts directly in them
    std::vector<std::string> parameters;  ///< "name=value"
    std::string junit;                    ///< file; empty: none
    std::string output;                   ///< folder for pictures and records of failures; empty: none are written
    std::string target;                   ///< record socket of a running display; empty: on the desk
    std::string board;                    ///< that display's board file
    std::string interface_name;           ///< of the display's bus; empty: the board file's
    std::string panel_lines;              ///< folder of gpio-sim lines; empty: no switch can be thrown
    bool strict = false;                  ///< a test that was left out, or has a condition that cannot be judged, fails
};

/// Returns 0 where all expectations hold and kCheckFailedExitCode where one does not. Returns kFaultyInputExitCode, with a
/// message for each fault, where a script has faults (then no test is flown), where the input of one cannot be played, and where
/// no script can be judged on a board. Faults are written to the JSON and to the JUnit file, too, and so is what Ctrl-C ended: it
/// then returns kInterruptedExitCode. The JUnit file, the pictures and the records of an earlier run are removed first. Throws
/// UserError.
[[nodiscard]] int run_verify(const VerifyOptions& options, Console& console);

/// Returns the paths of the named scripts and of those in named folders; without names, of the shipped ones. Throws UserError.
[[nodiscard]] std::vector<std::string> script_paths(const std::vector<std::string>& named);

/// Returns the scripts of a folder in the order of their names, without those in its subfolders, which are to be included by
/// others.
[[nodiscard]] std::vector<std::string> scripts_of_folder(const std::string& folder);

}  // namespace tedavis::host_sim
