/// Port: heights in chunks of 32 x 32 cells, loaded one at a time, for terrain that is larger than memory. Implemented over a
/// terrain database (database_chunks.hpp), and by tests over generated heights.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::raytrace {

/// Like a HeightGrid without a limit of the total number of posts: 2..HeightGrid::kMaxPosts columns and rows. Chunk (column,
/// row) has the posts from (32 * column, 32 * row) to (32 * column + 32, 32 * row + 32), both included.
template <class Height>
class ChunkHeights {
public:
    static constexpr std::uint32_t kCells = 32, kPosts = kCells + 1;

    virtual ~ChunkHeights() = default;
    [[nodiscard]] virtual std::uint32_t columns() const = 0;
    [[nodiscard]] virtual std::uint32_t rows() const = 0;
    /// Writes lower and upper bounds of the heights of each chunk, row by row. A chunk without heights has lowest > highest.
    /// Returns false where the bounds are unknown.
    [[nodiscard]] virtual bool read_bounds(base::Span<Height> lowest, base::Span<Height> highest) = 0;
    /// Writes all posts of a chunk, row by row; posts beyond the last column and row, and posts without a height, are void.
    /// Returns false where the chunk cannot be loaded. May be called by several threads, each with its own `desk` (0 .. agreed
    /// number - 1).
    [[nodiscard]] virtual bool load(std::uint32_t column, std::uint32_t row, std::uint32_t desk, base::Span<Height> posts) = 0;

    [[nodiscard]] std::uint32_t chunk_columns() const { return (columns() + kCells - 2) / kCells; }
    [[nodiscard]] std::uint32_t chunk_rows() const { return (rows() + kCells - 2) / kCells; }
};

}  // namespace tedavis::raytrace
