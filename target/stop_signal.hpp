/// SIGINT and SIGTERM as a question that the run loop asks.
///
/// While one lives, the first signal only sets the flag and wakes a sleep; the second one ends the program at once. One
/// at a time. Memory  none.
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
