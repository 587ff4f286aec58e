/// SIGINT and SIGTERM as a flag that the run loop reads.
///
/// While an object exists, the first signal sets the flag and interrupts a sleep; the second one ends the program at once. Only
/// one object may exist at a time. Memory  none.
#pragma once

#include <signal.h>

namespace tedavis::target {

class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    [[nodiscard]] bool requested() const;

private:
    struct sigaction previous_interrupt_ {};
    struct sigaction previous_terminate_ {};
};

}  // namespace tedavis::target
