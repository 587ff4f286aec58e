#include "render_core/terrain/lod_tree.hpp"

#include <gtest/gtest.h>

#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_lod_tree {
namespace {

using test_support::TdbSpec;
using test_support::WrittenTdb;

/// A hand-made cover: the root split, its north-west child split, and of that the south-east one.
struct Cover {
    explicit Cover(const Lattice& over) : memory(LodTree::bytes_needed(64)) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(tree.start(arena, 64));
        tree.clear(over);
    }
    void split(const ChunkKey& key) {
        const NodeIndex parent = tree.find(key);
        tree.node(parent).is_leaf = false;
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
            if (tree.lattice().contains(key.child(quadrant))) tree.add(key.child(quadrant), &entry, parent);
    }
    ChunkEntry entry{};
    std::vector<std::uint8_t> memory;
    LodTree tree;
};

Lattice square() {
    FileHeader h{};
    h.columns = h.rows = 257;
    h.levels = 4;
    return Lattice(h);
}

Lattice ring() {
    FileHeader h{};
    h.columns = 161;  // five chunks round
    h.rows = 65;
    h.levels = 2;
    h.lattice_flags = kLatticeClosed;
    return Lattice(h);
}

TEST(LodTree, LeavesCoverEveryCellOnce) {
    const Lattice lattice = square();
    Cover cover(lattice);
    cover.tree.add({3, 0, 0}, &cover.entry, kNoNode);
    cover.split({3, 0, 0});
    cover.split({2, 0, 0});
    cover.split({1, 1, 1});
    EXPECT_EQ(cover.tree.size(), 13u);
    EXPECT_EQ(cover.tree.room(), 51u);
    for (std::int64_t j = 0; j < 256; ++j)
        for (std::int64_t i = 0; i < 256; ++i) {
            const NodeIndex leaf = cover.tree.leaf_over_cell(i, j);
            ASSERT_NE(leaf, kNoNode);
            const std::uint32_t expected = i >= 128 || j >= 128 ? 2 : (i >= 64 && j >= 64 ? 0 : 1);
            ASSERT_EQ(cover.tree.node(leaf).key.level, expected) << i << ", " << j;
            const PostRange posts = lattice.posts_of(cover.tree.node(leaf).key);
            ASSERT_TRUE(posts.i0 <= i && i < posts.i1 && posts.j0 <= j && j < posts.j1);
        }
    EXPECT_EQ(cover.tree.leaf_over_cell(-1, 0), kNoNode);
    EXPECT_EQ(cover.tree.leaf_over_cell(256, 0), kNoNode);
    EXPECT_EQ(cover.tree.leaf_over_cell(0, 256), kNoNode);
}

TEST(LodTree, TellsTheCoarserSides) {
    const Lattice lattice = square();
    Cover cover(lattice);
    cover.tree.add({3, 0, 0}, &cover.entry, kNoNode);
    cover.split({3, 0, 0});
    cover.split({2, 0, 0});
    EXPECT_EQ(cover.tree.coarser_edges({1, 1, 1}), kEdgeEast | kEdgeSouth);
    EXPECT_EQ(cover.tree.node(cover.tree.coarser_beyond({1, 1, 1}, kEdgeSouth)).key, (ChunkKey{2, 0, 1}));
    EXPECT_EQ(cover.tree.coarser_edges({1, 0, 0}), 0);
    EXPECT_EQ(cover.tree.coarser_edges({2, 1, 0}), 0) << "its western neighbours are finer";
    cover.tree.clear(lattice);
    EXPECT_EQ(cover.tree.size(), 0u);
    EXPECT_EQ(cover.tree.find({3, 0, 0}), kNoNode);
    EXPECT_EQ(cover.tree.use().high_water, 9u);
}

TEST(LodTree, GoesOnRoundTheEarth) {
    const Lattice lattice = ring();
    Cover cover(lattice);
    for (std::uint32_t i = 0; i < 3; ++i) cover.tree.add({1, i, 0}, &cover.entry, kNoNode);
    cover.split({1, 0, 0});
    EXPECT_EQ(cover.tree.coarser_edges({0, 0, 0}), kEdgeWest);
    EXPECT_EQ(cover.tree.coarser_edges({0, 1, 0}), kEdgeEast);
    EXPECT_EQ(cover.tree.node(cover.tree.leaf_over_cell(-1, 3)).key, (ChunkKey{1, 2, 0}));
    EXPECT_EQ(cover.tree.node(cover.tree.leaf_over_cell(160, 3)).key, (ChunkKey{0, 0, 0}));
}

TEST(LodTree, RefusesASmallArena) {
    std::vector<std::uint8_t> memory(100);
    base::Arena arena(memory.data(), memory.size());
    LodTree tree;
    EXPECT_FALSE(tree.start(arena, 64));
}

}  // namespace
}  // namespace tedavis::terrain::test_lod_tree
