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

}  // namespace tedavis::terrain
