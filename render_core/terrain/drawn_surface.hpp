/// The surface as it is drawn, at a point; objects on the ground are placed on it.
///
/// A point is located in a triangle by its lattice coordinates; its ECEF position is interpolated from the corners' positions,
/// lifts included, with the barycentric weights in lattice coordinates. A triangle with one corner on a pole covers the
/// meridians between its other two corners. Vertices are lifted along the ellipsoid's normal at their post. Pure functions; any
/// thread.
#pragma once

#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

/// A chunk as it is drawn: its vertices and the index list for its current coarser edges.
struct DrawnMesh {
    const SelectedChunk* chunk = nullptr;
    base::Span<const ChunkVertex> vertices;
    base::Span<const std::uint16_t> indices;
};

/// Port: the meshes of the chunks that a frame selected. Called on the display's thread.
class DrawnMeshes {
public:
    [[nodiscard]] virtual base::Span<const ChunkVertex> vertices(const SelectedChunk& chunk) = 0;
    /// Returns the payload's indices; empty for a regular chunk.
    [[nodiscard]] virtual base::Span<const std::uint16_t> stored_indices(const SelectedChunk& chunk) = 0;
    /// Returns the indices that are drawn; valid until the next call.
    [[nodiscard]] virtual base::Span<const std::uint16_t> drawn_indices(const SelectedChunk& chunk) = 0;

protected:
    DrawnMeshes() = default;
    DrawnMeshes(const DrawnMeshes&) = default;
    DrawnMeshes& operator=(const DrawnMeshes&) = default;
    ~DrawnMeshes() = default;
};

struct DrawnPoint {
    bool found = false;  ///< false: there is no triangle at the point
    earth::Ecef position{};
    earth::MslHeight height;
    PostClass post_class = PostClass::outside;  ///< class of the corner with the largest weight; void_ where any corner is void
};

/// Returns the selected chunk that contains a lattice point, or null.
[[nodiscard]] const SelectedChunk* chunk_under(const Lattice& lattice, base::Span<const SelectedChunk> selected,
                                               const LatticePoint& point);
[[nodiscard]] DrawnPoint drawn_point(const TerrainDatabase& database, const DrawnMesh& mesh, const LatticePoint& point);

/// Returns the lift of a chunk's vertex, m; `posts` is the chunk's range.
[[nodiscard]] float vertex_lift_m(const ChunkLift& lift, const PostRange& posts, const ChunkVertex& vertex);
/// Returns the drawn position of a vertex relative to the chunk's centre, m, ECEF axes.
[[nodiscard]] glm::dvec3 drawn_position(const Lattice& lattice, const SelectedChunk& chunk, const PostRange& posts,
                                        const ChunkVertex& vertex);

}  // namespace tedavis::terrain
