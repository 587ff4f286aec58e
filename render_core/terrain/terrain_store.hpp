/// The part of a terrain database that is in memory: directory pages, chunk payloads, attribute pages and drape pages, all in
/// fixed slots.
///
/// A frame    begin_frame(); select as if every chunk were in memory; want() the chunks of that selection; select again from the
///            available chunks; draw.
/// Arrival    exact (replay): what is wanted in frame n is available from frame n + arrival_frames on; the picture of a frame
///            depends on the views of the window_frames before it only. live: what is wanted is available when it has been
///            read. part_cache.hpp has the rules.
/// Roots      the chunks of the top level are read at start() and stay.
/// Memory     from arenas at start(). Thread  one; the reader may have its own.
#pragma once

#include "render_core/terrain/directory_cache.hpp"
#include "render_core/terrain/part_cache.hpp"

namespace tedavis::terrain {

struct StoreSettings {
    ArrivalMode mode = ArrivalMode::exact;
    std::uint32_t payload_slots = 0;    ///< roots included; 1.5 times the drawn chunks leaves room for their ancestors
    std::uint32_t directory_pages = 0;  ///< 0: as many as fit the index arena after the database, at most kMaxDirectoryPages
    std::uint32_t attribute_slots = 0;  ///< 0: attribute pages are not read
    std::uint32_t drape_slots = 0;      ///< 0: drape pages are not read
    std::uint32_t arrival_frames = 2, window_frames = 8;
    std::uint32_t max_in_flight = 16;
    std::uint32_t retry_frames = 30, late_frames = 30;
};

inline constexpr std::uint32_t kMaxDirectoryPages = 1024;

/// Arenas by budget line. `attributes` may be empty when there are no attribute slots, `drape` is null without drape slots.
struct StoreMemory {
    base::Arena& index;            ///< terrain_index, after the database has allocated from it
    base::Arena& records;          ///< terrain_chunk_slots
    base::Arena& payloads;         ///< terrain_heights
    base::Arena& attributes;       ///< terrain_attributes
    base::Arena* drape = nullptr;  ///< terrain_drape: pages and their records
};

class TerrainStore final : public ChunkCatalogue {
public:
    /// The reader needs reader_tickets(settings) tickets. Errors: too_large when the slots do not fit, too_many_roots when
    /// payload_slots is not larger than the number of roots.
    [[nodiscard]] TdbFailure start(const TerrainDatabase& database, base::AsyncReader& reader, const StoreSettings& settings,
                                   const StoreMemory& memory);
    /// Enables or disables the reading of attribute pages; enabled at first.
    void fetch_attributes(bool wanted) { attributes_wanted_ = wanted; }
    void begin_frame();
    /// Requests chunks, most urgent first, ancestors before their descendants, with their attribute and drape pages.
    void want(base::Span<const WantedChunk> chunks);

    [[nodiscard]] const Lattice& lattice() const override { return database_->lattice(); }
    [[nodiscard]] FoundEntry find(const ChunkKey& key) override { return directory_.find(key); }
    [[nodiscard]] SlotIndex available_slot(const ChunkKey& key) const override { return payloads_.slot_of(key); }

    /// Content of a slot that available_slot() returned in this frame.
    [[nodiscard]] base::Span<const ChunkVertex> vertices(SlotIndex slot) const;
    [[nodiscard]] base::Span<const std::uint16_t> indices(SlotIndex slot) const;  ///< empty for a regular chunk
    [[nodiscard]] const ChunkEntry& entry(SlotIndex slot) const { return payloads_.entry(slot); }
    [[nodiscard]] std::uint32_t generation(SlotIndex slot) const { return payloads_.generation(slot); }

    /// The chunk whose attribute page covers a chunk: itself, or the parent of a level-0 chunk.
    [[nodiscard]] static ChunkKey attribute_key(const ChunkKey& key) { return key.level == 0 ? key.parent() : key; }
    /// Returns the slot of the attribute page of its owner chunk, or kNoSlot when it is not available.
    [[nodiscard]] SlotIndex attribute_slot(const ChunkKey& owner) const { return attributes_.slot_of(owner); }
    [[nodiscard]] const AttributePage& attributes(SlotIndex slot) const;
    [[nodiscard]] std::uint32_t attribute_generation(SlotIndex slot) const { return attributes_.generation(slot); }

    /// Returns the slot of a chunk's drape page, or kNoSlot when there is none or it is not available.
    [[nodiscard]] SlotIndex drape_slot(const ChunkKey& key) const { return drape_.slot_of(key); }
    [[nodiscard]] const DrapePage& drape(SlotIndex slot) const;
    [[nodiscard]] std::uint32_t drape_generation(SlotIndex slot) const { return drape_.generation(slot); }

    [[nodiscard]] std::uint32_t pending() const { return payloads_.pending(); }  ///< chunks wanted but not available
    [[nodiscard]] bool is_late() const { return payloads_.late() != 0 || attributes_.late() != 0 || drape_.late() != 0; }
    [[nodiscard]] bool is_failing() const;
    [[nodiscard]] std::uint64_t failures() const;
    [[nodiscard]] const TdbFailure& last_failure() const;
    [[nodiscard]] const DirectoryCache& directory() const { return directory_; }
    [[nodiscard]] const PartCache& payloads() const { return payloads_; }
    [[nodiscard]] const PartCache& attribute_pages() const { return attributes_; }
    [[nodiscard]] const PartCache& drape_pages() const { return drape_; }

    [[nodiscard]] static std::uint32_t reader_tickets(const StoreSettings& settings);
    /// Bytes that start() allocates from each arena. Those of the index arena exclude the database and count
    /// settings.directory_pages, or the maximum where that is 0.
    [[nodiscard]] static std::uint64_t index_bytes(const StoreSettings& settings);
    [[nodiscard]] static std::uint64_t record_bytes(const StoreSettings& settings);
    [[nodiscard]] static std::uint64_t payload_bytes(const StoreSettings& settings);
    [[nodiscard]] static std::uint64_t attribute_bytes(const StoreSettings& settings);
    [[nodiscard]] static std::uint64_t drape_bytes(const StoreSettings& settings);

private:
    [[nodiscard]] TdbFailure pin_roots();

    const TerrainDatabase* database_ = nullptr;
    DirectoryCache directory_;
    PartCache payloads_, attributes_, drape_;
    base::Span<WantedChunk> attribute_list_;
    bool attributes_wanted_ = true;
};

}  // namespace tedavis::terrain
