/// Lifts: how far the vertices of a chunk are raised so that the drawn surface is nowhere below the true one. Chunks that share
/// a vertex raise it equally.
///
/// A chunk's own lift is below_m, and strip_below_m where that is more and a neighbour is coarser. A border's lift is the
/// largest of all leaves along the longer of the edges that meet there, a corner's the largest of the leaves round it, a pole's
/// the largest of all leaves that touch it. Pure; any thread.
#pragma once

#include "render_core/terrain/lod_tree.hpp"

namespace tedavis::terrain {

/// Edges north, east, south, west; corners in the order of quadrants (bit 0 east, bit 1 south).
struct ChunkLift {
    float own_m = 0;
    float edge_m[4]{};
    float corner_m[4]{};
};

[[nodiscard]] constexpr float greatest_lift_m(const ChunkLift& lift) {
    float greatest = lift.own_m;
    for (int n = 0; n < 4; ++n) {
        if (lift.edge_m[n] > greatest) greatest = lift.edge_m[n];
        if (lift.corner_m[n] > greatest) greatest = lift.corner_m[n];
    }
    return greatest;
}

/// A lift and the leaf that requires it.
struct LiftSource {
    float lift_m = 0;
    NodeIndex leaf = kNoNode;

    void include(const LiftSource& other) {
        if (other.lift_m > lift_m || leaf == kNoNode) *this = other;
    }
};

struct PoleLifts {
    LiftSource north, south;
};

struct LiftedLeaf {
    ChunkLift lift;
    LiftSource largest;  ///< largest of own, edges and corners
};

[[nodiscard]] float own_lift_m(const ChunkEntry& entry, std::uint8_t coarser_edges);
/// Sets every leaf's own lift, which the functions below need. Returns the lifts of the poles.
[[nodiscard]] PoleLifts lift_leaves(LodTree& tree);
[[nodiscard]] LiftedLeaf lift_of_leaf(const LodTree& tree, NodeIndex leaf, const PoleLifts& poles);

}  // namespace tedavis::terrain
