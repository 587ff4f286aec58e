/// What ends a command early, as exceptions: one sentence that says what, where and what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace tedavis::host_sim {

/// A fault in what the user gave. Exit code kFaultyInputExitCode.
class UserError : public std::runtime_error {
public:
    explicit UserError(const std::string& message) : std::runtime_error(message) {}
};

/// Of a command whose input turned out to be faulty; also where it left a valid partial result.
inline constexpr int kFaultyInputExitCode = 2;
/// The run is whole, but a check of it did not hold.
inline constexpr int kCheckFailedExitCode = 1;

/// Of a command that Ctrl-C or SIGTERM ended early, as shells have it.
inline constexpr int kInterruptedExitCode = 130;

/// The user stopped the command before it had a result worth keeping. Exit code kInterruptedExitCode.
class Interrupted : public std::runtime_error {
public:
    explicit Interrupted(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace tedavis::host_sim
