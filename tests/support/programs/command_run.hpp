/// Runs a command of `tedavis` inside the test and keeps what it said.
#pragma once

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "host_sim/console.hpp"

namespace tedavis::test_support {

struct CommandRun {
    int code = 0;
    std::string results, notes;

    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(results); }
};

/// `command(console)` returns the exit code; with `json`, as under --json.
template <class Command>
CommandRun run_command(Command command, bool json = false) {
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, json, false);
    const int code = command(console);
    return {code, results.str(), notes.str()};
}

}  // namespace tedavis::test_support
