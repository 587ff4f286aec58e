/// Ctrl-C and SIGTERM as a flag that long loops read, so that they end with a valid partial result.
///
/// While a guard exists, the first signal sets the flag; the second one ends the program at once. A guard within another one is
/// the same guard: a signal that came before it is requested there, too. Guards are made and destroyed by one thread.
///
/// The command line makes one for each long command (add_long_command()) at the command's start. A function makes one of its own
/// only to query it in a loop; if it is called without a command line, as by a test, that guard is the only one.
#pragma once

#include <string>

namespace tedavis::host_sim {

class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] bool requested() const;
};

/// To be called before a command writes anything to `output`: throws Interrupted, whose message says that nothing was written,
/// where a guard exists and was requested.
void require_uninterrupted(const std::string& output);

}  // namespace tedavis::host_sim
