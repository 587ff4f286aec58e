/// Places in memory for chunks: posts and the bounds below the chunk. Those used longest ago make room for others.
///
/// Memory  from an arena: 8 KB a slot of 16-bit heights, 16 KB of floats; 4 bytes a chunk. Thread  take() one; fill() several,
/// each another slot.
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
    /// One slot or more. False where the arena has no room.
    [[nodiscard]] bool start(std::uint32_t slots, std::uint32_t chunks, base::Arena& arena);
    /// The slot of a chunk, which counts as used now. As many different chunks as there are slots can be used in a row.
    Taken take(std::uint32_t chunk);
    /// What the source says of it. A chunk that it cannot load, or whose heights are beyond their bounds, has no surface: false.
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
    base::Span<std::uint32_t> slot_of_;  ///< by chunk
    std::uint32_t in_use_ = 0, newest_ = kNone, oldest_ = kNone;
};

}  // namespace tedavis::raytrace
