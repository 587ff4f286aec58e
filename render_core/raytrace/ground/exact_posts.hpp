/// The posts of one exact chunk, in a window of the lattice.
///
/// An exact chunk above level 0 has every 2^level-th post. Posts between lie on its triangles, two a cell, divided from
/// (i + 1, j) to (i, j + 1); cells of posts that are divided the same way lie in the same planes. (Not in a last column or row of
/// cells that is narrower than the others, where two divisions cross: there posts lie on the surface, and cells near it.)
/// Where a corner of such a cell is void, all of it is: posts within it are, and so are posts on a side that ends there.
#pragma once

#include "render_core/raytrace/ground/ground_window.hpp"

namespace tedavis::raytrace {

/// Writes those posts of the chunk that lie in the window. The vertices are all of a regular chunk (terrain/regular_chunk.hpp)
/// and have passed terrain::payload_holds().
template <class Height>
void put_exact_posts(const terrain::Lattice& lattice, const terrain::ChunkEntry& entry,
                     base::Span<const terrain::ChunkVertex> vertices, const GroundWindow<Height>& to, GroundRounding& rounding);

}  // namespace tedavis::raytrace
