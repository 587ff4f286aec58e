/// Ctrl-C and SIGTERM as a flag that long loops read, so that they end with a valid partial result.
///
/// While a guard exists, the first signal sets the flag; the second one ends the program at once. A guard within another one, of
/// a step of a command that has one already, is the same guard: a signal that came before it is requested there, too. Guards are
/// made and destroyed by one thread.
#pragma once

namespace tedavis::host_sim {

class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    [[nodiscard]] bool requested() const;
};

/// To be called before a command writes anything: throws Interrupted where that was requested.
void require_uninterrupted(const InterruptGuard& interrupt);

}  // namespace tedavis::host_sim
