/// Counts heap allocations of the watched threads while the object exists, separately for our code and for drivers.
///
/// It shows for every replay, and in tests, that the core allocates no memory after its start. Linked into a program, it replaces
/// the C library's entry points by ones that count and call the original.
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
    /// The call stack of the first of our allocations, innermost first; empty when there was none. To be called after close().
    [[nodiscard]] std::string first_of_ours() const;
    /// Ends the counting early, so that the counts can be compared and printed.
    void close();

    static void watch_this_thread();
};

}  // namespace tedavis::host_sim
