/// What a set of triangles is as a surface, from its indices alone: edges by their uses, fans round vertices, Euler number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace tedavis::test_support {

struct SurfaceTopology {
    std::size_t vertices = 0;  ///< that triangles use
    std::size_t edges = 0;
    std::size_t triangles = 0;
    std::size_t border_edges = 0;     ///< of one triangle
    std::size_t crowded_edges = 0;    ///< of more than two
    std::size_t clashing_edges = 0;   ///< of two that run along it in the same direction
    std::size_t collapsed = 0;        ///< edges from a vertex to itself
    std::size_t split_vertices = 0;   ///< with more than one fan of triangles
    std::size_t unused_vertices = 0;  ///< below the number given
    std::size_t pieces = 0;

    [[nodiscard]] long euler_number() const {
        return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(triangles);
    }
    [[nodiscard]] bool is_oriented_manifold() const {
        return crowded_edges == 0 && clashing_edges == 0 && collapsed == 0 && split_vertices == 0;
    }
    [[nodiscard]] bool is_closed() const { return is_oriented_manifold() && border_edges == 0; }
};

/// Disjoint sets of numbers.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t find(std::size_t n) {
        while (parent_[n] != n) n = parent_[n] = parent_[parent_[n]];
        return n;
    }
    void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }
    [[nodiscard]] std::size_t count(const std::vector<bool>& of) {
        std::size_t found = 0;
        for (std::size_t n = 0; n < parent_.size(); ++n) found += of[n] && find(n) == n ? 1 : 0;
        return found;
    }

private:
    std::vector<std::size_t> parent_;
};

namespace surface_topology_parts {

struct EdgeUse {
    int forwards = 0, backwards = 0;
    std::vector<std::size_t> triangles;  ///< by their first corners
};

using Edges = std::map<std::pair<std::size_t, std::size_t>, EdgeUse>;

template <class Index>
Edges edges_of(const std::vector<Index>& indices) {
    Edges edges;
    for (std::size_t n = 0; n + 2 < indices.size(); n += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = indices[n + k], b = indices[n + (k + 1) % 3];
            EdgeUse& use = edges[std::minmax(a, b)];
            ++(a < b ? use.forwards : use.backwards);
            use.triangles.push_back(n);
        }
    return edges;
}

inline void count_edges(const Edges& edges, SurfaceTopology& found) {
    found.edges = edges.size();
    for (const auto& [ends, use] : edges) {
        const int uses = use.forwards + use.backwards;
        found.collapsed += ends.first == ends.second ? 1 : 0;
        found.border_edges += uses == 1 ? 1 : 0;
        found.crowded_edges += uses > 2 ? 1 : 0;
        found.clashing_edges += uses == 2 && use.forwards != 1 ? 1 : 0;
    }
}

/// Corners of triangles at one vertex belong to one fan where the triangles share an edge that ends there.
template <class Index>
std::size_t vertices_with_more_fans(const Edges& edges, const std::vector<Index>& indices, std::size_t vertex_count) {
    DisjointSets corners(indices.size());
    const auto corner_at = [&](std::size_t triangle, std::size_t vertex) {
        std::size_t corner = triangle;
        while (indices[corner] != vertex) ++corner;
        return corner;
    };
    for (const auto& [ends, use] : edges)
        for (const std::size_t triangle : use.triangles)
            for (const std::size_t vertex : {ends.first, ends.second})
                corners.join(corner_at(use.triangles[0], vertex), corner_at(triangle, vertex));
    std::vector<int> fans(vertex_count, 0);
    for (std::size_t n = 0; n < indices.size(); ++n) fans[indices[n]] += corners.find(n) == n ? 1 : 0;
    return static_cast<std::size_t>(std::count_if(fans.begin(), fans.end(), [](int n) { return n > 1; }));
}

}  // namespace surface_topology_parts

/// `indices`: three a triangle, below `vertex_count`.
template <class Index>
SurfaceTopology topology_of(const std::vector<Index>& indices, std::size_t vertex_count) {
    using namespace surface_topology_parts;
    SurfaceTopology found;
    const Edges edges = edges_of(indices);
    count_edges(edges, found);
    DisjointSets pieces(vertex_count);
    for (const auto& [ends, use] : edges) pieces.join(ends.first, ends.second);
    std::vector<bool> used(vertex_count, false);
    for (const Index index : indices) used[index] = true;
    found.triangles = indices.size() / 3;
    found.split_vertices = vertices_with_more_fans(edges, indices, vertex_count);
    found.vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
    found.unused_vertices = vertex_count - found.vertices;
    found.pieces = pieces.count(used);
    return found;
}

}  // namespace tedavis::test_support
