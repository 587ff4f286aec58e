#include "render_core/scene/tube_mesh.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/scene/surface_topology.hpp"

namespace tedavis::scene::test_tube_mesh {
namespace {

using base::kPi;
using base::radians;

const glm::dvec3 kUp(0, 0, 1);

std::vector<TubeRing> rings_along(const std::vector<glm::dvec3>& places, float radius_m = 2) {
    std::vector<TubePoint> points;
    for (const glm::dvec3& place : places) points.push_back({place, {}, radius_m});
    std::vector<TubeRing> rings(2 * points.size());
    rings.resize(make_tube(points, kUp, rings).rings);
    return rings;
}

std::vector<glm::dvec3> spiral(int count) {
    std::vector<glm::dvec3> places;
    for (int n = 0; n < count; ++n) places.emplace_back(80 * std::cos(n * 0.1), 80 * std::sin(n * 0.1), 2.0 * n);
    return places;
}

struct Room {
    std::size_t vertices = 20000, indices = 60000, chunks = 1000;
    std::uint32_t chunk_vertices = kMaxChunkVertices;
};

struct MadeMesh {
    std::vector<TubeVertex> vertices;
    std::vector<std::uint16_t> indices;
    std::vector<TubeChunk> chunks;
    TubeMeshCounts counts;

    /// Over all chunks.
    [[nodiscard]] std::vector<std::uint32_t> whole_indices() const {
        std::vector<std::uint32_t> whole;
        for (const TubeChunk& chunk : chunks)
            for (std::uint32_t n = 0; n < chunk.indices; ++n) {
                const std::uint16_t index = indices[chunk.first_index + n];
                EXPECT_LT(index, chunk.vertices);
                whole.push_back(chunk.first_vertex + index);
            }
        return whole;
    }
    /// Vertices at one place taken for one.
    [[nodiscard]] test_support::SurfaceTopology topology() const {
        std::map<std::array<float, 3>, std::uint32_t> places;
        std::vector<std::uint32_t> welded;
        for (const std::uint32_t n : whole_indices()) {
            const glm::vec3& p = vertices[n].position;
            welded.push_back(places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size())).first->second);
        }
        return test_support::topology_of(welded, places.size());
    }
    [[nodiscard]] double enclosed() const {
        const std::vector<std::uint32_t> whole = whole_indices();
        double sum = 0;
        for (std::size_t n = 0; n < whole.size(); n += 3) {
            const glm::dvec3 a(vertices[whole[n]].position), b(vertices[whole[n + 1]].position),
                c(vertices[whole[n + 2]].position);
            sum += glm::dot(a, glm::cross(b, c)) / 6;
        }
        return sum;
    }
};

MadeMesh mesh_of(const std::vector<TubeRing>& rings, std::uint32_t sides = kDefaultTubeSides, const Room& room = {},
                 const glm::dvec3& origin = {0, 0, 0}) {
    MadeMesh made{std::vector<TubeVertex>(room.vertices),
                  std::vector<std::uint16_t>(room.indices),
                  std::vector<TubeChunk>(room.chunks),
                  {}};
    made.counts = mesh_tube(rings, sides, origin, {made.vertices, made.indices, made.chunks}, room.chunk_vertices);
    made.vertices.resize(made.counts.vertices);
    made.indices.resize(made.counts.indices);
    made.chunks.resize(made.counts.chunks);
    return made;
}

TEST(TubeMesh, AStraightTubeIsAClosedPrism) {
    for (const std::uint32_t sides : {3u, 4u, 6u, 11u, 24u}) {
        const MadeMesh mesh = mesh_of(rings_along({{5, 0, 0}, {9, 0, 0}, {25, 0, 0}}), sides);
        EXPECT_TRUE(mesh.topology().is_closed());
        EXPECT_EQ(mesh.topology().euler_number(), 2);
        EXPECT_NEAR(mesh.enclosed(), 20 * sides / 2.0 * 4 * std::sin(2 * kPi / sides), 1e-4);
        EXPECT_EQ(mesh.counts.rings, 3u);
        EXPECT_EQ(mesh.counts.chunks, 1u);
    }
}

