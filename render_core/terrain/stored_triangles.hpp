/// Visits the triangles of a chunk's payload: those of the index list, or the cells of a regular chunk.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/terrain/regular_chunk.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::terrain {

/// Returns the grid of a regular chunk from its counts; `rows` is 0 when they fit no grid.
[[nodiscard]] inline RegularGrid grid_of(const ChunkEntry& entry, base::Span<const ChunkVertex> vertices) {
    std::uint32_t columns = 1;
    while (columns < vertices.size() && vertices[columns].j == 0) ++columns;
    const RegularGrid grid{columns, entry.vertex_count / columns};
    const bool fits =
        columns >= 2 && grid.rows >= 2 && grid.vertex_count() == entry.vertex_count && grid.border_count() == entry.border_count;
    return fits ? grid : RegularGrid{};
}

/// Calls use(a, b, c) for each triangle until it returns false. Returns false then, and where a regular chunk fits no grid.
/// Indices of a damaged payload may lie beyond the vertices.
template <class Use>
[[nodiscard]] bool each_stored_triangle(const ChunkEntry& entry, base::Span<const ChunkVertex> vertices,
                                        base::Span<const std::uint16_t> stored, Use&& use) {
    if ((entry.flags & kChunkRegular) == 0) {
        const std::uint16_t* const index = stored.data();
        for (std::size_t n = 0; n + 2 < stored.size(); n += 3)
            if (!use(index[n], index[n + 1], index[n + 2])) return false;
        return true;
    }
    const RegularGrid grid = grid_of(entry, vertices);
    if (grid.rows == 0) return false;
    // Two triangles per cell, cut along the true surface's diagonal.
    for (std::uint32_t j = 0; j + 1 < grid.rows; ++j)
        for (std::uint32_t i = 0; i + 1 < grid.columns; ++i) {
            const auto at = [&](std::uint32_t di, std::uint32_t dj) {
                return static_cast<std::uint16_t>(grid.index_of(i + di, j + dj));
            };
            if (!use(at(0, 0), at(0, 1), at(1, 0)) || !use(at(1, 0), at(0, 1), at(1, 1))) return false;
        }
    return true;
}

}  // namespace tedavis::terrain
