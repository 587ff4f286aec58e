#include "render_core/terrain/directory_cache.hpp"

namespace tedavis::terrain {

std::uint64_t DirectoryCache::bytes_needed(std::uint32_t pages) {
    return std::uint64_t{pages} * (sizeof(DirectoryPage) + sizeof(Slot)) + KeyMap::bytes_needed(pages) + 64;
}

TdbFailure DirectoryCache::start(const TerrainDatabase& database, base::AsyncReader* reader, const DirectorySettings& settings,
                                 base::Arena& arena) {
    database_ = &database;
    reader_ = reader;
    settings_ = settings;
    pages_ = arena.allocate_array<DirectoryPage>(settings.pages);
    slots_ = arena.allocate_array<Slot>(settings.pages);
    if (pages_.empty() || slots_.empty() || !slot_of_page_.start(arena, settings.pages)) return {TdbError::too_large, 0};
    use_.capacity = settings.pages;
    return pin_top_level();
}

TdbFailure DirectoryCache::pin_top_level() {
    const Lattice& lattice = database_->lattice();
    const std::uint32_t top = database_->top_level(), first = lattice.page_index({top, 0, 0});
    const std::uint32_t count = lattice.page_columns(top) * lattice.page_rows(top);
    if (count >= settings_.pages) return {TdbError::too_large, 0};
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        const std::uint32_t page = first + slot;
        if (!database_->has_page(page)) return {TdbError::directory_damaged, database_->header().page_table_offset};
        if (const TdbFailure failure = database_->read_page(page, pages_[slot]); failure.error != TdbError::none) return failure;
        slots_[slot] = {0, 0, page, State::ready, true};
        TEDAVIS_CHECK(slot_of_page_.insert(page + std::uint64_t{1}, slot));
        use_.take(1);
    }
    return {};
}

void DirectoryCache::begin_frame() { ++frame_; }

FoundEntry DirectoryCache::find(const ChunkKey& key) {
    const Lattice& lattice = database_->lattice();
    if (!lattice.contains(key)) return {};
    const std::uint32_t page_index = lattice.page_index(key);
    if (!database_->has_page(page_index)) return {};
    const std::uint32_t slot = slot_for(page_index);
    if (slot == KeyMap::kNone) return {nullptr, EntryState::missing};
    Slot& record = slots_[slot];
    record.last_frame = frame_;
    if (record.state == State::loading) poll(slot);
    if (record.state == State::empty || (record.state == State::failed && frame_ >= record.retry_frame)) load(slot);
    if (record.state != State::ready) return {nullptr, EntryState::missing};
    const ChunkEntry& entry = pages_[slot].entries[Lattice::index_in_page(key)];
    if (entry.vertex_count == 0) return {};
    return {&entry, EntryState::present};
}

/// The page's slot, or an empty one that becomes its slot; KeyMap::kNone when this frame needs all of them.
std::uint32_t DirectoryCache::slot_for(std::uint32_t page_index) {
    const std::uint32_t known = slot_of_page_.find(page_index + std::uint64_t{1});
    if (known != KeyMap::kNone) return known;
    std::uint32_t oldest = KeyMap::kNone;
    for (std::uint32_t n = 0; n < slots_.size(); ++n) {
        const Slot& slot = slots_[n];
        if (slot.pinned || slot.state == State::loading || slot.last_frame == frame_) continue;
        if (oldest == KeyMap::kNone || slot.last_frame < slots_[oldest].last_frame) oldest = n;
    }
    if (oldest == KeyMap::kNone) {
        ++use_.refused;
        return KeyMap::kNone;
    }
    Slot& slot = slots_[oldest];
    if (slot.last_frame != 0)
        slot_of_page_.erase(slot.page_index + std::uint64_t{1});
    else
        use_.take(1);
    if (slot.state == State::failed) --failing_;
    slot = {frame_, 0, page_index, State::empty, false};
    TEDAVIS_CHECK(slot_of_page_.insert(page_index + std::uint64_t{1}, oldest));
    return oldest;
}

void DirectoryCache::load(std::uint32_t slot) {
    Slot& record = slots_[slot];
    if (record.state == State::failed) --failing_;
    record.state = State::empty;
    if (settings_.mode == ArrivalMode::exact) {
        conclude(slot, database_->read_page(record.page_index, pages_[slot]));
        return;
    }
    // A full queue leaves the slot empty: asked again in the next frame.
    if (reader_->submit(settings_.first_ticket + slot, database_->page_offset(record.page_index), &pages_[slot],
                        sizeof(DirectoryPage)))
        record.state = State::loading;
}

void DirectoryCache::poll(std::uint32_t slot) {
    const std::uint32_t page_index = slots_[slot].page_index;
    switch (reader_->poll(settings_.first_ticket + slot)) {
        case base::ReadState::pending: return;
        case base::ReadState::done: conclude(slot, database_->check_page(page_index, pages_[slot])); return;
        case base::ReadState::idle:
        case base::ReadState::failed: conclude(slot, {TdbError::unreadable, database_->page_offset(page_index)}); return;
    }
}

void DirectoryCache::conclude(std::uint32_t slot, const TdbFailure& failure) {
    Slot& record = slots_[slot];
    if (failure.error == TdbError::none) {
        record.state = State::ready;
        return;
    }
    record.state = State::failed;
    record.retry_frame = frame_ + settings_.retry_frames;
    ++failing_;
    ++failures_;
    last_failure_ = failure;
}

}  // namespace tedavis::terrain
