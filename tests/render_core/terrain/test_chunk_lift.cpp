#include "render_core/terrain/chunk_lift.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "render_core/terrain/drawn_surface.hpp"

namespace tedavis::terrain::test_chunk_lift {
namespace {

/// Random covers with random lifts; levels one apart across edges.
struct Cover {
    Cover(const FileHeader& header, unsigned seed) : lattice(header), memory(LodTree::bytes_needed(4000)), entries(4000) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(tree.start(arena, 4000));
        tree.clear(lattice);
        std::mt19937 random(seed);
        const std::uint32_t top = lattice.levels() - 1;
        for (std::uint32_t j = 0; j < lattice.grid_rows(top); ++j)
            for (std::uint32_t i = 0; i < lattice.grid_columns(top); ++i) add({top, i, j}, kNoNode, random);
        for (int n = 0; n < 12; ++n) {
            const std::int64_t i = random() % (lattice.columns() - 1), j = random() % (lattice.rows() - 1);
            split(tree.leaf_over_cell(i, j), random);
        }
    }
    void add(const ChunkKey& key, NodeIndex parent, std::mt19937& random) {
        ChunkEntry& entry = entries[tree.size()];
        entry.below_m = static_cast<float>(random() % 1000);
        entry.strip_below_m = static_cast<float>(random() % 1000);
        tree.add(key, &entry, parent);
    }
    void split(NodeIndex n, std::mt19937& random) {
        const ChunkKey key = tree.node(n).key;
        if (key.level == 0) return;
        for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
            const ChunkKey beside = lattice.neighbour(key, side);
            if (beside != kNoChunk && tree.find(beside) == kNoNode) split(tree.coarser_beyond(key, side), random);
        }
        tree.node(n).is_leaf = false;
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
            if (lattice.contains(key.child(quadrant))) add(key.child(quadrant), n, random);
    }
    Lattice lattice;
    std::vector<std::uint8_t> memory;
    std::vector<ChunkEntry> entries;
    LodTree tree;
};

FileHeader square() {
    FileHeader h{};
    h.columns = h.rows = 513;
    h.levels = 5;
    return h;
}

FileHeader ragged() {
    FileHeader h{};
    h.columns = 300;
    h.rows = 200;
    h.levels = 4;
    return h;
}

FileHeader world() {
    FileHeader h{};
    h.columns = 321;
    h.rows = 161;
    h.levels = 4;
    h.lattice_flags = kLatticeClosed | kLatticeNorthPole | kLatticeSouthPole;
    return h;
}

/// A post is the same place in all chunks that hold it; a whole pole row is one place.
std::pair<std::uint32_t, std::uint32_t> place_of(const Lattice& lattice, std::uint32_t i, std::uint32_t j) {
    if (lattice.is_closed()) i %= lattice.columns() - 1;
    const bool pole = ((lattice.flags() & kLatticeNorthPole) != 0 && j == 0) ||
                      ((lattice.flags() & kLatticeSouthPole) != 0 && j + 1 == lattice.rows());
    return {pole ? 0 : i, j};
}

TEST(ChunkLift, ChunksThatShareAVertexRaiseItAlikeAndNoneLessThanItsOwnLift) {
    for (const FileHeader& header : {square(), ragged(), world()})
        for (unsigned seed = 1; seed < 12; ++seed) {
            Cover cover(header, seed);
            const PoleLifts poles = lift_leaves(cover.tree);
            std::map<std::pair<std::uint32_t, std::uint32_t>, float> lifts;
            std::uint32_t shared = 0;
            for (NodeIndex n = 0; n < cover.tree.size(); ++n) {
                const LodNode& node = cover.tree.node(n);
                if (!node.is_leaf) continue;
                const PostRange posts = cover.lattice.posts_of(node.key);
                const ChunkLift lift = lift_of_leaf(cover.tree, n, poles).lift;
                const float own_m = own_lift_m(*node.entry, cover.tree.coarser_edges(node.key));
                EXPECT_EQ(lift.own_m, own_m);
                // Every post of the border, though drawn ones are fewer.
                for (std::uint32_t j = posts.j0; j <= posts.j1; ++j)
                    for (std::uint32_t i = posts.i0; i <= posts.i1; ++i) {
                        if (i != posts.i0 && i != posts.i1 && j != posts.j0 && j != posts.j1) continue;
                        ChunkVertex v{};
                        v.i = static_cast<std::uint16_t>(i - posts.i0);
                        v.j = static_cast<std::uint16_t>(j - posts.j0);
                        const float lift_m = vertex_lift_m(lift, posts, v);
                        ASSERT_GE(lift_m, own_m);
                        const auto [known, is_new] = lifts.insert({place_of(cover.lattice, i, j), lift_m});
                        ASSERT_EQ(known->second, lift_m) << "post " << i << ", " << j << ", seed " << seed;
                        shared += is_new ? 0 : 1;
                    }
            }
            EXPECT_GT(shared, 100u);
        }
}

TEST(ChunkLift, TheLargestNamesTheLeafItComesFrom) {
    Cover cover(square(), 5);
    const PoleLifts poles = lift_leaves(cover.tree);
    for (NodeIndex n = 0; n < cover.tree.size(); ++n) {
        if (!cover.tree.node(n).is_leaf) continue;
        const LiftedLeaf lifted = lift_of_leaf(cover.tree, n, poles);
        float largest_m = lifted.lift.own_m;
        for (int k = 0; k < 4; ++k) largest_m = std::max({largest_m, lifted.lift.edge_m[k], lifted.lift.corner_m[k]});
        EXPECT_EQ(lifted.largest.lift_m, largest_m);
        EXPECT_EQ(cover.tree.node(lifted.largest.leaf).lift_m, largest_m);
        EXPECT_TRUE(cover.tree.node(lifted.largest.leaf).is_leaf);
    }
}

TEST(ChunkLift, StripsCountWhereANeighbourIsCoarser) {
    ChunkEntry entry{};
    entry.below_m = 3;
    entry.strip_below_m = 2;
    entry.above_m = 9;
    EXPECT_EQ(own_lift_m(entry, kEdgeWest), 3);
    entry.strip_below_m = 5;
    EXPECT_EQ(own_lift_m(entry, kEdgeWest), 5);
    EXPECT_EQ(own_lift_m(entry, 0), 3);
}

TEST(ChunkLift, TheGreatestIsOfAnyPart) {
    ChunkLift lift{1, {10, 11, 12, 13}, {20, 21, 22, 23}};
    EXPECT_EQ(greatest_lift_m(lift), 23);
    lift.edge_m[2] = 24;
    EXPECT_EQ(greatest_lift_m(lift), 24);
    lift.own_m = 30;
    EXPECT_EQ(greatest_lift_m(lift), 30);
}

}  // namespace
}  // namespace tedavis::terrain::test_chunk_lift
