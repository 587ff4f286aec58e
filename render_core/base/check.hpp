/// Stops the program when the code itself is wrong. Never used on input, files or hardware answers: those return a Result.
///
/// Thread    any. Memory  none. Failure  does not return.
#pragma once

namespace tedavis::base {

/// Called once with the source location of the broken invariant; must not return. The composition root may install its own
/// function (the board's writes to its event log); the default prints one line to stderr and aborts.
using FatalStop = void (*)(const char* condition, const char* file, int line);
void set_fatal_stop(FatalStop stop) noexcept;
[[noreturn]] void fatal_stop(const char* condition, const char* file, int line) noexcept;

}  // namespace tedavis::base

/// Active in every build, so that tests run the shipped code.
#define TEDAVIS_CHECK(condition) \
    (static_cast<bool>(condition) ? static_cast<void>(0) : ::tedavis::base::fatal_stop(#condition, __FILE__, __LINE__))
