/// A fixed number of chunk slots in memory. The least recently used slot that this frame does not need makes room.
///
/// What is drawn never depends on what was cached before: a wanted chunk is read before it is drawn.
/// Memory  all from the arenas at start(). Thread  one.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

using SlotIndex = std::uint16_t;
inline constexpr SlotIndex kNoSlot = 0xFFFF;

class ChunkCache {
public:
    struct Slot {
        ChunkIndex chunk = kNoChunk;
        std::uint64_t last_frame = 0;
        std::uint64_t loads = 0;  ///< counts fillings, so that a drawer knows when to upload again
    };

    /// `records` holds a record a slot and the slot of every chunk, `payloads` what the slots hold; both may be one arena.
    /// False when `slots` do not fit (or exceed 65534).
    [[nodiscard]] bool start(const TerrainDatabase& database, std::uint32_t slots, base::Arena& records, base::Arena& payloads);

    /// The slot of a chunk for this frame, read when it is not there. kNoSlot when all slots are needed by this frame
    /// or the chunk is damaged (`failure()` says which).
    [[nodiscard]] SlotIndex acquire(ChunkIndex chunk, std::uint64_t frame);

    [[nodiscard]] const Slot& slot(SlotIndex index) const { return slots_[index]; }
    [[nodiscard]] base::Span<const ChunkVertex> vertices(SlotIndex index) const;
    [[nodiscard]] const TdbFailure& failure() const { return failure_; }
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }
    /// Of both together.
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t slots, std::uint32_t chunks);

private:
    [[nodiscard]] SlotIndex oldest_free(std::uint64_t frame) const;

    const TerrainDatabase* database_ = nullptr;
    base::Span<Slot> slots_;
    base::Span<std::uint8_t> payloads_;
    base::Span<SlotIndex> slot_of_;
    TdbFailure failure_;
    base::ResourceUse use_;
};

}  // namespace tedavis::terrain
