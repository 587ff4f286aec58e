/// The posts of one exact chunk, in a window of the lattice.
///
/// An exact chunk above level 0 has every 2^level-th post. Posts between lie on its triangles, two per cell, divided from
/// (i + 1, j) to (i, j + 1); the cells between posts of level 0, divided in the same direction, lie in the same planes. (Except
/// in a last column or row of cells that is narrower than the others, where the diagonals cross: there posts lie on the surface,
/// and cells near it.) Where a corner of a chunk's cell is void, the whole cell is: posts inside it and on the sides that end at
/// that corner are void.
#pragma once

#include "render_core/raytrace/ground/ground_window.hpp"

namespace tedavis::raytrace {

/// Writes the posts of the chunk that lie in the window. `vertices` are all those of a regular chunk
/// (terrain/regular_chunk.hpp) and have passed terrain::payload_holds().
template <class Height>
void put_exact_posts(const terrain::Lattice& lattice, const terrain::ChunkEntry& entry,
                     base::Span<const terrain::ChunkVertex> vertices, const GroundWindow<Height>& to, GroundRounding& rounding);

}  // namespace tedavis::raytrace
