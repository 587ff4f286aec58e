/// A terrain database in chunks for the paged tracer: the same heights as GroundReader gives for the window, in metres, bit for
/// bit.
///
/// The bounds of chunks come from the directory. Where an exact chunk lies above level 0, a chunk is the part of it that a
/// chunk of level 0 would cover. Damaged parts have no heights and are counted.
///
/// Memory  from an arena at start: bytes_needed(). Thread  load() may run concurrently for different desks.
#pragma once

#include "render_core/raytrace/ground/ground_reader.hpp"
#include "render_core/raytrace/paged/chunk_heights.hpp"

namespace tedavis::raytrace {

class DatabaseChunks final : public ChunkHeights<float> {
    struct Desk;

public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t desks);
    /// Sets a window of the lattice (GroundWindow) whose first column and row are multiples of 32. Returns false where the
    /// arena is too small, or a side of the window has one post or more than HeightGrid::kMaxPosts. The database must outlive
    /// the object.
    [[nodiscard]] bool start(const terrain::TerrainDatabase& database, const terrain::PostRange& window, std::uint32_t desks,
                             base::Arena& arena);

    [[nodiscard]] std::uint32_t columns() const override { return window_.i1 - window_.i0 + 1; }
    [[nodiscard]] std::uint32_t rows() const override { return window_.j1 - window_.j0 + 1; }
    /// Always returns true; chunks of damaged_pages() have no heights.
    [[nodiscard]] bool read_bounds(base::Span<float> lowest, base::Span<float> highest) override;
    [[nodiscard]] bool load(std::uint32_t column, std::uint32_t row, std::uint32_t desk, base::Span<float> posts) override;

    [[nodiscard]] std::uint32_t damaged_pages() const { return damaged_pages_; }
    [[nodiscard]] std::uint64_t read_bytes() const;  ///< bytes of payloads and directory pages read by load()

private:
    void bound_chunks(const terrain::ChunkEntry& entry, base::Span<float> lowest, base::Span<float> highest) const;
    [[nodiscard]] const terrain::ChunkEntry* finest_entry(const terrain::ChunkKey& key, Desk& desk) const;
    [[nodiscard]] bool load_coarse(const GroundWindow<float>& to, Desk& desk) const;

    const terrain::TerrainDatabase* database_ = nullptr;
    terrain::PostRange window_;
    base::Span<Desk> desks_;
    std::uint32_t damaged_pages_ = 0;
};

}  // namespace tedavis::raytrace
