/// The surface as it is drawn, at a place: what stands on the ground stands on it.
///
/// A place lies in the triangle that holds it in lattice coordinates, and has its weights there; its position is the same mean of
/// the corners' ECEF positions, lifts included. A triangle with one corner on a pole holds the meridians between its other two.
/// Vertices are lifted along the ellipsoid's normal at their post. Pure functions; any thread.
#pragma once

#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

/// A chunk as it is drawn: its vertices and the index list for its present coarser edges.
struct DrawnMesh {
    const SelectedChunk* chunk = nullptr;
    base::Span<const ChunkVertex> vertices;
    base::Span<const std::uint16_t> indices;
};

/// Meshes of the chunks that a frame selected, on the display's thread.
class DrawnMeshes {
public:
    [[nodiscard]] virtual base::Span<const ChunkVertex> vertices(const SelectedChunk& chunk) = 0;
    /// As the payload has them; empty for a regular chunk.
    [[nodiscard]] virtual base::Span<const std::uint16_t> stored_indices(const SelectedChunk& chunk) = 0;
    /// As they are drawn; valid until the next call.
    [[nodiscard]] virtual base::Span<const std::uint16_t> drawn_indices(const SelectedChunk& chunk) = 0;

protected:
    DrawnMeshes() = default;
    DrawnMeshes(const DrawnMeshes&) = default;
    DrawnMeshes& operator=(const DrawnMeshes&) = default;
    ~DrawnMeshes() = default;
};

struct DrawnPoint {
    bool found = false;  ///< false: no triangle there
    earth::Ecef position{};
    earth::MslHeight height;
    PostClass post_class = PostClass::outside;  ///< of the heaviest corner; void_ where a corner is void
};

/// The selected chunk over a lattice point; null when none is.
[[nodiscard]] const SelectedChunk* chunk_under(const Lattice& lattice, base::Span<const SelectedChunk> selected,
                                               const LatticePoint& point);
[[nodiscard]] DrawnPoint drawn_point(const TerrainDatabase& database, const DrawnMesh& mesh, const LatticePoint& point);

/// Metres by which a vertex of a chunk is raised; `posts` is the chunk's range.
[[nodiscard]] float vertex_lift_m(const ChunkLift& lift, const PostRange& posts, const ChunkVertex& vertex);
/// Where a vertex is drawn, from the chunk's centre, m in ECEF axes.
[[nodiscard]] glm::dvec3 drawn_position(const Lattice& lattice, const SelectedChunk& chunk, const PostRange& posts,
                                        const ChunkVertex& vertex);

}  // namespace tedavis::terrain
