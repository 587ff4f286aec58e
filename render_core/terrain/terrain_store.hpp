/// What of a database is in memory: directory pages, chunk payloads, attribute pages, drape pages; all in fixed slots.
///
/// A frame    begin_frame(); select ideally, with everything at hand; want() what that selection asks for; select again from what
///            is available; draw.
/// Arrival    exact (replay): what is wanted in frame n is available from frame n + arrival_frames on; the picture of a frame
///            follows from the views of the window_frames before it. live: when it has been read. part_cache.hpp has the rules.
/// Roots      the chunks of the top level are read at start() and stay.
/// Memory     from arenas at start(). Thread  one; the reader may have its own.
#pragma once

#include "render_core/terrain/directory_cache.hpp"
#include "render_core/terrain/part_cache.hpp"

namespace tedavis::terrain {

struct StoreSettings {
    ArrivalMode mode = ArrivalMode::exact;
    std::uint32_t payload_slots = 0;  ///< roots included; half as many again as chunks are drawn lets ancestors stay beside them
    std::uint32_t directory_pages = 0;  ///< 0: as many as the index arena holds after the database, at most kMaxDirectoryPages
    std::uint32_t attribute_slots = 0;  ///< 0: attribute pages are not read
    std::uint32_t drape_slots = 0;      ///< 0: drape pages are not read
    std::uint32_t arrival_frames = 2, window_frames = 8;
    std::uint32_t max_in_flight = 16;
    std::uint32_t retry_frames = 30, late_frames = 30;
};

inline constexpr std::uint32_t kMaxDirectoryPages = 1024;

/// Arenas by budget line. `attributes` may be empty when there are no attribute slots, `drape` is null without drape slots.
struct StoreMemory {
    base::Arena& index;            ///< terrain_index, after the database took its part
    base::Arena& records;          ///< terrain_chunk_slots
    base::Arena& payloads;         ///< terrain_heights
    base::Arena& attributes;       ///< terrain_attributes
    base::Arena* drape = nullptr;  ///< terrain_drape: pages and their records
};

class TerrainStore final : public ChunkCatalogue {
public:
    /// The reader needs reader_tickets(settings) tickets. too_large: slots do not fit; too_many_roots: payload_slots do not hold
    /// the roots and one more.
    [[nodiscard]] TdbFailure start(const TerrainDatabase& database, base::AsyncReader& reader, const StoreSettings& settings,
                                   const StoreMemory& memory);
    /// Attribute pages that nobody reads need not be fetched; they are, until told.
    void fetch_attributes(bool wanted) { attributes_wanted_ = wanted; }
    void begin_frame();
    /// Most urgent first, ancestors before their descendants. Attribute and drape pages are wanted along with the chunks.
    void want(base::Span<const WantedChunk> chunks);

    [[nodiscard]] const Lattice& lattice() const override { return database_->lattice(); }
    [[nodiscard]] FoundEntry find(const ChunkKey& key) override { return directory_.find(key); }
    [[nodiscard]] SlotIndex available_slot(const ChunkKey& key) const override { return payloads_.slot_of(key); }

    /// Of slots that available_slot() named in this frame.
    [[nodiscard]] base::Span<const ChunkVertex> vertices(SlotIndex slot) const;
    [[nodiscard]] base::Span<const std::uint16_t> indices(SlotIndex slot) const;  ///< empty for a regular chunk
    [[nodiscard]] const ChunkEntry& entry(SlotIndex slot) const { return payloads_.entry(slot); }
    [[nodiscard]] std::uint32_t generation(SlotIndex slot) const { return payloads_.generation(slot); }

    /// The chunk whose attribute page covers a chunk: itself, or the parent of a level-0 chunk.
    [[nodiscard]] static ChunkKey attribute_key(const ChunkKey& key) { return key.level == 0 ? key.parent() : key; }
    /// Slot of an attribute page by the chunk that owns it; kNoSlot when it is not available.
    [[nodiscard]] SlotIndex attribute_slot(const ChunkKey& owner) const { return attributes_.slot_of(owner); }
    [[nodiscard]] const AttributePage& attributes(SlotIndex slot) const;
    [[nodiscard]] std::uint32_t attribute_generation(SlotIndex slot) const { return attributes_.generation(slot); }

    /// Slot of a chunk's drape page; kNoSlot when it has none, or it is not available.
    [[nodiscard]] SlotIndex drape_slot(const ChunkKey& key) const { return drape_.slot_of(key); }
    [[nodiscard]] const DrapePage& drape(SlotIndex slot) const;
    [[nodiscard]] std::uint32_t drape_generation(SlotIndex slot) const { return drape_.generation(slot); }

    [[nodiscard]] std::uint32_t pending() const { return payloads_.pending(); }  ///< chunks wanted and not available
    [[nodiscard]] bool is_late() const { return payloads_.late() != 0 || attributes_.late() != 0 || drape_.late() != 0; }
    [[nodiscard]] bool is_failing() const;
    [[nodiscard]] std::uint64_t failures() const;
    [[nodiscard]] const TdbFailure& last_failure() const;
    [[nodiscard]] const DirectoryCache& directory() const { return directory_; }
    [[nodiscard]] const PartCache& payloads() const { return payloads_; }
    [[nodiscard]] const PartCache& attribute_pages() const { return attributes_; }
    [[nodiscard]] const PartCache& drape_pages() const { return drape_; }

    [[nodiscard]] static std::uint32_t reader_tickets(const StoreSettings& settings);
    /// Bytes that start() takes; of the index arena without the database, with settings.directory_pages or the most there can be.
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
