/// Delaunay triangulation of lattice posts in a rectangle, grown post by post: Lawson's flips (Lawson, "Software for C1
/// Surface Interpolation", 1977), decided in exact integers (angle form of the circle test: Cline, Renka, "A storage-efficient
/// method for construction of a Thiessen triangulation", Rocky Mountain J. Math. 14(1), 1984).
///
/// Posts are whole, i east, j south, 0..kLastPost. Triangles are wound counter-clockwise seen from above and never degenerate. Of
/// four posts on a circle, the diagonal nearer to that of the true surface, i + j = const, is used.
#pragma once

#include <cstdint>
#include <vector>

namespace tedavis::host_sim {

struct MeshPost {
    std::int32_t i = 0, j = 0;

    [[nodiscard]] constexpr bool operator==(const MeshPost& o) const { return i == o.i && j == o.j; }
    [[nodiscard]] constexpr bool operator!=(const MeshPost& o) const { return !(*this == o); }
};

/// Twice the area of a, b, c; positive when they turn counter-clockwise seen from above.
[[nodiscard]] constexpr std::int64_t turn(MeshPost a, MeshPost b, MeshPost c) {
    return std::int64_t{b.j - a.j} * (c.i - a.i) - std::int64_t{b.i - a.i} * (c.j - a.j);
}

class DelaunayMesh {
public:
    static constexpr std::int32_t kLastPost = 32768;
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    /// Side k runs from corner k to corner k+1.
    struct Triangle {
        std::uint32_t corner[3];
        std::uint32_t beyond[3];  ///< the triangle on the other side of side k; kNone at the rectangle's sides
    };

    /// The rectangle's own mesh: `border` are the posts on its four sides, clockwise seen from above from the north-west
    /// corner, which is (0, 0); all four corners are among them. They become vertices 0, 1, ...
    explicit DelaunayMesh(const std::vector<MeshPost>& border);

    [[nodiscard]] const std::vector<MeshPost>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    [[nodiscard]] MeshPost corner(std::uint32_t triangle, int k) const { return vertices_[triangles_[triangle].corner[k]]; }

    /// Returns the triangle that contains the post, which must lie in the rectangle; on a side, that with the lower number. The
    /// search begins at triangle `start`.
    [[nodiscard]] std::uint32_t locate(MeshPost post, std::uint32_t start) const;

    /// Makes a vertex of a post that lies in `triangle`, on none of its corners and not on the rectangle's sides. star() then has
    /// all new or changed triangles: those around the vertex, which is corner 0 of each.
    std::uint32_t insert(MeshPost post, std::uint32_t triangle);
    [[nodiscard]] const std::vector<std::uint32_t>& star() const { return star_; }

private:
    void place_on_side(std::uint32_t first, std::uint32_t last);
    [[nodiscard]] std::uint32_t hull_triangle(std::uint32_t from, std::uint32_t to) const;
    void split_inside(std::uint32_t triangle, std::uint32_t vertex);
    void split_side(std::uint32_t triangle, int side, std::uint32_t vertex);
    void legalise();
    [[nodiscard]] bool must_flip(std::uint32_t p, std::uint32_t a, std::uint32_t b, std::uint32_t d) const;
    void flip(std::uint32_t triangle, std::uint32_t other, int side);
    [[nodiscard]] int side_towards(std::uint32_t triangle, std::uint32_t neighbour) const;
    void relink(std::uint32_t triangle, std::uint32_t before, std::uint32_t now);

    std::vector<MeshPost> vertices_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> star_;
    std::vector<std::uint32_t> open_;  // star triangles whose side 1 has not been checked
};

}  // namespace tedavis::host_sim
