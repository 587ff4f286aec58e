/// Triangles of tubes: flat sides, so that neighbouring sides can carry different scales, and flat ends.
///
/// Tubes are closed; where room ends, so does the tube, with an end of its own, and the rings behind are counted. Chunks keep
/// indices within 16 bits: a chunk that goes on with a tube repeats the ring where the one before stopped.
///
/// Memory  the caller's spans. Bounded: one visit a ring. Pure; any thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"
#include "render_core/scene/trajectory_tube.hpp"

namespace tedavis::scene {

inline constexpr std::uint32_t kDefaultTubeSides = 6, kMinTubeSides = 3, kMaxTubeSides = 24;
inline constexpr std::uint32_t kMaxChunkVertices = 65535;  ///< one less than 16 bits, which some devices take for a restart
/// The side of the vertices of flat ends.
inline constexpr std::uint8_t kTubeEndSide = 0xFF;

struct TubeVertex {
    glm::vec3 position;  ///< m, from the mesh's origin
    /// Unit length. Of a side: across the ring's tangent, however the radius changes along the tube.
    glm::vec3 normal;
    std::uint32_t source;  ///< the ring's
    std::uint8_t side;     ///< 0 .. sides - 1, from the ring's normal towards its binormal; or kTubeEndSide
};

struct TubeChunk {
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_index = 0, indices = 0;
};

struct TubeMeshOutput {
    base::Span<TubeVertex> vertices;
    base::Span<std::uint16_t> indices;  ///< from the chunk's first vertex; counter-clockwise seen from outside
    base::Span<TubeChunk> chunks;
};

struct TubeMeshCounts {
    std::uint32_t vertices = 0, indices = 0, chunks = 0;
    std::uint32_t rings = 0;           ///< meshed
    std::uint32_t rings_left_out = 0;  ///< for want of room
};

/// Rings as make_tube() leaves them; markers have no tube and are passed over. Side 0 faces along each ring's normal; half a side
/// beside it the corners begin. `sides` and `chunk_vertices` are brought into their ranges (a chunk holds two rings at least).
[[nodiscard]] TubeMeshCounts mesh_tube(base::Span<const TubeRing> rings, std::uint32_t sides, const glm::dvec3& origin,
                                       const TubeMeshOutput& output, std::uint32_t chunk_vertices = kMaxChunkVertices) noexcept;

}  // namespace tedavis::scene
