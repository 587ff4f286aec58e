/// What a chunk shows on one of its sides, for comparing it with its neighbours bit by bit.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "tests/support/terrain/built_database.hpp"

namespace tedavis::test_support {

/// Places of border vertices in space, by their lattice post along the side. Exact: chunk centres are whole metres.
using ChunkSide = std::map<std::uint32_t, std::array<double, 3>>;

/// All border vertices on a side, or those that stay beside a coarser chunk.
[[nodiscard]] inline ChunkSide side_of(const BuiltDatabase& built, const terrain::ChunkKey& key, terrain::EdgeBit side,
                                       bool all) {
    const terrain::ChunkEntry entry = built.entry(key);
    const std::vector<terrain::ChunkVertex> vertices = built.vertices(entry);
    const terrain::PostRange posts = built.lattice().posts_of(key);
    ChunkSide found;
    for (std::uint32_t n = 0; n < entry.border_count; ++n) {
        const terrain::ChunkVertex& v = vertices[n];
        const std::uint32_t i = posts.i0 + v.i, j = posts.j0 + v.j;
        const bool here = side == terrain::kEdgeNorth   ? j == posts.j0
                          : side == terrain::kEdgeSouth ? j == posts.j1
                          : side == terrain::kEdgeWest  ? i == posts.i0
                                                        : i == posts.i1;
        if (here && (all || v.stays_beside_coarser()))
            found[side == terrain::kEdgeNorth || side == terrain::kEdgeSouth ? i : j] = {
                entry.centre_m[0] + double{v.x}, entry.centre_m[1] + double{v.y}, entry.centre_m[2] + double{v.z}};
    }
    return found;
}

/// The part of a side from post `first` to post `last`.
[[nodiscard]] inline ChunkSide part_of_side(const ChunkSide& side, std::uint32_t first, std::uint32_t last) {
    return {side.lower_bound(first), side.upper_bound(last)};
}

}  // namespace tedavis::test_support
