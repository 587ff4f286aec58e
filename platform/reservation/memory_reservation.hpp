/// The one block of memory that the runtime lives in after start, straight from the system.
///
/// Memory  mapped once, zero-filled, page-aligned. Lifetime  arenas of it must not outlive it.
#pragma once

#include <cstdint>

#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// `touched` asks for the pages now, so that no page fault comes in flight; `lazy` takes them as they are used.
enum class Residency : std::uint8_t { lazy, touched };

class MemoryReservation {
public:
    MemoryReservation() = default;
    ~MemoryReservation();
    MemoryReservation(MemoryReservation&& other) noexcept;
    MemoryReservation& operator=(MemoryReservation&& other) noexcept;

    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// An empty arena over the whole block; arenas asked for twice overlap.
    [[nodiscard]] base::Arena arena() const { return {block_, static_cast<std::size_t>(bytes_)}; }

private:
    friend base::Result<MemoryReservation, base::Error> reserve_memory(std::uint64_t, Residency);
    void* block_ = nullptr;
    std::uint64_t bytes_ = 0;
};

/// At least one byte.
[[nodiscard]] base::Result<MemoryReservation, base::Error> reserve_memory(std::uint64_t bytes, Residency residency);

}  // namespace tedavis::platform