TEST(TubeMesh, TheFirstSideLiesFlatUpwards) {
    const MadeMesh mesh = mesh_of(rings_along({{0, 0, 0}, {10, 0, 0}}));
    int found = 0;
    for (const TubeVertex& vertex : mesh.vertices)
        if (vertex.side == 0) {
            EXPECT_NEAR(vertex.position.z, 2 * std::cos(kPi / 6), 1e-6);
            EXPECT_NEAR(vertex.normal.z, 1, 1e-6);
            ++found;
        }
    EXPECT_EQ(found, 4);
}

TEST(TubeMesh, TrianglesFaceWhereTheirNormalsPointAndKeepToOneSide) {
    const MadeMesh mesh = mesh_of(rings_along(spiral(40)), 7);
    const std::vector<std::uint32_t> whole = mesh.whole_indices();
    std::map<int, int> triangles_of_side;
    for (std::size_t n = 0; n < whole.size(); n += 3) {
        const TubeVertex &a = mesh.vertices[whole[n]], &b = mesh.vertices[whole[n + 1]], &c = mesh.vertices[whole[n + 2]];
        const glm::dvec3 across = glm::cross(glm::dvec3(b.position - a.position), glm::dvec3(c.position - a.position));
        ASSERT_TRUE(a.side == b.side && b.side == c.side);
        EXPECT_GT(glm::dot(glm::normalize(across), glm::dvec3(a.normal)), 0.97);
        EXPECT_NEAR(glm::length(glm::dvec3(a.normal)), 1, 1e-6);
        ++triangles_of_side[a.side];
    }
    for (int side = 0; side < 7; ++side) EXPECT_EQ(triangles_of_side[side], 2 * 39);
    EXPECT_EQ(triangles_of_side[kTubeEndSide], 2 * 5);
    EXPECT_EQ(triangles_of_side.size(), 8u);
}

TEST(TubeMesh, VerticesNameTheirPointAndLieAtItsRadius) {
    const std::vector<glm::dvec3> places = spiral(30);
    const MadeMesh mesh = mesh_of(rings_along(places));
    for (const TubeVertex& vertex : mesh.vertices)
        EXPECT_NEAR(glm::length(glm::dvec3(vertex.position) - places[vertex.source]), 2, 1e-4);
}

TEST(TubeMesh, EveryPieceIsATubeOfItsOwnAndMarkersAreNone) {
    std::vector<glm::dvec3> places = spiral(30);
    places[10].x = places[20].x = places[22].x = std::numeric_limits<double>::quiet_NaN();
    const std::vector<TubeRing> rings = rings_along(places);
    ASSERT_TRUE(rings[19].is_marker);
    const MadeMesh mesh = mesh_of(rings);
    EXPECT_TRUE(mesh.topology().is_closed());
    EXPECT_EQ(mesh.topology().pieces, 3u);
    EXPECT_EQ(mesh.counts.rings, rings.size() - 1);
    EXPECT_EQ(mesh.counts.rings_left_out, 0u);
    EXPECT_EQ(mesh_of({}).counts.vertices, 0u);
    EXPECT_EQ(mesh_of({rings[19]}).counts.vertices, 0u);
}

TEST(TubeMesh, ChunksOfAnySizeHoldTheSameSurface) {
    std::vector<glm::dvec3> places = spiral(120);
    places[50].x = std::numeric_limits<double>::quiet_NaN();
    const std::vector<TubeRing> rings = rings_along(places);
    const MadeMesh whole = mesh_of(rings);
    ASSERT_EQ(whole.chunks.size(), 1u);
    for (const std::uint32_t limit : {0u, 36u, 47u, 48u, 100u, 600u}) {
        Room room;
        room.chunk_vertices = limit;
        const MadeMesh mesh = mesh_of(rings, 6, room);
        EXPECT_GT(mesh.chunks.size(), 1u);
        EXPECT_EQ(mesh.indices.size(), whole.indices.size());
        EXPECT_TRUE(mesh.topology().is_closed());
        EXPECT_EQ(mesh.topology().pieces, 2u);
        EXPECT_NEAR(mesh.enclosed(), whole.enclosed(), 1e-6 * whole.enclosed());
        std::uint32_t vertices = 0, indices = 0;
        for (const TubeChunk& chunk : mesh.chunks) {
            EXPECT_LE(chunk.vertices, std::max(limit, 36u));
            EXPECT_EQ(chunk.first_vertex, vertices);
            EXPECT_EQ(chunk.first_index, indices);
            vertices += chunk.vertices;
            indices += chunk.indices;
        }
        EXPECT_EQ(vertices, mesh.counts.vertices);
        EXPECT_EQ(indices, mesh.counts.indices);
    }
}

