/// Geometry of right-triangulated irregular networks on an integer lattice: which vertex splits which triangles.
///
/// Every lattice vertex but the root's corners is the middle of one hypotenuse. Its scale s is the lowest set bit of its
/// coordinates. Both odd multiples of s: the hypotenuse is a diagonal of the square of side 2s round it. One odd: the
/// hypotenuse is axis-parallel, of length 2s. Diagonals join the corners (p,q)*side with p+q even.
/// Source: Evans, Kirkpatrick, Townsend, Algorithmica 30 (2001); parity form derived here.
#pragma once

#include <cstdint>

namespace tedavis::terrain {

struct LatticeVertex {
    std::int64_t i = 0, j = 0;
};

[[nodiscard]] constexpr std::int64_t lattice_scale(LatticeVertex v) {
    const std::int64_t bits = v.i | v.j;
    return bits & -bits;
}

/// The two vertices whose splits created the triangles that `v` splits; v is in a conforming mesh only if both are
/// (or lie outside the domain). Order is fixed.
struct VertexParents {
    LatticeVertex first, second;
};
[[nodiscard]] constexpr VertexParents parents_of(LatticeVertex v) {
    const std::int64_t s = lattice_scale(v);
    const bool i_odd = ((v.i / s) & 1) != 0;
    const bool j_odd = ((v.j / s) & 1) != 0;
    if (i_odd && j_odd) {
        const bool north_west_even = (((v.i - s) / (2 * s) + (v.j - s) / (2 * s)) & 1) == 0;
        return north_west_even ? VertexParents{{v.i + s, v.j - s}, {v.i - s, v.j + s}}
                               : VertexParents{{v.i - s, v.j - s}, {v.i + s, v.j + s}};
    }
    return i_odd ? VertexParents{{v.i, v.j - s}, {v.i, v.j + s}} : VertexParents{{v.i - s, v.j}, {v.i + s, v.j}};
}

/// A right isosceles triangle: a and b end the hypotenuse, c is the apex. Wound (a, b, c).
struct LatticeTriangle {
    LatticeVertex a, b, c;

    [[nodiscard]] constexpr LatticeVertex middle() const { return {(a.i + b.i) / 2, (a.j + b.j) / 2}; }
    /// Both halves keep the winding.
    [[nodiscard]] constexpr LatticeTriangle half_at_a() const { return {c, a, middle()}; }
    [[nodiscard]] constexpr LatticeTriangle half_at_b() const { return {b, c, middle()}; }
    /// Its legs have length 1: it cannot be split.
    [[nodiscard]] constexpr bool is_unit() const {
        const std::int64_t di = a.i - b.i, dj = a.j - b.j;
        return di * di + dj * dj == 2;
    }
};

/// The two triangles of the square [i, i+side] x [j, j+side]; i and j must be multiples of side. Winding: counter-
/// clockwise seen from above with i to the east and j to the south.
[[nodiscard]] constexpr LatticeTriangle square_triangle(std::int64_t i, std::int64_t j, std::int64_t side, bool second) {
    const LatticeVertex nw{i, j}, ne{i + side, j}, sw{i, j + side}, se{i + side, j + side};
    if (((i / side + j / side) & 1) == 0) return second ? LatticeTriangle{nw, se, ne} : LatticeTriangle{se, nw, sw};
    return second ? LatticeTriangle{ne, sw, se} : LatticeTriangle{sw, ne, nw};
}

}  // namespace tedavis::terrain
