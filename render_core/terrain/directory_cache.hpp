/// Cache of directory pages in a fixed number of slots. The least recently requested page is replaced; pages requested in this
/// frame and those of the top level stay.
///
/// exact  a requested page is read at once, so answers never depend on earlier requests
/// live   a requested page is read asynchronously and is `missing` until it has arrived
///
/// A page that cannot be read or is damaged is `missing`, counted, and tried again after `retry_frames`.
/// Memory  from the arena at start(). Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/async_reader.hpp"
#include "render_core/terrain/arrival_mode.hpp"
#include "render_core/terrain/chunk_catalogue.hpp"
#include "render_core/terrain/key_map.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

struct DirectorySettings {
    std::uint32_t pages = 0;  ///< slots; at least one more than the top level has pages
    ArrivalMode mode = ArrivalMode::exact;
    std::uint32_t retry_frames = 30;
    std::uint32_t first_ticket = 0;  ///< first of the reader's tickets, one per slot; live mode only
};

class DirectoryCache {
public:
    /// Reads the pages of the top level. `reader` may be null in exact mode.
    [[nodiscard]] TdbFailure start(const TerrainDatabase& database, base::AsyncReader* reader, const DirectorySettings& settings,
                                   base::Arena& arena);
    void begin_frame();
    /// Returns a chunk's entry; it stays valid until begin_frame().
    [[nodiscard]] FoundEntry find(const ChunkKey& key);

    [[nodiscard]] std::uint32_t failing() const { return failing_; }    ///< pages that could not be read
    [[nodiscard]] std::uint64_t failures() const { return failures_; }  ///< failed reads since start
    [[nodiscard]] const TdbFailure& last_failure() const { return last_failure_; }
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }  ///< pages
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t pages);

private:
    enum class State : std::uint8_t { empty, loading, ready, failed };
    struct Slot {
        std::uint64_t last_frame;  ///< 0: never used
        std::uint64_t retry_frame;
        std::uint32_t page_index;
        State state;
        bool pinned;
    };
    [[nodiscard]] TdbFailure pin_top_level();
    [[nodiscard]] std::uint32_t slot_for(std::uint32_t page_index);
    void load(std::uint32_t slot);
    void poll(std::uint32_t slot);
    void conclude(std::uint32_t slot, const TdbFailure& failure);

    const TerrainDatabase* database_ = nullptr;
    base::AsyncReader* reader_ = nullptr;
    DirectorySettings settings_;
    base::Span<DirectoryPage> pages_;
    base::Span<Slot> slots_;
    KeyMap slot_of_page_;
    std::uint64_t frame_ = 1;
    std::uint32_t failing_ = 0;
    std::uint64_t failures_ = 0;
    TdbFailure last_failure_;
    base::ResourceUse use_;
};

}  // namespace tedavis::terrain