TEST(TubeMesh, LongTubesKeepIndicesWithinSixteenBits) {
    const std::vector<TubeRing> rings = rings_along(spiral(12000), 1);
    const MadeMesh mesh = mesh_of(rings, 6, {200000, 500000, 10});
    EXPECT_EQ(mesh.chunks.size(), 3u);
    for (const TubeChunk& chunk : mesh.chunks) EXPECT_LE(chunk.vertices, kMaxChunkVertices);
    EXPECT_EQ(mesh.counts.rings, 12000u);
    EXPECT_EQ(mesh.whole_indices().size(), 36u * 11999 + 24);
}

TEST(TubeMesh, WhereRoomEndsTheTubeIsClosedAndTheRestCounted) {
    const std::vector<TubeRing> rings = rings_along(spiral(40));
    const MadeMesh whole = mesh_of(rings);
    for (const Room& room : {Room{100, 60000, 1000}, {20000, 250, 1000}, {20000, 60000, 2, 60}, {35, 60000, 1000}, {0, 0, 0}}) {
        const MadeMesh mesh = mesh_of(rings, 6, room);
        EXPECT_LT(mesh.counts.rings, 40u);
        EXPECT_NE(mesh.counts.rings, 1u);
        EXPECT_EQ(mesh.counts.rings + mesh.counts.rings_left_out, 40u);
        if (mesh.counts.rings > 0) {
            EXPECT_TRUE(mesh.topology().is_closed());
        }
    }
    const MadeMesh fits = mesh_of(rings, 6, {whole.vertices.size(), whole.indices.size(), 1});
    EXPECT_EQ(fits.counts.rings_left_out, 0u);
    EXPECT_EQ(mesh_of(rings, 6, {whole.vertices.size() - 1, whole.indices.size(), 1}).counts.rings_left_out, 1u);
    EXPECT_EQ(mesh_of(rings, 6, {whole.vertices.size(), whole.indices.size() - 1, 1}).counts.rings_left_out, 1u);
}

TEST(TubeMesh, OnTheEarthVerticesAreExactFromANearOrigin) {
    std::vector<glm::dvec3> places;
    for (int n = 0; n < 30; ++n) places.push_back(earth::to_ecef({radians(46 + 0.001 * n), radians(9), {2000.0 + n}}));
    const std::vector<TubeRing> rings = rings_along(places);
    const glm::dvec3 origin = places[7] + glm::dvec3(100, 200, 300);
    const MadeMesh mesh = mesh_of(rings, 6, {}, origin);
    for (const TubeVertex& vertex : mesh.vertices)
        EXPECT_NEAR(glm::length(glm::dvec3(vertex.position) + origin - places[vertex.source]), 2, 5e-4);
}

TEST(TubeMesh, NumbersOfSidesAreBroughtIntoTheirRange) {
    const std::vector<TubeRing> rings = rings_along({{0, 0, 0}, {10, 0, 0}});
    EXPECT_EQ(mesh_of(rings, 0).counts.vertices, mesh_of(rings, kMinTubeSides).counts.vertices);
    EXPECT_EQ(mesh_of(rings, 1000).counts.vertices, mesh_of(rings, kMaxTubeSides).counts.vertices);
}

TEST(TubeMesh, TheCheckFindsAFlippedTriangle) {
    MadeMesh mesh = mesh_of(rings_along(spiral(10)));
    ASSERT_TRUE(mesh.topology().is_closed());
    std::swap(mesh.indices[40], mesh.indices[41]);
    EXPECT_FALSE(mesh.topology().is_oriented_manifold());
}

}  // namespace
}  // namespace tedavis::scene::test_tube_mesh
