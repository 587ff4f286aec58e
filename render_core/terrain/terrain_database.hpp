/// An opened .tdb: header, chunk directory and undulation grid in memory; payloads are read on demand.
///
/// Memory    directory and grid come from the arena given to open(); nothing is allocated later.
/// Failure   open() and read_chunk() verify sizes, ranges and checksums; one flipped bit anywhere in the file is found
///           when its part is read.
/// Thread    const after open(); read_chunk() is as thread-safe as the byte source.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/result.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::terrain {

enum class TdbError : std::uint8_t {
    none,
    unreadable,
    not_a_tdb,
    wrong_version,
    truncated,
    header_damaged,
    directory_damaged,
    chunk_damaged,
    too_large
};
/// Half a sentence: "is not a terrain database".
[[nodiscard]] const char* to_string(TdbError error) noexcept;

/// A failure and the file offset it was found at.
struct TdbFailure {
    TdbError error = TdbError::none;
    std::uint64_t offset = 0;
};

using ChunkIndex = std::uint32_t;
inline constexpr ChunkIndex kNoChunk = 0xFFFFFFFFu;

class TerrainDatabase {
public:
    [[nodiscard]] static base::Result<TerrainDatabase, TdbFailure> open(base::ByteSource& source, base::Arena& arena);

    [[nodiscard]] const FileHeader& header() const { return header_; }
    [[nodiscard]] std::uint32_t levels() const { return header_.levels; }
    [[nodiscard]] std::uint32_t chunk_count() const { return header_.chunk_count; }
    [[nodiscard]] const ChunkEntry& entry(ChunkIndex index) const { return entries_[index]; }

    /// Chunks of a level: columns and rows of its grid.
    [[nodiscard]] std::uint32_t grid_columns(std::uint32_t level) const;
    [[nodiscard]] std::uint32_t grid_rows(std::uint32_t level) const;
    /// kNoChunk outside the grid.
    [[nodiscard]] ChunkIndex at(std::uint32_t level, std::int64_t i, std::int64_t j) const;
    [[nodiscard]] ChunkIndex parent(ChunkIndex index) const;
    /// Quadrant bit 0 east, bit 1 south; kNoChunk at level 0 or outside.
    [[nodiscard]] ChunkIndex child(ChunkIndex index, std::uint32_t quadrant) const;

    /// Reads and verifies one payload into `destination` (at least entry.bytes long).
    [[nodiscard]] TdbFailure read_chunk(ChunkIndex index, base::Span<std::uint8_t> destination) const;

    /// EGM96 minus WGS84 at a place, bilinear in the stored grid, clamped to its border.
    [[nodiscard]] earth::GeoidUndulation undulation(double latitude_rad, double longitude_rad) const;

    /// Fractional lattice coordinates of a place: i east from west, j south from north.
    struct LatticePoint {
        double i = 0, j = 0;
        bool inside = false;
    };
    [[nodiscard]] LatticePoint lattice_point(double latitude_rad, double longitude_rad) const;

private:
    base::ByteSource* source_ = nullptr;
    FileHeader header_{};
    base::Span<ChunkEntry> entries_;
    base::Span<float> undulation_;
    std::uint32_t level_first_[kMaxLevels + 1]{};
};

}  // namespace tedavis::terrain
