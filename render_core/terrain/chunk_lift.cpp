#include "render_core/terrain/chunk_lift.hpp"

#include <initializer_list>

namespace tedavis::terrain {
namespace {

enum Edge : std::uint32_t { kNorth, kEast, kSouth, kWest };

Edge opposite(Edge edge) { return static_cast<Edge>((edge + 2u) % 4u); }

LiftSource own_source(const LodTree& tree, NodeIndex leaf) { return {tree.node(leaf).lift_m, leaf}; }

/// The leaves beyond an edge: over the cells at its two ends. With levels one apart at most these are all.
struct Beyond {
    NodeIndex leaf[2];
};

Beyond beyond(const LodTree& tree, NodeIndex leaf, Edge edge) {
    const ChunkKey& key = tree.node(leaf).key;
    const PostRange posts = tree.lattice().posts_of(key);
    const std::int64_t west = posts.i0, north = posts.j0, east = std::int64_t{posts.i1} - 1, south = std::int64_t{posts.j1} - 1;
    const auto over = [&](std::int64_t i, std::int64_t j) { return tree.leaf_over_cell(i, j, key.level); };
    switch (edge) {
        case kNorth: return {{over(west, north - 1), over(east, north - 1)}};
        case kEast: return {{over(east + 1, north), over(east + 1, south)}};
        case kSouth: return {{over(west, south + 1), over(east, south + 1)}};
        case kWest: return {{over(west - 1, north), over(west - 1, south)}};
    }
    return {{kNoNode, kNoNode}};
}

LiftSource edge_lift(const LodTree& tree, NodeIndex leaf, Edge edge) {
    LiftSource lift = own_source(tree, leaf);
    for (const NodeIndex other : beyond(tree, leaf, edge).leaf) {
        if (other == kNoNode) continue;
        lift.include(own_source(tree, other));
        if (tree.node(other).key.level <= tree.node(leaf).key.level) continue;
        // The edge is part of the coarser one's, which has the other leaves along it too.
        for (const NodeIndex beside : beyond(tree, other, opposite(edge)).leaf)
            if (beside != kNoNode) lift.include(own_source(tree, beside));
    }
    return lift;
}

LiftSource corner_lift(const LodTree& tree, NodeIndex leaf, std::uint32_t quadrant) {
    const ChunkKey& key = tree.node(leaf).key;
    const PostRange posts = tree.lattice().posts_of(key);
    const std::int64_t i = (quadrant & 1u) != 0 ? posts.i1 : posts.i0, j = (quadrant & 2u) != 0 ? posts.j1 : posts.j0;
    LiftSource lift = own_source(tree, leaf);
    for (const std::int64_t north : {j - 1, j})
        for (const std::int64_t west : {i - 1, i})
            if (const NodeIndex other = tree.leaf_over_cell(west, north, key.level); other != kNoNode)
                lift.include(own_source(tree, other));
    return lift;
}

bool touches_north_pole(const LodTree& tree, const ChunkKey& key) {
    return (tree.lattice().flags() & kLatticeNorthPole) != 0 && key.j == 0;
}

bool touches_south_pole(const LodTree& tree, const ChunkKey& key) {
    return (tree.lattice().flags() & kLatticeSouthPole) != 0 && key.j + 1 == tree.lattice().grid_rows(key.level);
}

}  // namespace

float own_lift_m(const ChunkEntry& entry, std::uint8_t coarser_edges) {
    return coarser_edges == 0 || entry.below_m > entry.strip_below_m ? entry.below_m : entry.strip_below_m;
}

PoleLifts lift_leaves(LodTree& tree) {
    PoleLifts poles;
    for (NodeIndex n = 0; n < tree.size(); ++n) {
        LodNode& node = tree.node(n);
        if (!node.is_leaf) continue;
        node.lift_m = own_lift_m(*node.entry, tree.coarser_edges(node.key));
        if (touches_north_pole(tree, node.key)) poles.north.include(own_source(tree, n));
        if (touches_south_pole(tree, node.key)) poles.south.include(own_source(tree, n));
    }
    return poles;
}

LiftedLeaf lift_of_leaf(const LodTree& tree, NodeIndex leaf, const PoleLifts& poles) {
    LiftSource edges[4], corners[4];
    for (const Edge edge : {kNorth, kEast, kSouth, kWest}) edges[edge] = edge_lift(tree, leaf, edge);
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) corners[quadrant] = corner_lift(tree, leaf, quadrant);
    const ChunkKey& key = tree.node(leaf).key;
    if (touches_north_pole(tree, key)) edges[kNorth] = corners[0] = corners[1] = poles.north;
    if (touches_south_pole(tree, key)) edges[kSouth] = corners[2] = corners[3] = poles.south;

    LiftedLeaf lifted;
    lifted.largest = own_source(tree, leaf);
    lifted.lift.own_m = lifted.largest.lift_m;
    for (std::uint32_t n = 0; n < 4; ++n) {
        lifted.lift.edge_m[n] = edges[n].lift_m;
        lifted.lift.corner_m[n] = corners[n].lift_m;
        lifted.largest.include(edges[n]);
        lifted.largest.include(corners[n]);
    }
    return lifted;
}

}  // namespace tedavis::terrain
