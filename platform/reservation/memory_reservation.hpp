/// The one block of memory that the runtime uses after start, mapped from the system.
///
/// Memory  mapped once, zero-filled, page-aligned. Lifetime  it must outlive its arenas.
#pragma once

#include <cstdint>

#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// `touched` maps all pages at once, so that no page fault occurs in flight; `lazy` maps them at first use.
enum class Residency : std::uint8_t { lazy, touched };

class MemoryReservation {
public:
    MemoryReservation() = default;
    ~MemoryReservation();
    MemoryReservation(MemoryReservation&& other) noexcept;
    MemoryReservation& operator=(MemoryReservation&& other) noexcept;

    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
    /// Returns an empty arena over the whole block; two such arenas overlap.
    [[nodiscard]] base::Arena arena() const { return {block_, static_cast<std::size_t>(bytes_)}; }

private:
    friend base::Result<MemoryReservation, base::Error> reserve_memory(std::uint64_t, Residency);
    void* block_ = nullptr;
    std::uint64_t bytes_ = 0;
};

/// Reserves `bytes`, at least one.
[[nodiscard]] base::Result<MemoryReservation, base::Error> reserve_memory(std::uint64_t bytes, Residency residency);

}  // namespace tedavis::platform
