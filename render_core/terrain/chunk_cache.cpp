#include "render_core/terrain/chunk_cache.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::size_t kSlotBytes = (kMaxChunkVertices * sizeof(ChunkVertex) + kLeafPostBytes + 63) / 64 * 64;

}  // namespace

std::uint64_t ChunkCache::bytes_needed(std::uint32_t slots, std::uint32_t chunks) {
    return std::uint64_t{slots} * (kSlotBytes + sizeof(Slot)) + std::uint64_t{chunks} * sizeof(SlotIndex) + 256;
}

bool ChunkCache::start(const TerrainDatabase& database, std::uint32_t slots, base::Arena& records, base::Arena& payloads) {
    if (slots == 0 || slots >= kNoSlot) return false;
    database_ = &database;
    slots_ = records.allocate_array<Slot>(slots);
    auto* memory = static_cast<std::uint8_t*>(payloads.allocate(slots * kSlotBytes, alignof(ChunkVertex)));
    payloads_ = memory != nullptr ? base::Span<std::uint8_t>(memory, slots * kSlotBytes) : base::Span<std::uint8_t>();
    slot_of_ = records.allocate_array<SlotIndex>(database.chunk_count());
    if (slots_.empty() || payloads_.empty() || slot_of_.empty()) return false;
    for (Slot& slot : slots_) slot = Slot{};
    for (SlotIndex& index : slot_of_) index = kNoSlot;
    use_.capacity = slots;
    return true;
}

SlotIndex ChunkCache::oldest_free(std::uint64_t frame) const {
    SlotIndex oldest = kNoSlot;
    for (std::size_t n = 0; n < slots_.size(); ++n) {
        if (slots_[n].chunk == kNoChunk) return static_cast<SlotIndex>(n);
        if (slots_[n].last_frame == frame) continue;
        if (oldest == kNoSlot || slots_[n].last_frame < slots_[oldest].last_frame) oldest = static_cast<SlotIndex>(n);
    }
    return oldest;
}

SlotIndex ChunkCache::acquire(ChunkIndex chunk, std::uint64_t frame) {
    failure_ = {};
    SlotIndex index = slot_of_[chunk];
    if (index != kNoSlot) {
        slots_[index].last_frame = frame;
        return index;
    }
    index = oldest_free(frame);
    if (index == kNoSlot) {
        ++use_.refused;
        return kNoSlot;
    }
    Slot& slot = slots_[index];
    if (slot.chunk != kNoChunk)
        slot_of_[slot.chunk] = kNoSlot;
    else
        use_.take(1);
    slot.chunk = chunk;
    slot.last_frame = frame;
    ++slot.loads;
    slot_of_[chunk] = index;
    failure_ = database_->read_chunk(chunk, payloads_.subspan(index * kSlotBytes, kSlotBytes));
    if (failure_.error == TdbError::none) return index;
    slot_of_[chunk] = kNoSlot;
    slot.chunk = kNoChunk;
    --use_.in_use;
    return kNoSlot;
}

base::Span<const ChunkVertex> ChunkCache::vertices(SlotIndex index) const {
    const std::uint8_t* payload = payloads_.data() + index * kSlotBytes;
    return {reinterpret_cast<const ChunkVertex*>(payload), database_->entry(slots_[index].chunk).vertex_count};
}

}  // namespace tedavis::terrain
