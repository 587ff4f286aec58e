#include "platform/reservation/memory_reservation.hpp"

#include <sys/mman.h>

#include <cstddef>
#include <cstdio>
#include <limits>
#include <utility>

namespace tedavis::platform {

MemoryReservation::~MemoryReservation() {
    if (block_ != nullptr) ::munmap(block_, static_cast<std::size_t>(bytes_));
}

MemoryReservation::MemoryReservation(MemoryReservation&& other) noexcept { *this = std::move(other); }

MemoryReservation& MemoryReservation::operator=(MemoryReservation&& other) noexcept {
    std::swap(block_, other.block_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

base::Result<MemoryReservation, base::Error> reserve_memory(std::uint64_t bytes, Residency residency) {
    char number[24];
    std::snprintf(number, sizeof number, "%llu", static_cast<unsigned long long>(bytes));
    const base::Error refusal =
        base::make_error("the machine gives no block of ", number, " bytes; lower the device file's cpu budget lines");
    if (bytes == 0 || bytes > std::numeric_limits<std::size_t>::max()) return base::fail(refusal);
    const int flags = MAP_PRIVATE | MAP_ANONYMOUS | (residency == Residency::touched ? MAP_POPULATE : 0);
    void* block = ::mmap(nullptr, static_cast<std::size_t>(bytes), PROT_READ | PROT_WRITE, flags, -1, 0);
    if (block == MAP_FAILED) return base::fail(refusal);
    MemoryReservation reservation;
    reservation.block_ = block;
    reservation.bytes_ = bytes;
    return reservation;
}

}  // namespace tedavis::platform
