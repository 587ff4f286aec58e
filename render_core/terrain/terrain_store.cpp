#include "render_core/terrain/terrain_store.hpp"

#include "render_core/terrain/chunk_payload.hpp"

namespace tedavis::terrain {
namespace {

/// Tickets: payload slots, then attribute slots, drape slots, directory pages.
PartCacheSettings payload_settings(const StoreSettings& s) {
    PartCacheSettings part;
    part.slots = s.payload_slots;
    part.slot_bytes = kMaxPayloadBytes;
    part.part = &ChunkEntry::payload;
    part.holds = &payload_holds;
    part.mode = s.mode;
    part.arrival_frames = s.arrival_frames;
    part.window_frames = s.window_frames;
    part.max_in_flight = s.max_in_flight;
    part.retry_frames = s.retry_frames;
    part.late_frames = s.late_frames;
    return part;
}

PartCacheSettings attribute_settings(const StoreSettings& s) {
    PartCacheSettings part = payload_settings(s);
    part.slots = s.attribute_slots;
    part.slot_bytes = sizeof(AttributePage);
    part.part = &ChunkEntry::attributes;
    part.holds = nullptr;
    part.first_ticket = s.payload_slots;
    return part;
}

PartCacheSettings drape_settings(const StoreSettings& s) {
    PartCacheSettings part = payload_settings(s);
    part.slots = s.drape_slots;
    part.slot_bytes = sizeof(DrapePage);
    part.part = &ChunkEntry::drape;
    part.holds = nullptr;
    part.first_ticket = s.payload_slots + s.attribute_slots;
    return part;
}

std::uint32_t most_pages(const StoreSettings& s) { return s.directory_pages != 0 ? s.directory_pages : kMaxDirectoryPages; }

}  // namespace

std::uint32_t TerrainStore::reader_tickets(const StoreSettings& s) {
    return s.payload_slots + s.attribute_slots + s.drape_slots + most_pages(s);
}

std::uint64_t TerrainStore::index_bytes(const StoreSettings& s) { return DirectoryCache::bytes_needed(most_pages(s)); }

std::uint64_t TerrainStore::record_bytes(const StoreSettings& s) {
    const std::uint64_t attributes = s.attribute_slots == 0 ? 0
                                                            : PartCache::record_bytes(attribute_settings(s)) +
                                                                  std::uint64_t{s.payload_slots} * sizeof(WantedChunk) + 16;
    return PartCache::record_bytes(payload_settings(s)) + attributes;
}

std::uint64_t TerrainStore::payload_bytes(const StoreSettings& s) { return PartCache::part_bytes(payload_settings(s)); }

std::uint64_t TerrainStore::attribute_bytes(const StoreSettings& s) {
    return s.attribute_slots == 0 ? 0 : PartCache::part_bytes(attribute_settings(s));
}

std::uint64_t TerrainStore::drape_bytes(const StoreSettings& s) {
    if (s.drape_slots == 0) return 0;
    const PartCacheSettings part = drape_settings(s);
    return PartCache::record_bytes(part) + PartCache::part_bytes(part);
}

TdbFailure TerrainStore::start(const TerrainDatabase& database, base::AsyncReader& reader, const StoreSettings& settings,
                               const StoreMemory& memory) {
    database_ = &database;
    DirectorySettings directory;
    directory.pages = most_pages(settings);
    const std::uint64_t left = memory.index.use().capacity - memory.index.use().in_use;
    while (settings.directory_pages == 0 && directory.pages > 1 && DirectoryCache::bytes_needed(directory.pages) > left)
        --directory.pages;
    directory.mode = settings.mode;
    directory.retry_frames = settings.retry_frames;
    directory.first_ticket = settings.payload_slots + settings.attribute_slots + settings.drape_slots;
    if (directory.first_ticket + directory.pages > reader.capacity()) return {TdbError::too_large, 0};
    if (const TdbFailure failure = directory_.start(database, &reader, directory, memory.index); failure.error != TdbError::none)
        return failure;
    if (database.root_count() >= settings.payload_slots) return {TdbError::too_many_roots, 0};
    if (!payloads_.start(database, reader, payload_settings(settings), memory.records, memory.payloads))
        return {TdbError::too_large, 0};
    if (settings.attribute_slots != 0) {
        attribute_list_ = memory.records.allocate_array<WantedChunk>(settings.payload_slots);
        if (attribute_list_.empty() ||
            !attributes_.start(database, reader, attribute_settings(settings), memory.records, memory.attributes))
            return {TdbError::too_large, 0};
    }
    if (settings.drape_slots != 0 &&
        (memory.drape == nullptr || !drape_.start(database, reader, drape_settings(settings), *memory.drape, *memory.drape)))
        return {TdbError::too_large, 0};
    return pin_roots();
}

TdbFailure TerrainStore::pin_roots() {
    const std::uint32_t top = database_->top_level();
    for (std::uint32_t j = 0; j < lattice().grid_rows(top); ++j)
        for (std::uint32_t i = 0; i < lattice().grid_columns(top); ++i) {
            const ChunkKey root{top, i, j};
            const FoundEntry found = directory_.find(root);
            if (found.state != EntryState::present)
                return {TdbError::directory_damaged, database_->page_offset(lattice().page_index(root))};
            if (const TdbFailure failure = payloads_.pin({root, found.entry}); failure.error != TdbError::none) return failure;
        }
    return {};
}

void TerrainStore::begin_frame() {
    directory_.begin_frame();
    payloads_.begin_frame();
    if (!attribute_list_.empty()) attributes_.begin_frame();
    if (drape_.use().capacity != 0) drape_.begin_frame();
}

void TerrainStore::want(base::Span<const WantedChunk> chunks) {
    payloads_.want(chunks);
    if (drape_.use().capacity != 0) drape_.want(chunks);
    if (attribute_list_.empty() || !attributes_wanted_) return;
    // Level-0 chunks use their parents' pages, and parents are wanted too.
    std::size_t count = 0;
    for (const WantedChunk& chunk : chunks)
        if (chunk.key.level != 0 && count < attribute_list_.size()) attribute_list_[count++] = chunk;
    attributes_.want(attribute_list_.subspan(0, count));
}

base::Span<const ChunkVertex> TerrainStore::vertices(SlotIndex slot) const {
    return payload_vertices(payloads_.entry(slot), payloads_.bytes(slot));
}

base::Span<const std::uint16_t> TerrainStore::indices(SlotIndex slot) const {
    return payload_indices(payloads_.entry(slot), payloads_.bytes(slot));
}

const AttributePage& TerrainStore::attributes(SlotIndex slot) const {
    return *reinterpret_cast<const AttributePage*>(attributes_.bytes(slot).data());
}

const DrapePage& TerrainStore::drape(SlotIndex slot) const {
    return *reinterpret_cast<const DrapePage*>(drape_.bytes(slot).data());
}

bool TerrainStore::is_failing() const {
    return directory_.failing() != 0 || payloads_.failing() != 0 || attributes_.failing() != 0 || drape_.failing() != 0;
}

std::uint64_t TerrainStore::failures() const {
    return directory_.failures() + payloads_.failures() + attributes_.failures() + drape_.failures();
}

const TdbFailure& TerrainStore::last_failure() const {
    if (payloads_.failures() != 0) return payloads_.last_failure();
    if (directory_.failures() != 0) return directory_.last_failure();
    return attributes_.failures() != 0 ? attributes_.last_failure() : drape_.last_failure();
}

}  // namespace tedavis::terrain
