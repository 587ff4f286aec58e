#include "render_core/terrain/part_cache.hpp"

namespace tedavis::terrain {
namespace {

constexpr std::size_t kSlotAlignment = 64;

std::size_t slot_stride(std::size_t bytes) { return (bytes + kSlotAlignment - 1) / kSlotAlignment * kSlotAlignment; }

}  // namespace

std::uint64_t PartCache::record_bytes(const PartCacheSettings& settings) {
    const std::uint64_t lists = settings.mode == ArrivalMode::exact ? settings.window_frames + 1 : 0;
    return settings.slots * (sizeof(Slot) + lists * sizeof(std::uint64_t)) + 2 * KeyMap::bytes_needed(settings.slots) + 64;
}

std::uint64_t PartCache::part_bytes(const PartCacheSettings& settings) {
    return std::uint64_t{settings.slots} * slot_stride(settings.slot_bytes) + kSlotAlignment;
}

bool PartCache::start(const TerrainDatabase& database, base::AsyncReader& reader, const PartCacheSettings& settings,
                      base::Arena& records, base::Arena& parts) {
    TEDAVIS_CHECK(settings.arrival_frames >= 1 && settings.arrival_frames <= settings.window_frames &&
                  settings.window_frames <= kMaxWindowFrames);
    if (settings.slots == 0 || settings.slots >= kNoSlot || settings.first_ticket + settings.slots > reader.capacity())
        return false;
    database_ = &database;
    reader_ = &reader;
    settings_ = settings;
    settings_.slot_bytes = slot_stride(settings.slot_bytes);
    slots_ = records.allocate_array<Slot>(settings.slots);
    const std::size_t bytes = settings.slots * settings_.slot_bytes;
    auto* memory = static_cast<std::uint8_t*>(parts.allocate(bytes, kSlotAlignment));
    if (slots_.empty() || memory == nullptr || !slot_of_key_.start(records, settings.slots) ||
        !claims_.start(records, settings.slots))
        return false;
    parts_ = {memory, bytes};
    use_.capacity = settings.slots;
    return settings.mode == ArrivalMode::live || start_history(records);
}

bool PartCache::start_history(base::Arena& records) {
    for (std::uint32_t n = 0; n <= settings_.window_frames; ++n) {
        history_[n].keys = records.allocate_array<std::uint64_t>(settings_.slots);
        if (history_[n].keys.empty()) return false;
    }
    return true;
}

TdbFailure PartCache::pin(const WantedChunk& chunk) {
    if (pinned_ + 1 >= slots_.size()) return {TdbError::too_many_roots, 0};
    Slot& slot = slots_[pinned_];
    slot.entry = *chunk.entry;
    slot.key = chunk.key.packed();
    slot.pinned = true;
    const PartPlace& place = slot.entry.*settings_.part;
    if (place.bytes > settings_.slot_bytes) return {TdbError::directory_damaged, place.offset};
    if (const TdbFailure failure = database_->read_part(place, bytes_of(pinned_)); failure.error != TdbError::none)
        return failure;
    if (!content_holds(pinned_)) return {TdbError::chunk_damaged, place.offset};
    slot.state = State::ready;
    slot.generation = 1;
    TEDAVIS_CHECK(slot_of_key_.insert(slot.key, pinned_));
    ++pinned_;
    use_.take(1);
    return {};
}

base::Span<std::uint8_t> PartCache::bytes_of(std::uint32_t slot) const {
    return parts_.subspan(slot * settings_.slot_bytes, settings_.slot_bytes);
}

base::Span<const std::uint8_t> PartCache::bytes(SlotIndex slot) const { return bytes_of(slot); }

bool PartCache::content_holds(std::uint32_t slot) const {
    return settings_.holds == nullptr || settings_.holds(database_->lattice(), slots_[slot].entry, bytes_of(slot));
}

bool PartCache::needs_slot(const WantedChunk& chunk) const {
    const std::uint32_t bytes = (chunk.entry->*settings_.part).bytes;
    if (bytes == 0 || bytes > settings_.slot_bytes) return false;
    const std::uint32_t slot = slot_of_key_.find(chunk.key.packed());
    return slot == KeyMap::kNone || slot >= pinned_;
}

bool PartCache::is_available(const Slot& slot) const {
    return slot.state == State::ready &&
           (slot.pinned || settings_.mode == ArrivalMode::live || slot.age >= settings_.arrival_frames);
}

SlotIndex PartCache::slot_of(const ChunkKey& key) const {
    if (slots_.empty()) return kNoSlot;
    const std::uint32_t slot = slot_of_key_.find(key.packed());
    return slot != KeyMap::kNone && is_available(slots_[slot]) ? static_cast<SlotIndex>(slot) : kNoSlot;
}

void PartCache::begin_frame() {
    ++frame_;
    late_ = 0;
    if (settings_.mode == ArrivalMode::exact) {
        History& list = history_[frame_ % (settings_.window_frames + 1)];
        list.count = 0;
        list.frame = frame_;
        return;
    }
    for (std::uint32_t n = pinned_; n < slots_.size() && in_flight_ > 0; ++n) {
        fetch(n, false);
        if (slots_[n].state == State::loading && frame_ - slots_[n].asked > settings_.late_frames) ++late_;
    }
}

void PartCache::want(base::Span<const WantedChunk> chunks) {
    if (settings_.mode == ArrivalMode::exact)
        want_exactly(chunks);
    else
        want_live(chunks);
    count_missing(chunks);
}

void PartCache::want_exactly(base::Span<const WantedChunk> chunks) {
    claims_.clear();
    claim(chunks);
    claim_for_past_frames();
    for (std::uint32_t n = pinned_; n < slots_.size(); ++n)
        if (slots_[n].key != 0 && claims_.find(slots_[n].key) == KeyMap::kNone) release(n);
    // What only past frames wanted has its slot already: its place among the claims can only have fallen since then.
    std::uint32_t free = pinned_;
    for (const WantedChunk& chunk : chunks) {
        if (!needs_slot(chunk) || claims_.find(chunk.key.packed()) == KeyMap::kNone) continue;
        std::uint32_t slot = slot_of_key_.find(chunk.key.packed());
        if (slot == KeyMap::kNone) {
            while (slots_[free].key != 0) ++free;
            slot = take(free, chunk);
        }
        ask_where_due(slot);
    }
    for (std::uint32_t n = pinned_; n < slots_.size(); ++n) {
        if (slots_[n].key == 0) continue;
        slots_[n].age = claims_.find(slots_[n].key);
        if (slots_[n].age >= settings_.arrival_frames) fetch(n, true);
    }
}

/// This frame's list, as far as there are slots; the claims say how many frames ago a part was first wanted.
void PartCache::claim(base::Span<const WantedChunk> chunks) {
    History& list = history_[frame_ % (settings_.window_frames + 1)];
    for (const WantedChunk& chunk : chunks) {
        const std::uint64_t key = chunk.key.packed();
        if (claims_.size() + pinned_ == slots_.size()) return;
        if (!needs_slot(chunk) || claims_.find(key) != KeyMap::kNone) continue;
        TEDAVIS_CHECK(claims_.insert(key, 0));
        list.keys[list.count++] = key;
    }
}

void PartCache::claim_for_past_frames() {
    for (std::uint32_t age = 1; age <= settings_.window_frames && age < frame_; ++age) {
        const History& list = history_[(frame_ - age) % (settings_.window_frames + 1)];
        if (list.frame != frame_ - age) continue;
        for (std::uint32_t n = 0; n < list.count; ++n) {
            if (claims_.find(list.keys[n]) != KeyMap::kNone)
                claims_.change(list.keys[n], age);
            else if (claims_.size() + pinned_ < slots_.size())
                TEDAVIS_CHECK(claims_.insert(list.keys[n], age));
        }
    }
}

void PartCache::want_live(base::Span<const WantedChunk> chunks) {
    // First all that are here, so that none of them makes room for another.
    std::size_t room = slots_.size() - pinned_, considered = 0;
    for (; considered < chunks.size() && room > 0; ++considered) {
        if (!needs_slot(chunks[considered])) continue;
        --room;
        const std::uint32_t slot = slot_of_key_.find(chunks[considered].key.packed());
        if (slot != KeyMap::kNone) slots_[slot].wanted = frame_;
    }
    for (std::size_t n = 0; n < considered && in_flight_ < settings_.max_in_flight; ++n) {
        if (!needs_slot(chunks[n])) continue;
        std::uint32_t slot = slot_of_key_.find(chunks[n].key.packed());
        if (slot == KeyMap::kNone) {
            const std::uint32_t oldest = oldest_unwanted();
            if (oldest == KeyMap::kNone) return;
            slot = take(oldest, chunks[n]);
        }
        ask_where_due(slot);
    }
}

/// Free, or not wanted for longest and not being read; KeyMap::kNone when there is none.
std::uint32_t PartCache::oldest_unwanted() const {
    std::uint32_t oldest = KeyMap::kNone;
    for (std::uint32_t n = pinned_; n < slots_.size(); ++n) {
        const Slot& slot = slots_[n];
        if (slot.key == 0) return n;
        if (slot.state == State::loading || slot.wanted == frame_) continue;
        if (oldest == KeyMap::kNone || slot.wanted < slots_[oldest].wanted) oldest = n;
    }
    return oldest;
}

std::uint32_t PartCache::take(std::uint32_t slot, const WantedChunk& chunk) {
    if (slots_[slot].key != 0) release(slot);
    Slot& record = slots_[slot];
    record.entry = *chunk.entry;
    record.key = chunk.key.packed();
    record.wanted = frame_;
    record.state = State::empty;
    TEDAVIS_CHECK(slot_of_key_.insert(record.key, slot));
    use_.take(1);
    return slot;
}

void PartCache::release(std::uint32_t slot) {
    Slot& record = slots_[slot];
    if (record.state == State::loading) fetch(slot, true);  // the reader still writes there
    slot_of_key_.erase(record.key);
    record.key = 0;
    record.state = State::empty;
    --use_.in_use;
}

void PartCache::ask_where_due(std::uint32_t slot) {
    Slot& record = slots_[slot];
    if (record.state == State::loading || record.state == State::ready) return;
    if (record.state == State::failed && frame_ < record.retry) return;
    const PartPlace& place = record.entry.*settings_.part;
    if (reader_->submit(settings_.first_ticket + slot, place.offset, bytes_of(slot).data(), place.bytes)) {
        record.state = State::loading;
        record.asked = frame_;
        ++in_flight_;
        return;
    }
    // A full queue: replay does not depend on it, a live display asks again.
    record.state = State::empty;
    if (settings_.mode == ArrivalMode::exact) {
        const TdbError error = database_->read_part(place, bytes_of(slot)).error;
        conclude(slot, error == TdbError::none && !content_holds(slot) ? TdbError::chunk_damaged : error);
    }
}

void PartCache::fetch(std::uint32_t slot, bool waiting) {
    Slot& record = slots_[slot];
    if (record.state != State::loading) return;
    const std::uint32_t ticket = settings_.first_ticket + slot;
    const base::ReadState state = waiting ? reader_->wait(ticket) : reader_->poll(ticket);
    if (state == base::ReadState::pending) return;
    --in_flight_;
    TdbError error = TdbError::unreadable;
    if (state == base::ReadState::done) {
        error = TerrainDatabase::check_part(record.entry.*settings_.part, bytes_of(slot)).error;
        if (error == TdbError::none && !content_holds(slot)) error = TdbError::chunk_damaged;
    }
    conclude(slot, error);
}

void PartCache::conclude(std::uint32_t slot, TdbError error) {
    Slot& record = slots_[slot];
    if (error == TdbError::none) {
        record.state = State::ready;
        ++record.generation;
        return;
    }
    record.state = State::failed;
    record.retry = frame_ + settings_.retry_frames;
    ++failures_;
    last_failure_ = {error, (record.entry.*settings_.part).offset};
}

void PartCache::count_missing(base::Span<const WantedChunk> chunks) {
    pending_ = failing_ = 0;
    for (const WantedChunk& chunk : chunks) {
        if (!needs_slot(chunk) || slot_of(chunk.key) != kNoSlot) continue;
        ++pending_;
        const std::uint32_t slot = slot_of_key_.find(chunk.key.packed());
        if (slot != KeyMap::kNone && slots_[slot].state == State::failed) ++failing_;
    }
}

}  // namespace tedavis::terrain
