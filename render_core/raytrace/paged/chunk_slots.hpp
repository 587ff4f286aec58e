/// A cache of chunks in memory: their posts, and the bounds of levels below the chunk. The least recently used chunk is
/// replaced.
///
/// Memory  from an arena: 8 KB per slot for 16-bit heights, 16 KB for floats; 4 bytes per chunk. Thread  take() one; fill()
/// several, each for a different slot.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/paged/chunk_bounds.hpp"

namespace tedavis::raytrace {

template <class Height>
class ChunkSlots {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    struct Taken {
        std::uint32_t slot;
        bool must_be_filled;
    };

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t slots, std::uint32_t chunks);
    /// Allocates one slot or more; returns false where the arena is too small.
    [[nodiscard]] bool start(std::uint32_t slots, std::uint32_t chunks, base::Arena& arena);
    /// Returns the slot of a chunk and marks it as used. As many different chunks as there are slots can be taken before one is
    /// replaced.
    Taken take(std::uint32_t chunk);
    /// Loads a chunk into its slot. Returns false, and the chunk then has no surface, where it cannot be loaded or its heights
    /// exceed their bounds.
    bool fill(std::uint32_t slot, ChunkHeights<Height>& heights, const ChunkBounds<Height>& bounds, std::uint32_t desk);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
    [[nodiscard]] std::uint32_t in_use() const { return in_use_; }
    [[nodiscard]] const HeightMipmap<Height>& maxima(std::uint32_t slot) const { return slots_[slot].maxima; }
    [[nodiscard]] const HeightMipmap<Height>& minima(std::uint32_t slot) const { return slots_[slot].minima; }

private:
    static constexpr std::uint32_t kSide = ChunkHeights<Height>::kPosts;
    struct Slot {
        std::uint32_t chunk, newer, older;
        Height* posts;
        HeightMipmap<Height> maxima, minima;
    };
    void unlink(std::uint32_t slot);
    void link_as_newest(std::uint32_t slot);

    base::Span<Slot> slots_;
    base::Span<std::uint32_t> slot_of_;  ///< slot by chunk number
    std::uint32_t in_use_ = 0, newest_ = kNone, oldest_ = kNone;
};

}  // namespace tedavis::raytrace
