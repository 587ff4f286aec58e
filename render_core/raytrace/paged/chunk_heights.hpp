/// Heights that come in chunks of 32 x 32 cells, one at a time: what the paged tracer needs of a terrain that is larger than
/// memory. Implemented over a terrain database (database_chunks.hpp), and by tests over what is nowhere stored.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::raytrace {

/// As of a HeightGrid, but for its posts: 2..HeightGrid::kMaxPosts columns and rows, of any number in all. Chunk (column, row)
/// has the posts from (32 * column, 32 * row) to (32 * column + 32, 32 * row + 32), both included.
template <class Height>
class ChunkHeights {
public:
    static constexpr std::uint32_t kCells = 32, kPosts = kCells + 1;

    virtual ~ChunkHeights() = default;
    [[nodiscard]] virtual std::uint32_t columns() const = 0;
    [[nodiscard]] virtual std::uint32_t rows() const = 0;
    /// No height of a chunk is lower or higher; row by row of chunks. A chunk without any has lowest > highest. False where that
    /// cannot be known.
    [[nodiscard]] virtual bool read_bounds(base::Span<Height> lowest, base::Span<Height> highest) = 0;
    /// All posts of a chunk, row by row; those beyond the last column and row are void, as posts without a height are. False
    /// where it cannot be had. Several threads, each with a `desk` of its own (0 to those that were agreed on - 1).
    [[nodiscard]] virtual bool load(std::uint32_t column, std::uint32_t row, std::uint32_t desk, base::Span<Height> posts) = 0;

    [[nodiscard]] std::uint32_t chunk_columns() const { return (columns() + kCells - 2) / kCells; }
    [[nodiscard]] std::uint32_t chunk_rows() const { return (rows() + kCells - 2) / kCells; }
};

}  // namespace tedavis::raytrace
