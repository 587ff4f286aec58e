/// How far drawn triangles lie from the posts that are in them, along the ellipsoid's normal. Independent of the terrain builder.
#pragma once

#include <cstdint>
#include <vector>

#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::test_support {

/// The posts of a lattice, row by row.
struct PostSurface {
    const terrain::Lattice& lattice;
    std::uint32_t columns;
    const std::vector<earth::Ecef>& positions;
    const std::vector<earth::Ecef>& ups;  ///< normals of the ellipsoid
};

struct SurfaceGap {
    double above_m = 0, below_m = 0;  ///< of what is drawn, at its worst
};

/// `indices` are of the chunk's vertices, three a triangle.
[[nodiscard]] SurfaceGap surface_gap(const PostSurface& surface, const terrain::ChunkEntry& entry,
                                     const std::vector<terrain::ChunkVertex>& vertices,
                                     const std::vector<std::uint16_t>& indices);

}  // namespace tedavis::test_support
