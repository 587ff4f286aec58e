/// Height of the true surface at a point, from the posts of the exact chunk there: two triangles per cell with the fixed
/// diagonal; a cell at a pole is one triangle with its apex there.
///
/// Reads what it needs at once and caches the last few pages and chunks, and the answers at many places (kept_heights.hpp): what
/// stands on the ground is asked for again and again. Answers do not depend on the caches.
/// Memory  from the arena at start(). Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/block_extents.hpp"
#include "render_core/terrain/kept_heights.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

/// An exact chunk; its vertices are all posts of its grid (regular_chunk.hpp).
struct ExactChunk {
    const ChunkEntry* entry = nullptr;  ///< null: it cannot be read
    base::Span<const ChunkVertex> vertices;
    const BlockExtents* extents = nullptr;  ///< null with the entry
};

class HeightQuery {
public:
    static constexpr std::uint32_t kKeptChunks = 5;              ///< four round a corner, and the one below the own ship
    static constexpr std::uint32_t kKeptPages = 2 * kMaxLevels;  ///< the path from the top level down, and neighbours

    [[nodiscard]] bool start(const TerrainDatabase& database, base::Arena& arena);
    [[nodiscard]] HeightAnswer at(double latitude_rad, double longitude_rad);
    /// Returns the exact chunk over the lattice cell south-east of a post. It stays valid while at most kKeptChunks are
    /// requested.
    [[nodiscard]] ExactChunk exact_chunk(std::uint32_t i, std::uint32_t j);
    /// Returns the entry of a chunk without reading its vertices; valid until the next call. Null when its page is damaged or
    /// there is no such chunk.
    [[nodiscard]] const ChunkEntry* entry_of(const ChunkKey& key);
    [[nodiscard]] const Lattice& lattice() const { return database_->lattice(); }
    [[nodiscard]] static std::uint64_t bytes_needed();

private:
    struct KeptChunk {
        ChunkEntry entry;
        BlockExtents extents;
        std::uint64_t asked;  ///< 0: empty
    };
    struct KeptPage {
        std::uint32_t page_index;
        std::uint64_t asked;  ///< 0: empty
    };
    [[nodiscard]] HeightAnswer read_height(double latitude_rad, double longitude_rad);
    [[nodiscard]] base::Span<std::uint8_t> payload(std::uint32_t kept) const;
    [[nodiscard]] const ChunkEntry* exact_entry(std::uint32_t i, std::uint32_t j);
    [[nodiscard]] std::uint32_t chunk_over(std::uint32_t i, std::uint32_t j);

    const TerrainDatabase* database_ = nullptr;
    base::Span<KeptChunk> chunks_;
    base::Span<std::uint8_t> payloads_;
    base::Span<KeptPage> kept_pages_;
    base::Span<DirectoryPage> pages_;
    KeptHeights heights_;
    std::uint64_t asked_ = 0;
};

}  // namespace tedavis::terrain
