/// Port: what the selection of chunks needs from a database: directory entries, and which chunks are in memory.
#pragma once

#include <cstdint>

#include "render_core/terrain/chunk_key.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::terrain {

/// Index of one of a fixed number of slots for payloads or attribute pages.
using SlotIndex = std::uint16_t;
inline constexpr SlotIndex kNoSlot = 0xFFFF;

enum class EntryState : std::uint8_t {
    present,
    absent,   ///< the database has no such chunk
    missing,  ///< unknown: the chunk's directory page is not in memory yet
};

struct FoundEntry {
    const ChunkEntry* entry = nullptr;  ///< only when present; valid until the next frame begins
    EntryState state = EntryState::absent;
};

class ChunkCatalogue {
public:
    virtual ~ChunkCatalogue() = default;
    [[nodiscard]] virtual const Lattice& lattice() const = 0;
    /// Returns the chunk's entry; where it is missing, the call may request its directory page.
    [[nodiscard]] virtual FoundEntry find(const ChunkKey& key) = 0;
    /// Returns the slot of the chunk's payload if it may be drawn in this frame, else kNoSlot.
    [[nodiscard]] virtual SlotIndex available_slot(const ChunkKey& key) const = 0;
};

}  // namespace tedavis::terrain
