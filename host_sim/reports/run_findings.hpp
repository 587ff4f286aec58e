/// Findings: problems of an input or a run that could be read or drawn completely. Commands print findings as warnings, write
/// them with their result, and with --strict end with kCheckFailedExitCode where there is one.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct Finding {
    std::string name;  ///< stable, for scripts: "terrain.outside"
    std::string text;  ///< a sentence with numbers, without its full stop
    std::uint64_t count = 1;
};
using Findings = std::vector<Finding>;

void append(Findings& findings, const Findings& more);

/// [{`name`, `text`, `count`}].
[[nodiscard]] nlohmann::ordered_json findings_json(const Findings& findings);

/// Prints a line "warning: ..." for each finding.
void print_warnings(const Findings& findings, Console& console);

/// Returns the exit code of a command that has otherwise succeeded: kCheckFailedExitCode where it is strict and there are
/// findings, else 0.
[[nodiscard]] int exit_code_of(const Findings& findings, bool is_strict);

/// "1 frame", "3 frames".
[[nodiscard]] std::string counted(std::uint64_t count, const std::string& what);
/// "1 of 5", "all 5".
[[nodiscard]] std::string part_of(std::uint64_t count, std::uint64_t all);
/// "40 min", "3.5 h", "74 d".
[[nodiscard]] std::string age_words(double seconds);

}  // namespace tedavis::host_sim
