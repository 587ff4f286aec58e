/// How far the vertices that a file states for a chunk are from those that the rasters give.
///
/// Vertices are compared post by post: a small change of a surface can move its mesh to other posts, and the distance between
/// vertices of different posts says nothing about either.
#pragma once

#include <functional>
#include <optional>

#include "render_core/base/span.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

struct ChunkVertices {
    base::Span<const terrain::ChunkVertex> vertices;  ///< of a file, in whatever order and with whatever values
    const double* centre_m = nullptr;                 ///< ECEF, three of them: what positions are relative to
};

/// Metres above MSL that the rasters have at a post of the lattice; none where they have no such post.
using PostHeight = std::function<std::optional<float>(std::uint32_t i, std::uint32_t j)>;

struct MeshDifference {
    bool has_other_posts = false;  ///< one of the meshes has a vertex at a post where the other one has none
    /// Of heights and positions at posts that both have, and of heights from the rasters at the stated mesh's other posts.
    /// A value that is no number counts as kHighestHeight_m.
    double largest_m = 0;
};

/// `posts` is the chunk's range. Asks for heights of neighbouring posts one after the other.
[[nodiscard]] MeshDifference mesh_difference(const ChunkVertices& stated, const ChunkVertices& expected,
                                             const terrain::PostRange& posts, const PostHeight& height_m);

}  // namespace tedavis::host_sim
