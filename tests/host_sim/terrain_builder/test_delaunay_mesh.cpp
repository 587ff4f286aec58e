#include "host_sim/terrain_builder/delaunay_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace tedavis::host_sim::test_delaunay_mesh {
namespace {

__extension__ using Wide = __int128;

/// Posts on the four sides, `step` apart, clockwise from the north-west corner.
std::vector<MeshPost> border_of(std::int32_t last_i, std::int32_t last_j, std::int32_t step) {
    std::vector<MeshPost> border;
    for (std::int32_t i = 0; i < last_i; i += step) border.push_back({i, 0});
    for (std::int32_t j = 0; j < last_j; j += step) border.push_back({last_i, j});
    for (std::int32_t i = last_i; i > 0; i -= step) border.push_back({i, last_j});
    for (std::int32_t j = last_j; j > 0; j -= step) border.push_back({0, j});
    return border;
}

/// The determinant of the circle test, in integers that hold it for any post: positive when d lies inside.
Wide in_circle(MeshPost a, MeshPost b, MeshPost c, MeshPost d) {
    const auto row = [&](MeshPost p) {
        const Wide x = p.i - d.i, y = d.j - p.j;  // north up
        return std::array<Wide, 3>{x, y, x * x + y * y};
    };
    const auto [ax, ay, aa] = row(a);
    const auto [bx, by, bb] = row(b);
    const auto [cx, cy, cc] = row(c);
    return ax * (by * cc - bb * cy) - ay * (bx * cc - bb * cx) + aa * (bx * cy - by * cx);
}

void expect_sound(const DelaunayMesh& mesh, MeshPost last, std::size_t on_border) {
    std::int64_t area = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> sides;
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
        const std::int64_t own = turn(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
        ASSERT_GT(own, 0) << "wound the wrong way, or without area";
        area += own;
        for (int k = 0; k < 3; ++k) {
            const auto& corner = mesh.triangles()[t].corner;
            ASSERT_TRUE(sides.insert({{corner[k], corner[(k + 1) % 3]}, t}).second) << "two triangles on one side of an edge";
        }
    }
    EXPECT_EQ(area, 2 * std::int64_t{last.i} * last.j);
    EXPECT_EQ(mesh.triangles().size(), 2 * mesh.vertices().size() - 2 - on_border) << "Euler";
    std::size_t open = 0;
    for (const auto& [side, t] : sides) {
        const auto back = sides.find({side.second, side.first});
        const auto& triangle = mesh.triangles()[t];
        int k = 0;
        while (triangle.corner[k] != side.first) ++k;
        if (back != sides.end()) {
            ASSERT_EQ(triangle.beyond[k], back->second);
            continue;
        }
        ++open;
        ASSERT_EQ(triangle.beyond[k], DelaunayMesh::kNone);
        ASSERT_EQ(side.first, (side.second + 1) % on_border) << "a side of the rectangle joins neighbours of the border";
    }
    EXPECT_EQ(open, on_border);
}

std::size_t vertices_in_circles(const DelaunayMesh& mesh) {
    std::size_t inside = 0;
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
        for (const MeshPost& v : mesh.vertices())
            inside += in_circle(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2), v) > 0 ? 1 : 0;
    return inside;
}

TEST(DelaunayMesh, IsSoundAndEmptyOfVerticesInCircles) {
    std::mt19937 random(1);
    for (const MeshPost last : {MeshPost{16, 16}, {32, 8}, {8, 40}, {1000, 1000}, {32768, 32768}, {32768, 4096}}) {
        const std::vector<MeshPost> border = border_of(last.i, last.j, std::max(1, std::min(last.i, last.j) / 4));
        DelaunayMesh mesh(border);
        ASSERT_EQ(mesh.vertices(), border);
        expect_sound(mesh, last, border.size());
        std::set<std::pair<std::int32_t, std::int32_t>> used;
        for (int n = 0; n < 60; ++n) {
            const MeshPost post{1 + static_cast<std::int32_t>(random() % (last.i - 1)),
                                1 + static_cast<std::int32_t>(random() % (last.j - 1))};
            if (!used.insert({post.i, post.j}).second) continue;
            const auto start = static_cast<std::uint32_t>(random() % mesh.triangles().size());
            const std::uint32_t home = mesh.locate(post, start);
            for (int k = 0; k < 3; ++k) ASSERT_GE(turn(mesh.corner(home, k), mesh.corner(home, (k + 1) % 3), post), 0);
            for (std::uint32_t t = 0; t < mesh.triangles().size(); t += 7) ASSERT_EQ(mesh.locate(post, t), home);
            const std::uint32_t vertex = mesh.insert(post, home);
            ASSERT_EQ(vertex, mesh.vertices().size() - 1);
            for (const std::uint32_t t : mesh.star()) ASSERT_EQ(mesh.triangles()[t].corner[0], vertex);
        }
        expect_sound(mesh, last, border.size());
        EXPECT_EQ(vertices_in_circles(mesh), 0u) << last.i << " x " << last.j;
    }
}

