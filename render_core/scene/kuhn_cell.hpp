/// Marching tetrahedra in one cell of a grid: the cell is divided into Kuhn's six tetrahedra, and a table gives, for each set of
/// corners inside the surface, the triangles that separate inside from outside corners.
///
/// Corner n lies at (n & 1, n >> 1 & 1, n >> 2 & 1). Each tetrahedron contains a path from corner 0 to corner 7 that follows the
/// three axes in one of their six orders. Every edge therefore leads from a corner to one with no lower coordinate, and
/// neighbouring cells divide their common face in the same way. H. W. Kuhn, Some combinatorial lemmas in topology, IBM Journal of
/// Research and Development 4 (1960).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace tedavis::scene {

/// An edge of a tetrahedron: from `corner` along the axes in `direction` (bit 0 x, bit 1 y, bit 2 z; 1..7).
struct KuhnEdge {
    std::uint8_t corner = 0;
    std::uint8_t direction = 0;
};

inline constexpr int kMaxKuhnTriangles = 12;

/// The triangles of a case, given by the edges on which their corners lie; counter-clockwise seen from outside.
struct KuhnCase {
    std::uint8_t triangles = 0;
    KuhnEdge edge[kMaxKuhnTriangles][3]{};
};

namespace kuhn {

struct Tetrahedron {
    int corner[4];
    bool right_handed;  ///< orientation of its edges from the first corner
};

constexpr KuhnEdge edge_between(int a, int b) {
    const int low = a < b ? a : b;
    return {static_cast<std::uint8_t>(low), static_cast<std::uint8_t>(a ^ b)};
}

constexpr void add_triangle(KuhnCase& made, KuhnEdge a, KuhnEdge b, KuhnEdge c) {
    const int n = made.triangles++;
    made.edge[n][0] = a;
    made.edge[n][1] = b;
    made.edge[n][2] = c;
}

/// The corners of the tetrahedron, inside corners first. Two corners of the same kind are exchanged where needed, so the
/// tetrahedron is right-handed.
struct SortedCorners {
    int corner[4]{};
    int inside = 0;
};

constexpr SortedCorners sorted(const Tetrahedron& cut, int inside_bits) {
    SortedCorners made;
    bool right_handed = cut.right_handed;
    int outside[4]{}, outsiders = 0;
    for (const int corner : cut.corner) {
        if ((inside_bits >> corner & 1) != 0) {
            made.corner[made.inside++] = corner;
            if (outsiders % 2 == 1) right_handed = !right_handed;  // it moved past this many corners
        } else {
            outside[outsiders++] = corner;
        }
    }
    for (int n = 0; n < outsiders; ++n) made.corner[made.inside + n] = outside[n];
    if (!right_handed) {
        const int n = made.inside >= 2 ? 0 : 2;  // two corners of the same kind
        const int kept = made.corner[n];
        made.corner[n] = made.corner[n + 1];
        made.corner[n + 1] = kept;
    }
    return made;
}

constexpr void cut_tetrahedron(KuhnCase& made, const Tetrahedron& cut, int inside_bits) {
    const SortedCorners by_kind = sorted(cut, inside_bits);
    const auto edge = [&](int a, int b) { return edge_between(by_kind.corner[a], by_kind.corner[b]); };
    if (by_kind.inside == 1) add_triangle(made, edge(0, 1), edge(0, 2), edge(0, 3));
    if (by_kind.inside == 2) {
        add_triangle(made, edge(0, 2), edge(0, 3), edge(1, 3));
        add_triangle(made, edge(0, 2), edge(1, 3), edge(1, 2));
    }
    if (by_kind.inside == 3) add_triangle(made, edge(0, 3), edge(1, 3), edge(2, 3));
}

constexpr std::array<KuhnCase, 256> make_cases() {
    std::array<KuhnCase, 256> cases{};
    for (int inside_bits = 0; inside_bits < 256; ++inside_bits)
        for (int first = 0; first < 3; ++first)
            for (int step = 1; step < 3; ++step) {
                const int second = (first + step) % 3;
                const Tetrahedron cut{{0, 1 << first, 1 << first | 1 << second, 7}, step == 1};
                cut_tetrahedron(cases[static_cast<std::size_t>(inside_bits)], cut, inside_bits);
            }
    return cases;
}

}  // namespace kuhn

/// The cases, indexed by the inside corners: bit n for corner n.
inline constexpr std::array<KuhnCase, 256> kKuhnCases = kuhn::make_cases();

}  // namespace tedavis::scene
