/// Exceptions that end a command early, with one sentence that states what is wrong, where, and what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace tedavis::host_sim {

/// A fault in the user's input. Exit code kFaultyInputExitCode.
class UserError : public std::runtime_error {
public:
    explicit UserError(const std::string& message) : std::runtime_error(message) {}
};

/// Exit code of a command with faulty input; also if it left a valid partial result.
inline constexpr int kFaultyInputExitCode = 2;
/// Exit code of a command that is complete, but of which a check failed.
inline constexpr int kCheckFailedExitCode = 1;

/// Exit code of a command that Ctrl-C or SIGTERM ended early, as usual for shells.
inline constexpr int kInterruptedExitCode = 130;

/// The user stopped the command before it had a result worth keeping. Exit code kInterruptedExitCode.
class Interrupted : public std::runtime_error {
public:
    explicit Interrupted(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace tedavis::host_sim
