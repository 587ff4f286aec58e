/// The difference between the vertices of a chunk in a file and those made from the rasters.
///
/// Vertices are compared at equal posts: a small change of a surface can change the posts of its mesh, so vertices at different
/// posts cannot be compared.
#pragma once

#include <functional>
#include <optional>

#include "render_core/base/span.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

struct ChunkVertices {
    base::Span<const terrain::ChunkVertex> vertices;  ///< from a file, in any order and with any values
    const double* centre_m = nullptr;                 ///< three ECEF coordinates, to which positions are relative
};

/// Height of the rasters at a post of the lattice, metres above MSL; nothing where they have no such post.
using PostHeight = std::function<std::optional<float>(std::uint32_t i, std::uint32_t j)>;

struct MeshDifference {
    bool has_other_posts = false;  ///< one of the meshes has a vertex at a post where the other one has none
    /// The largest difference of heights and positions at common posts, and of heights from the rasters at the other posts of the
    /// stated mesh. NaN counts as kHighestHeight_m.
    double largest_m = 0;
};

/// `posts` is the chunk's range. `height_m` is called for neighbouring posts in succession.
[[nodiscard]] MeshDifference mesh_difference(const ChunkVertices& stated, const ChunkVertices& expected,
                                             const terrain::PostRange& posts, const PostHeight& height_m);

}  // namespace tedavis::host_sim
