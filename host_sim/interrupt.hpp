/// Ctrl-C and SIGTERM as a flag that long loops read, so that they end with a valid partial result.
///
/// While a guard exists, the first signal sets the flag; the second one ends the program at once. Only one guard may exist at a
/// time.
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

}  // namespace tedavis::host_sim