TEST(DelaunayMesh, TheStarIsAllThatChanges) {
    std::mt19937 random(2);
    DelaunayMesh mesh(border_of(64, 64, 8));
    for (int n = 0; n < 200; ++n) {
        const MeshPost post{1 + static_cast<std::int32_t>(random() % 63), 1 + static_cast<std::int32_t>(random() % 63)};
        if (std::count(mesh.vertices().begin(), mesh.vertices().end(), post) != 0) continue;
        const std::vector<DelaunayMesh::Triangle> before = mesh.triangles();
        mesh.insert(post, mesh.locate(post, 0));
        const std::set<std::uint32_t> star(mesh.star().begin(), mesh.star().end());
        ASSERT_EQ(star.size(), mesh.star().size());
        for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
            const auto& corners = mesh.triangles()[t].corner;
            const bool same = t < before.size() && std::equal(corners, corners + 3, before[t].corner);
            ASSERT_EQ(same, star.count(t) == 0) << t;
        }
    }
}

/// Of the triangles' sides, those with both ends in one cell that run from its north-west to its south-east corner.
std::size_t other_diagonals(const DelaunayMesh& mesh) {
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const MeshPost a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3);
            count += (b.i - a.i == 1 && b.j - a.j == 1) ? 1 : 0;
        }
    return count;
}

TEST(DelaunayMesh, WholeCellsAreCutAsTheTrueSurfaceIs) {
    std::vector<MeshPost> inner;
    for (std::int32_t j = 1; j < 12; ++j)
        for (std::int32_t i = 1; i < 12; ++i) inner.push_back({i, j});
    std::mt19937 random(3);
    for (int run = 0; run < 20; ++run) {
        std::shuffle(inner.begin(), inner.end(), random);
        DelaunayMesh mesh(border_of(12, 12, 1));
        std::size_t on_the_way = 0;
        for (const MeshPost& post : inner) {
            mesh.insert(post, mesh.locate(post, 0));
            on_the_way += other_diagonals(mesh);
        }
        expect_sound(mesh, {12, 12}, 48);
        EXPECT_EQ(other_diagonals(mesh), 0u);
        EXPECT_GT(on_the_way, 0u) << "a control: incomplete cells have them";
    }
}

bool has_side(const DelaunayMesh& mesh, std::uint32_t a, std::uint32_t b) {
    for (const auto& t : mesh.triangles())
        if (std::count(t.corner, t.corner + 3, a) + std::count(t.corner, t.corner + 3, b) == 2) return true;
    return false;
}

TEST(DelaunayMesh, CirclesAreDecidedExactly) {
    // Three posts of the largest circle round (16384, 16384) and one that is a single post off it: the diagonal turns.
    const MeshPost last{32768, 32768};
    for (const std::int32_t off : {-1, 1}) {
        DelaunayMesh mesh({{0, 0}, {last.i, 0}, last, {0, last.j}});
        for (const MeshPost post : {MeshPost{16384 - 9828, 16384 - 13104},
                                    {16384 + 9828, 16384 - 13104},
                                    {16384 + 13104, 16384 + 9828},
                                    {16384 - 13104 + off, 16384 + 9828}})
            mesh.insert(post, mesh.locate(post, 0));
        EXPECT_EQ(vertices_in_circles(mesh), 0u) << off;
        EXPECT_EQ(has_side(mesh, 4, 6), off < 0) << "outside the circle of the others";
        EXPECT_EQ(has_side(mesh, 5, 7), off > 0) << "inside";
    }
}

TEST(DelaunayMesh, ARectangleWithoutInnerPosts) {
    DelaunayMesh bare({{0, 0}, {7, 0}, {7, 3}, {0, 3}});
    expect_sound(bare, {7, 3}, 4);
    EXPECT_EQ(bare.corner(0, 1), (MeshPost{0, 3}));
    EXPECT_EQ(bare.corner(0, 2), (MeshPost{7, 0})) << "cut as the true surface's cells are";
    const std::vector<MeshPost> dense = border_of(700, 900, 1);
    const DelaunayMesh mesh(dense);
    expect_sound(mesh, {700, 900}, dense.size());
}

}  // namespace
}  // namespace tedavis::host_sim::test_delaunay_mesh
