/// Memory of a display, given back for the next display of the same size and not to the system: the display fills its memory with
/// zeros when it starts, and pages that the system must hand out for that take most of the time of a test that draws a frame.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "platform/reservation/memory_reservation.hpp"

namespace tedavis::test_support {

/// Tests of one process start their displays in one thread.
class KeptReservation {
public:
    explicit KeptReservation(std::uint64_t bytes) {
        std::vector<platform::MemoryReservation>& free = free_of(bytes);
        if (free.empty()) {
            held_ = std::move(platform::reserve_memory(bytes, platform::Residency::lazy).value());
        } else {
            held_ = std::move(free.back());
            free.pop_back();
        }
    }
    ~KeptReservation() { free_of(held_.bytes()).push_back(std::move(held_)); }
    KeptReservation(const KeptReservation&) = delete;
    KeptReservation& operator=(const KeptReservation&) = delete;

    [[nodiscard]] base::Arena arena() const { return held_.arena(); }

private:
    static std::vector<platform::MemoryReservation>& free_of(std::uint64_t bytes) {
        static std::map<std::uint64_t, std::vector<platform::MemoryReservation>> free;
        return free[bytes];
    }

    platform::MemoryReservation held_;
};

}  // namespace tedavis::test_support
