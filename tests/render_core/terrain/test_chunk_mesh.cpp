#include "render_core/terrain/chunk_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "render_core/terrain/regular_chunk.hpp"
#include "tests/support/files/hard_case.hpp"

namespace tedavis::terrain::test_chunk_mesh {
namespace {

using Indices = std::vector<std::uint16_t>;

/// A regular chunk of flat ground, one post a metre.
struct FlatChunk {
    ChunkEntry entry{};
    std::vector<ChunkVertex> vertices;
    std::vector<std::uint16_t> stored;  ///< empty: regular

    FlatChunk(std::uint32_t columns, std::uint32_t rows) {
        const RegularGrid grid{columns, rows};
        vertices.resize(grid.vertex_count());
        for (std::uint32_t j = 0; j < rows; ++j)
            for (std::uint32_t i = 0; i < columns; ++i) {
                ChunkVertex& v = vertices[grid.index_of(i, j)];
                v.x = static_cast<float>(i);
                v.y = static_cast<float>(j);
                v.i = static_cast<std::uint16_t>(i);
                v.j = static_cast<std::uint16_t>(j);
            }
        entry.flags = kChunkRegular;
        entry.vertex_count = static_cast<std::uint16_t>(grid.vertex_count());
        entry.border_count = static_cast<std::uint16_t>(grid.border_count());
        entry.triangle_count = static_cast<std::uint16_t>(grid.triangle_count());
    }

    void keep_beside_coarser(std::uint32_t vertex) { vertices[vertex].kind |= 4; }
    [[nodiscard]] MeshCount build(std::uint8_t coarser_edges, Indices& indices) const {
        const auto scratch = std::make_unique<ChunkMeshScratch>();
        indices.resize(kMaxChunkTriangles * 3);
        const MeshCount count = build_chunk_indices(entry, {vertices.data(), vertices.size()}, {stored.data(), stored.size()},
                                                    coarser_edges, *scratch, {indices.data(), indices.size()});
        indices.resize(count.indices);
        return count;
    }
};

std::int64_t twice_area(const ChunkVertex& a, const ChunkVertex& b, const ChunkVertex& c) {
    return (std::int64_t{b.j} - a.j) * (std::int64_t{c.i} - a.i) - (std::int64_t{b.i} - a.i) * (std::int64_t{c.j} - a.j);
}

/// Sides that belong to one triangle only, as pairs in its direction.
std::set<std::pair<int, int>> open_sides(const Indices& indices) {
    std::set<std::pair<int, int>> sides;
    for (std::size_t n = 0; n < indices.size(); n += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = indices[n + k], b = indices[n + (k + 1) % 3];
            EXPECT_TRUE(sides.erase({b, a}) != 0 || sides.insert({a, b}).second) << "two triangles on one side";
        }
    return sides;
}

/// Every triangle is counter-clockwise, together they fill the rectangle, and their border is `border`, clockwise.
void expect_fills(const FlatChunk& chunk, const Indices& indices, const std::vector<int>& border, std::int64_t cells) {
    std::int64_t area = 0;
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        const std::int64_t of_one =
            twice_area(chunk.vertices[indices[n]], chunk.vertices[indices[n + 1]], chunk.vertices[indices[n + 2]]);
        EXPECT_GT(of_one, 0);
        area += of_one;
    }
    EXPECT_EQ(area, 2 * cells);
    std::set<std::pair<int, int>> expected;
    for (std::size_t n = 0; n < border.size(); ++n) expected.insert({border[(n + 1) % border.size()], border[n]});
    EXPECT_EQ(open_sides(indices), expected);
}

TEST(ChunkMesh, RegularChunkIsTwoTrianglesACellCutAlongTheSurfacesDiagonal) {
    const FlatChunk chunk(4, 3);
    Indices indices;
    ASSERT_TRUE(chunk.build(0, indices).sound);
    ASSERT_EQ(indices.size(), 3u * 2 * 3 * 2);
    std::vector<int> border;
    for (int n = 0; n < chunk.entry.border_count; ++n) border.push_back(n);
    expect_fills(chunk, indices, border, 6);
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        int on_diagonal = 0;
        int least_i = 99, least_j = 99;
        for (std::size_t k = 0; k < 3; ++k) {
            least_i = std::min<int>(least_i, chunk.vertices[indices[n + k]].i);
            least_j = std::min<int>(least_j, chunk.vertices[indices[n + k]].j);
        }
        for (std::size_t k = 0; k < 3; ++k)
            on_diagonal += chunk.vertices[indices[n + k]].i + chunk.vertices[indices[n + k]].j == least_i + least_j + 1;
        EXPECT_EQ(on_diagonal, 2);
    }
}

