/// What a selection of chunks needs to know about a database: entries, and which chunks are in memory.
#pragma once

#include <cstdint>

#include "render_core/terrain/chunk_key.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::terrain {

/// A place of a fixed number of places for payloads or attribute pages.
using SlotIndex = std::uint16_t;
inline constexpr SlotIndex kNoSlot = 0xFFFF;

enum class EntryState : std::uint8_t {
    present,
    absent,   ///< the database has no such chunk
    missing,  ///< it may have one; its directory page is not in memory (yet)
};

struct FoundEntry {
    const ChunkEntry* entry = nullptr;  ///< only when present; valid until the next frame begins
    EntryState state = EntryState::absent;
};

class ChunkCatalogue {
public:
    virtual ~ChunkCatalogue() = default;
    [[nodiscard]] virtual const Lattice& lattice() const = 0;
    /// Asking for an entry that is missing may order its page.
    [[nodiscard]] virtual FoundEntry find(const ChunkKey& key) = 0;
    /// The slot that holds the chunk's payload and may be drawn in this frame; kNoSlot otherwise.
    [[nodiscard]] virtual SlotIndex available_slot(const ChunkKey& key) const = 0;
};

}  // namespace tedavis::terrain
