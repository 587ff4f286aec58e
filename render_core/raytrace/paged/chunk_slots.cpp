#include "render_core/raytrace/paged/chunk_slots.hpp"

#include <algorithm>

namespace tedavis::raytrace {

template <class Height>
std::uint64_t ChunkSlots<Height>::bytes_needed(std::uint32_t slots, std::uint32_t chunks) {
    const std::uint64_t each =
        sizeof(Slot) + kSide * kSide * sizeof(Height) + 2 * (HeightMipmap<Height>::bytes_needed(kSide, kSide) + 16);
    return slots * each + std::uint64_t{chunks} * sizeof(std::uint32_t) + 64;
}

template <class Height>
bool ChunkSlots<Height>::start(std::uint32_t slots, std::uint32_t chunks, base::Arena& arena) {
    TEDAVIS_CHECK(slots > 0);
    slots_ = arena.allocate_array<Slot>(slots);
    slot_of_ = arena.allocate_array<std::uint32_t>(chunks);
    if (slots_.empty() || slot_of_.empty()) return false;
    std::fill(slot_of_.begin(), slot_of_.end(), kNone);
    for (Slot& slot : slots_) {
        const base::Span<Height> posts = arena.allocate_array<Height>(std::size_t{kSide} * kSide);
        if (posts.empty()) return false;
        slot = {kNone, kNone, kNone, posts.data(), HeightMipmap<Height>(), HeightMipmap<Height>(HeightBound::minimum)};
        const HeightGrid<Height> grid{posts.data(), kSide, kSide, kSide};
        if (!slot.maxima.start(grid, arena) || !slot.minima.start(grid, arena)) return false;
    }
    in_use_ = 0;
    newest_ = oldest_ = kNone;
    return true;
}

template <class Height>
void ChunkSlots<Height>::unlink(std::uint32_t slot) {
    const Slot& s = slots_[slot];
    (s.newer == kNone ? newest_ : slots_[s.newer].older) = s.older;
    (s.older == kNone ? oldest_ : slots_[s.older].newer) = s.newer;
}

template <class Height>
void ChunkSlots<Height>::link_as_newest(std::uint32_t slot) {
    slots_[slot].newer = kNone;
    slots_[slot].older = newest_;
    (newest_ == kNone ? oldest_ : slots_[newest_].newer) = slot;
    newest_ = slot;
}

template <class Height>
typename ChunkSlots<Height>::Taken ChunkSlots<Height>::take(std::uint32_t chunk) {
    std::uint32_t slot = slot_of_[chunk];
    const bool is_there = slot != kNone;
    if (is_there) {
        unlink(slot);
    } else if (in_use_ < size()) {
        slot = in_use_++;
    } else {
        slot = oldest_;
        unlink(slot);
        slot_of_[slots_[slot].chunk] = kNone;
    }
    link_as_newest(slot);
    slots_[slot].chunk = chunk;
    slot_of_[chunk] = slot;
    return {slot, !is_there};
}

template <class Height>
bool ChunkSlots<Height>::fill(std::uint32_t slot, ChunkHeights<Height>& heights, const ChunkBounds<Height>& bounds,
                              std::uint32_t desk) {
    Slot& s = slots_[slot];
    const base::Span<Height> posts(s.posts, std::size_t{kSide} * kSide);
    const std::uint32_t across = heights.chunk_columns();
    bool is_sound = heights.load(s.chunk % across, s.chunk / across, desk, posts);
    const Height lowest = bounds.lowest(s.chunk), highest = bounds.highest(s.chunk);
    for (const Height post : posts)  // what is not a number fails as well
        is_sound = is_sound && (post == HeightGrid<Height>::kVoid || (post >= lowest && post <= highest));
    if (!is_sound) std::fill(posts.begin(), posts.end(), HeightGrid<Height>::kVoid);
    base::SerialWorkers alone;
    s.maxima.build(alone);
    s.minima.build(alone);
    return is_sound;
}

template class ChunkSlots<std::int16_t>;
template class ChunkSlots<float>;

}  // namespace tedavis::raytrace
