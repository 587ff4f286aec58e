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
    bool strict = false;                  ///< what cannot be judged has not passed
};

/// Returns 0 where all expectations hold, kCheckFailedExitCode where one does not, and kFaultyInputExitCode, with a sentence for
/// each fault, before anything is flown where a script is faulty; also where the input of one cannot be played, and where on a
/// board none of the scripts can be judged. Faults are in the JSON and in the JUnit file, too. The JUnit file, the pictures and
/// the records of an earlier run are removed first. Throws UserError and Interrupted.
[[nodiscard]] int run_verify(const VerifyOptions& options, Console& console);

/// The scripts that are named, folders as what lies in them, or the shipped ones. Throws UserError.
[[nodiscard]] std::vector<std::string> script_paths(const std::vector<std::string>& named);

/// Scripts of a folder, in the order of their names; those of its folders, which are there to be included, are left out.
[[nodiscard]] std::vector<std::string> scripts_of_folder(const std::string& folder);

}  // namespace tedavis::host_sim
