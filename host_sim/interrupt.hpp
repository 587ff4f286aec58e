/// Ctrl-C and SIGTERM as a question that long loops ask, so that they leave a valid partial result.
///
/// While a guard lives, the first signal only sets the flag; the second one ends the program at once. One guard at a time.
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
