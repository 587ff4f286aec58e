/// Where the posts of an exact chunk lie, by blocks of 8 x 8 cells: a few numbers in place of all its vertices, to tell what of
/// it can matter in a view.
///
/// Pure arithmetic; any thread. Plain data, no allocation.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/terrain/ground_scan.hpp"
#include "render_core/terrain/regular_chunk.hpp"
#include "render_core/terrain/tdb_format.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Ranges along the chunk's own axes (north, east, down), relative to its centre, m. They hold all posts of the blocks, also
/// those without ground.
struct BlockExtents {
    static constexpr std::uint32_t kCells = 8;  ///< of a block's side; the last ones may have fewer
    static constexpr std::uint32_t kSide = kChunkCells / kCells;

    /// Low above high: there is none at this place, as in a chunk at the border of its terrain.
    struct Extent {
        float low[3], high[3];
    };
    Extent blocks[kSide * kSide];  ///< row by row from the north-west
};

/// `vertices` are those of an exact chunk, in the order of its grid.
[[nodiscard]] BlockExtents block_extents(const ChunkEntry& entry, const RegularGrid& grid,
                                         base::Span<const ChunkVertex> vertices);

/// Returns a box that holds the block's posts in a view; empty where there are none.
[[nodiscard]] ViewBox seen_block(const ChunkEntry& entry, const BlockExtents::Extent& block, const View& view);

}  // namespace tedavis::terrain
