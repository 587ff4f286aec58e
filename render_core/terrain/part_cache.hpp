/// Cache of parts of chunks (payloads, attribute pages, drape pages) in a fixed number of slots of one size, read
/// asynchronously.
///
/// exact  Let W(m) be the list wanted in frame m. In frame n the lists W(n), W(n-1), ... W(n-window) claim the slots in this
///        order, each from its front; a part that finds no slot left is not kept. A part is available in frame n if it has a
///        slot and was wanted in one of the frames n-window .. n-arrival; want() waits for it. So what is available depends
///        only on the lists of the last `window` frames.
/// live   A part is available when it has been read. The wanted parts, from the front of the list, take the slots of the parts
///        that have not been wanted for longest; at most `max_in_flight` reads are in progress.
///
/// A part that cannot be read or fails its checks is not available; it is tried again after `retry_frames`. Pinned parts keep
/// their slot and are always available.
/// Memory  from arenas at start(). Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/async_reader.hpp"
#include "render_core/terrain/arrival_mode.hpp"
#include "render_core/terrain/chunk_catalogue.hpp"
#include "render_core/terrain/key_map.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

struct WantedChunk {
    ChunkKey key;
    const ChunkEntry* entry = nullptr;  ///< valid in this frame
};

struct PartCacheSettings {
    std::uint32_t slots = 0;  ///< below kNoSlot
    std::size_t slot_bytes = 0;
    PartPlace ChunkEntry::*part = nullptr;
    /// A check of the content beyond the checksum; null: the checksum suffices.
    bool (*holds)(const Lattice& lattice, const ChunkEntry& entry, base::Span<const std::uint8_t> bytes) = nullptr;
    ArrivalMode mode = ArrivalMode::exact;
    std::uint32_t arrival_frames = 2;  ///< 1 or more; exact only
    std::uint32_t window_frames = 8;   ///< arrival_frames..kMaxWindowFrames; exact only
    std::uint32_t max_in_flight = 16;  ///< live only
    std::uint32_t retry_frames = 30;
    std::uint32_t late_frames = 30;  ///< live only: a read in progress for longer than this is late
    std::uint32_t first_ticket = 0;  ///< first of the reader's tickets, one per slot
};

inline constexpr std::uint32_t kMaxWindowFrames = 32;

class PartCache {
public:
    /// The records and the slots' content may come from the same arena. Returns false when they do not fit.
    [[nodiscard]] bool start(const TerrainDatabase& database, base::AsyncReader& reader, const PartCacheSettings& settings,
                             base::Arena& records, base::Arena& parts);
    /// Reads a part at once and keeps it permanently. To be called before the first frame only.
    [[nodiscard]] TdbFailure pin(const WantedChunk& chunk);

    void begin_frame();
    /// Requests parts, most urgent first, at most once per frame; chunks without such a part are skipped, and those beyond the
    /// number of slots are dropped. What is available does not change before the next call.
    void want(base::Span<const WantedChunk> chunks);

    /// Returns the chunk's slot, or kNoSlot when its part is not available.
    [[nodiscard]] SlotIndex slot_of(const ChunkKey& key) const;
    [[nodiscard]] base::Span<const std::uint8_t> bytes(SlotIndex slot) const;
    [[nodiscard]] const ChunkEntry& entry(SlotIndex slot) const { return slots_[slot].entry; }
    /// Increases whenever the slot's content changes, so that a drawer knows when to upload it again.
    [[nodiscard]] std::uint32_t generation(SlotIndex slot) const { return slots_[slot].generation; }

    [[nodiscard]] std::uint32_t pending() const { return pending_; }    ///< wanted in this frame and not available
    [[nodiscard]] std::uint32_t late() const { return late_; }          ///< reads in progress for longer than late_frames
    [[nodiscard]] std::uint32_t failing() const { return failing_; }    ///< wanted in this frame, but not readable
    [[nodiscard]] std::uint64_t failures() const { return failures_; }  ///< failed reads since start
    [[nodiscard]] const TdbFailure& last_failure() const { return last_failure_; }
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }  ///< slots
    [[nodiscard]] static std::uint64_t record_bytes(const PartCacheSettings& settings);
    [[nodiscard]] static std::uint64_t part_bytes(const PartCacheSettings& settings);

private:
    enum class State : std::uint8_t { empty, loading, ready, failed };
    struct Slot {
        ChunkEntry entry;
        std::uint64_t key;     ///< packed; 0: free
        std::uint64_t wanted;  ///< last frame in which it was wanted
        std::uint64_t asked;   ///< frame in which the read began
        std::uint64_t retry;   ///< frame from which a failed read is tried again
        std::uint32_t age;     ///< exact: frames since it was first wanted, within the window
        std::uint32_t generation;
        State state;
        bool pinned;
    };
    /// The parts wanted in one frame that claimed slots.
    struct History {
        base::Span<std::uint64_t> keys;
        std::uint32_t count = 0;
        std::uint64_t frame = 0;
    };
    [[nodiscard]] bool start_history(base::Arena& records);
    [[nodiscard]] base::Span<std::uint8_t> bytes_of(std::uint32_t slot) const;
    [[nodiscard]] bool content_holds(std::uint32_t slot) const;
    /// True where the chunk has such a part and it is not pinned.
    [[nodiscard]] bool needs_slot(const WantedChunk& chunk) const;
    [[nodiscard]] bool is_available(const Slot& slot) const;
    [[nodiscard]] std::uint32_t oldest_unwanted() const;
    [[nodiscard]] std::uint32_t take(std::uint32_t slot, const WantedChunk& chunk);
    void release(std::uint32_t slot);
    void want_exactly(base::Span<const WantedChunk> chunks);
    void claim(base::Span<const WantedChunk> chunks);
    void claim_for_past_frames();
    void want_live(base::Span<const WantedChunk> chunks);
    void ask_where_due(std::uint32_t slot);
    void fetch(std::uint32_t slot, bool waiting);
    void conclude(std::uint32_t slot, TdbError error);
    void count_missing(base::Span<const WantedChunk> chunks);

    const TerrainDatabase* database_ = nullptr;
    base::AsyncReader* reader_ = nullptr;
    PartCacheSettings settings_;
    base::Span<Slot> slots_;
    base::Span<std::uint8_t> parts_;
    History history_[kMaxWindowFrames + 1];
    KeyMap slot_of_key_, claims_;
    std::uint64_t frame_ = 0;
    std::uint32_t pinned_ = 0, in_flight_ = 0, pending_ = 0, late_ = 0, failing_ = 0;
    std::uint64_t failures_ = 0;
    TdbFailure last_failure_;
    base::ResourceUse use_;
};

}  // namespace tedavis::terrain