struct Side {
    EdgeBit bit;
    std::uint32_t first, last;  // border vertices, corners included
};

std::vector<Side> sides_of(std::uint32_t columns, std::uint32_t rows) {
    const std::uint32_t ne = columns - 1, se = ne + rows - 1, sw = se + columns - 1;
    return {{kEdgeNorth, 0, ne}, {kEdgeEast, ne, se}, {kEdgeSouth, se, sw}, {kEdgeWest, sw, sw + rows - 1}};
}

TEST(ChunkMesh, BesideCoarserNeighboursOnlyMarkedVerticesAreLeftAndNothingOpens) {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t columns = 2 + random() % 16, rows = 2 + random() % 16;
        FlatChunk chunk(columns, rows);
        for (std::uint32_t n = 0; n < chunk.entry.border_count; ++n)
            if (random() % 3 == 0) chunk.keep_beside_coarser(n);
        for (std::uint8_t mask = 0; mask < 16; ++mask) {
            std::vector<int> border;
            for (const Side& side : sides_of(columns, rows))
                for (std::uint32_t n = side.first; n < side.last; ++n)
                    if (n == side.first || (mask & side.bit) == 0 || chunk.vertices[n].stays_beside_coarser())
                        border.push_back(static_cast<int>(n));
            Indices indices;
            ASSERT_TRUE(chunk.build(mask, indices).sound) << columns << "x" << rows << " mask " << int{mask};
            expect_fills(chunk, indices, border, std::int64_t{columns - 1} * (rows - 1));
        }
    }
}

TEST(ChunkMesh, StoredTrianglesGiveTheSameAsTheRegularOnes) {
    FlatChunk regular(9, 9), stored(9, 9);
    Indices base;
    ASSERT_TRUE(regular.build(0, base).sound);
    stored.entry.flags = 0;
    stored.stored = base;
    Indices a, b;
    ASSERT_TRUE(regular.build(kEdgeNorth | kEdgeWest, a).sound);
    ASSERT_TRUE(stored.build(kEdgeNorth | kEdgeWest, b).sound);
    EXPECT_EQ(a, b);
}

/// Triangles whose normal, the cross product of two sides by its length, is no number.
int without_normal(const FlatChunk& chunk, const Indices& indices) {
    int found = 0;
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        const ChunkVertex &a = chunk.vertices[indices[n]], &b = chunk.vertices[indices[n + 1]],
                          &c = chunk.vertices[indices[n + 2]];
        const float up = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        found += std::isfinite(up / std::fabs(up)) ? 0 : 1;
    }
    return found;
}

TEST(ChunkMesh, TrianglesOfAPoleRowAreLeftOut) {
    FlatChunk chunk(5, 3);
    Indices naive;  // as of any other row
    ASSERT_TRUE(chunk.build(0, naive).sound);
    for (ChunkVertex& v : chunk.vertices)
        if (v.j == 0) v.x = 0;
    Indices indices;
    ASSERT_TRUE(chunk.build(0, indices).sound);
    EXPECT_EQ(indices.size(), 3u * (2 * 4 * 2 - 4));
    EXPECT_EQ(without_normal(chunk, indices), 0);
    EXPECT_EQ(without_normal(chunk, naive), 4) << "control: one side has no length";
    test_support::record_worst("A04", without_normal(chunk, indices));
    test_support::record_control("A04", without_normal(chunk, naive));
    ASSERT_TRUE(chunk.build(kEdgeEast, indices).sound);
}

TEST(ChunkMesh, ContradictionsAreRefused) {
    FlatChunk chunk(5, 5);
    Indices good, indices;
    ASSERT_TRUE(chunk.build(0, good).sound);
    chunk.entry.flags = 0;
    chunk.stored = good;
    chunk.stored[4] = 25;  // beyond the vertices
    EXPECT_FALSE(chunk.build(0, indices).sound);
    chunk.stored = good;
    chunk.stored.resize(3);  // a border vertex without triangles
    EXPECT_FALSE(chunk.build(kEdgeSouth, indices).sound);
    chunk.entry.vertex_count = 24;
    EXPECT_FALSE(chunk.build(0, indices).sound);
    FlatChunk odd(5, 5);
    odd.entry.border_count = 15;
    EXPECT_FALSE(odd.build(0, indices).sound);
}

}  // namespace
}  // namespace tedavis::terrain::test_chunk_mesh
