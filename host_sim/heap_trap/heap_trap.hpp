/// Counts heap allocations of the watched threads while it lives: ours apart from those inside drivers.
///
/// It shows for every replay, and to the tests, that the core takes no memory after its start. Linked into a program, it
/// replaces the C library's entry points by ones that count and pass on.
///
/// Every malloc-like call of the process goes through the trap (operator new as well); under a sanitizer through its hook.
/// A thread counts when it is watched: the one that made the trap, and threads that called `watch_this_thread`.
/// Allocations below a base::DriverScope are the driver's. One trap at a time.
#pragma once

#include <cstdint>
#include <string>

namespace tedavis::host_sim {

struct HeapCounts {
    std::uint64_t ours = 0;
    std::uint64_t driver = 0;
};

class HeapTrap {
public:
    HeapTrap();
    ~HeapTrap();
    HeapTrap(const HeapTrap&) = delete;
    HeapTrap& operator=(const HeapTrap&) = delete;

    [[nodiscard]] HeapCounts counts() const;
    /// Who made the first of our allocations, innermost first; empty when there was none. Read it after the trap is closed.
    [[nodiscard]] std::string first_of_ours() const;
    /// Ends the counting early, so that the counts can be compared and printed.
    void close();

    static void watch_this_thread();
};

}  // namespace tedavis::host_sim
