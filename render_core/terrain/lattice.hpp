/// The lattice of posts of a database: positions of posts, extents of chunks, and neighbours, also round the Earth and at the
/// poles.
///
/// Post (i, j): longitude west + i*step, latitude north - j*step, but row 0 and the last row are the poles where the header's
/// flags say so. The closing column of a lattice round the Earth has exactly the coordinates of column 0.
/// Frames   degrees and radians, WGS84; positions ECEF, metres. Pure functions; any thread.
#pragma once

#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/chunk_key.hpp"

namespace tedavis::terrain {

/// Posts of a chunk: first and last column and row, both included.
struct PostRange {
    std::uint32_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;
};

/// Fractional lattice coordinates of a place: i east from west, j south from north.
struct LatticePoint {
    double i = 0, j = 0;
    bool inside = false;
};

/// The header must be one that TerrainDatabase::open() accepts.
class Lattice {
public:
    Lattice() = default;
    explicit Lattice(const FileHeader& header);

    [[nodiscard]] std::uint32_t columns() const { return columns_; }
    [[nodiscard]] std::uint32_t rows() const { return rows_; }
    [[nodiscard]] std::uint32_t levels() const { return levels_; }
    [[nodiscard]] std::uint32_t flags() const { return flags_; }  ///< LatticeFlag
    [[nodiscard]] bool is_closed() const { return (flags_ & kLatticeClosed) != 0; }

    [[nodiscard]] double latitude_rad(std::uint32_t j) const;
    [[nodiscard]] double longitude_rad(std::uint32_t i) const;
    /// Returns the ECEF position of a post at a height above the ellipsoid. All posts of a pole row are the same point.
    [[nodiscard]] earth::Ecef position(std::uint32_t i, std::uint32_t j, double ellipsoid_height_m) const;
    [[nodiscard]] LatticePoint point(double latitude_rad, double longitude_rad) const;

    /// Numbers of chunks of a level, across and down.
    [[nodiscard]] std::uint32_t grid_columns(std::uint32_t level) const;
    [[nodiscard]] std::uint32_t grid_rows(std::uint32_t level) const;
    [[nodiscard]] bool contains(const ChunkKey& key) const;
    [[nodiscard]] PostRange posts_of(const ChunkKey& key) const;
    /// Returns the chunk of the same level beyond a side, round the Earth where the lattice is closed; kNoChunk where the
    /// lattice ends.
    [[nodiscard]] ChunkKey neighbour(const ChunkKey& key, EdgeBit side) const;

    /// Numbers of directory pages of a level, and the index of a chunk's page in the page table.
    [[nodiscard]] std::uint32_t page_columns(std::uint32_t level) const;
    [[nodiscard]] std::uint32_t page_rows(std::uint32_t level) const;
    [[nodiscard]] std::uint32_t page_index(const ChunkKey& key) const;
    [[nodiscard]] std::uint32_t page_count() const { return first_page_[levels_]; }
    [[nodiscard]] static std::uint32_t index_in_page(const ChunkKey& key) {
        return (key.j % kPageChunks) * kPageChunks + key.i % kPageChunks;
    }

private:
    double west_deg_ = 0, north_deg_ = 0, step_lon_deg_ = 1, step_lat_deg_ = 1;
    std::uint32_t columns_ = 0, rows_ = 0, levels_ = 0, flags_ = 0;
    std::uint32_t first_page_[kMaxLevels + 1]{};
};

}  // namespace tedavis::terrain
