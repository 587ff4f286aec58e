/// Makes the triangles of tubes with flat sides, so that neighbouring sides can show different scales, and flat ends.
///
/// Tubes are closed; where the output is full, the tube is closed early, and the remaining rings are counted. Chunks keep
/// indices within 16 bits: a chunk that continues a tube repeats the last ring of the chunk before.
///
/// Memory  the caller's spans. Bounded: each ring is visited once. Pure; any thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"
#include "render_core/scene/trajectory_tube.hpp"

namespace tedavis::scene {

inline constexpr std::uint32_t kDefaultTubeSides = 6, kMinTubeSides = 3, kMaxTubeSides = 24;
inline constexpr std::uint32_t kMaxChunkVertices = 65535;  ///< some devices take index 65535 for a primitive restart
/// The `side` of vertices of the flat ends.
inline constexpr std::uint8_t kTubeEndSide = 0xFF;

struct TubeVertex {
    glm::vec3 position;  ///< m, from the mesh's origin
    /// Unit normal. On a side it is perpendicular to the ring's tangent, even where the radius changes along the tube.
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
    std::uint32_t rings_left_out = 0;  ///< rings for which there was no room
};

/// Meshes rings as make_tube() writes them; markers are skipped. Side 0 faces along each ring's normal, and the corners are
/// half a side off it. `sides` and `chunk_vertices` are clamped to their ranges (a chunk holds at least two rings).
[[nodiscard]] TubeMeshCounts mesh_tube(base::Span<const TubeRing> rings, std::uint32_t sides, const glm::dvec3& origin,
                                       const TubeMeshOutput& output, std::uint32_t chunk_vertices = kMaxChunkVertices) noexcept;

}  // namespace tedavis::scene
