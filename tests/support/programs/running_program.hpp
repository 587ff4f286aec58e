/// Runs a program as a user does and keeps what it said: exit code, both streams, and what a signal in mid-work does.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tedavis::test_support {

struct ProgramResult {
    int code = -1;      ///< exit code; -1 when a signal ended it
    int signal = 0;     ///< the signal that ended it, 0 for none
    bool hung = false;  ///< it was still running after the time limit and was killed
    std::string out, err;
};

struct ProgramSetting {
    bool terminal = false;           ///< stderr is a terminal
    std::uint64_t largest_file = 0;  ///< bytes a file may reach before writing fails, as on a full disk; 0: no limit
    /// Asked about every 10 ms; the first time it holds, `signal` is sent. Empty: never.
    std::function<bool()> signal_when;
    int signal = 0;
    double limit_s = 120;
};

/// `words[0]` is the program's path.
[[nodiscard]] ProgramResult run_program(const std::vector<std::string>& words, const ProgramSetting& setting = {});

}  // namespace tedavis::test_support
