#include "render_core/terrain/lod_refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/terrain/resident_tdb.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::terrain::test_lod_refinement {
namespace {

using test_support::ResidentTdb;
using test_support::TdbSpec;
using test_support::view_from;
using test_support::WrittenTdb;

/// Flat, with errors written by hand: which chunk is worst is then up to the test.
struct FlatTdb : ResidentTdb {
    explicit FlatTdb(const WrittenTdb& written) : ResidentTdb(written) {
        for (const ChunkKey& key : written.keys()) entries[key.packed()] = written.entry(key);
    }
    FoundEntry find(const ChunkKey& key) override {
        const FoundEntry found = ResidentTdb::find(key);
        return found.state == EntryState::present ? FoundEntry{&entries.at(key.packed()), found.state} : found;
    }
    void set_error(const ChunkKey& key, float error_m) {
        ChunkEntry& entry = entries.at(key.packed());
        entry.above_m = entry.below_m = entry.strip_above_m = entry.strip_below_m = entry.bound_m = error_m;
    }
    std::map<std::uint64_t, ChunkEntry> entries;
};

const WrittenTdb& plain(std::uint32_t columns, std::uint32_t rows, std::uint32_t flags) {
    static std::map<std::uint32_t, std::unique_ptr<WrittenTdb>> made;
    auto& tdb = made[flags];
    if (tdb == nullptr) {
        TdbSpec spec;
        if (flags != 0) {
            spec.west_deg = -180;
            spec.step_lon_deg = 360.0 / (columns - 1);
            spec.step_lat_deg = 0.1;
            spec.north_deg = 12;
        }
        spec.columns = columns;
        spec.rows = rows;
        spec.lattice_flags = flags;
        spec.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
        spec.measured = false;
        tdb = std::make_unique<WrittenTdb>(spec);
    }
    return *tdb;
}

struct Refining {
    explicit Refining(ResidentTdb& catalogue, const View& over, LodSettings with = {}, SelectionKind kind = SelectionKind::ideal)
        : memory(LodTree::bytes_needed(2000)), heap(2000), view(over), settings(with) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(tree.start(arena, 2000));
        refinement = std::make_unique<LodRefinement>(catalogue, view, settings, kind, tree,
                                                     base::Span<NodeIndex>(heap.data(), heap.size()));
    }
    std::set<std::uint64_t> leaves() const {
        std::set<std::uint64_t> keys;
        for (NodeIndex n = 0; n < tree.size(); ++n)
            if (tree.node(n).is_leaf) keys.insert(tree.node(n).key.packed());
        return keys;
    }
    bool is_leaf(const ChunkKey& key) const { return leaves().count(key.packed()) != 0; }
    std::vector<std::uint8_t> memory;
    std::vector<NodeIndex> heap;
    LodTree tree;
    View view;
    LodSettings settings;
    std::unique_ptr<LodRefinement> refinement;
};

View from_above(const WrittenTdb& tdb) {
    return view_from(tdb, (tdb.lattice().columns() - 1) / 2.0, (tdb.lattice().rows() - 1) / 2.0, 60000, 0, -90);
}

TEST(LodRefinement, WithoutErrorTheRootsDo) {
    FlatTdb tdb(plain(513, 513, 0));
    Refining run(tdb, from_above(plain(513, 513, 0)));
    ASSERT_TRUE(run.refinement->run(Priority::error, 0));
    EXPECT_EQ(run.tree.size(), 1u);
    EXPECT_EQ(run.refinement->stop(), LodStop::met);
}

TEST(LodRefinement, ASplitBringsItsNeighboursWithinOneLevel) {
    FlatTdb tdb(plain(513, 513, 0));
    // A path down to a level-1 chunk in the middle, whose neighbours across the centre lines are of another root quarter.
    for (const ChunkKey& key : {ChunkKey{4, 0, 0}, {3, 0, 0}, {2, 1, 1}, {1, 3, 3}}) tdb.set_error(key, 1000);
    Refining run(tdb, from_above(plain(513, 513, 0)));
    ASSERT_TRUE(run.refinement->run(Priority::error, 0));
    EXPECT_TRUE(run.is_leaf({0, 7, 7}));
    EXPECT_TRUE(run.is_leaf({1, 4, 3})) << "beside level 0 is level 1";
    EXPECT_TRUE(run.is_leaf({1, 3, 4}));
    EXPECT_TRUE(run.is_leaf({2, 3, 0})) << "and beside that level 2";
    EXPECT_TRUE(run.is_leaf({2, 2, 2})) << "only edges count, corners do not";
    EXPECT_FALSE(run.is_leaf({3, 1, 1}));
    const auto owed_px = [&](const ChunkKey& key) { return run.tree.node(run.tree.find(key)).error_px; };
    EXPECT_GE(owed_px({2, 2, 1}), owed_px({1, 3, 3})) << "without its split the worst could not be split either";
    EXPECT_GE(owed_px({3, 1, 0}), owed_px({1, 3, 3}));
    EXPECT_EQ(owed_px({1, 4, 3}), 0) << "control: nothing depends on this one";
}

/// Flat, under an image as fine as a quarter of its posts.
const WrittenTdb& draped() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = spec.rows = 513;
        spec.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
        spec.measured = false;
        spec.drape_level = 1;
        return spec;
    }());
    return tdb;
}

LodSettings with_image() {
    LodSettings settings;
    settings.drape = {92.7 / 4, 1};
    return settings;
}

double texel_px(const Refining& run, const LodNode& node) {
    const double texel_m = run.settings.drape.texel_m * std::pow(2.0, node.key.level - 1.0);
    return texel_m * run.view.focal_px / std::max(box_distance_m(*node.entry, run.view), run.view.near_m);
}

TEST(LodRefinement, AnImageSplitsLevelGroundUntilItsTexelsAreSmallOrAtTheirFinest) {
    FlatTdb tdb(draped());
    const View view = view_from(draped(), 200, 300, 9000, 30, -35);
    Refining plain_run(tdb, view), run(tdb, view, with_image());
    ASSERT_TRUE(plain_run.refinement->run(Priority::error, 0));
    EXPECT_EQ(plain_run.tree.size(), 1u) << "control: tau asks for nothing";
    ASSERT_TRUE(run.refinement->run(Priority::error, 0));
    EXPECT_TRUE(run.refinement->refined_image());
    std::set<std::uint32_t> levels;
    for (NodeIndex n = 0; n < run.tree.size(); ++n) {
        const LodNode& node = run.tree.node(n);
        if (!node.is_leaf || !node.is_visible) continue;
        levels.insert(node.key.level);
        EXPECT_GE(node.key.level, 1u) << "below, there is nothing finer";
        EXPECT_TRUE(node.key.level == 1 || texel_px(run, node) <= kLargestTexel_px) << texel_px(run, node);
    }
    EXPECT_GE(levels.size(), 2u);
    ASSERT_TRUE(run.refinement->run(Priority::error, 0, false));
    EXPECT_EQ(run.tree.size(), 1u);
}

TEST(LodRefinement, GroundThatTheImageDoesNotCoverIsNotSplitForIt) {
    FlatTdb tdb(draped());
    for (auto& [key, entry] : tdb.entries) entry.drape = {};
    Refining run(tdb, view_from(draped(), 200, 300, 9000, 30, -35), with_image());
    ASSERT_TRUE(run.refinement->run(Priority::error, 0));
    EXPECT_EQ(run.tree.size(), 1u);
}

TEST(LodRefinement, TheImageGetsWhatErrorsLeaveTheLargestTexelsFirst) {
    FlatTdb tdb(draped());
    tdb.set_error({4, 0, 0}, 1000);
    tdb.set_error({3, 1, 1}, 1000);
    const View view = view_from(draped(), 200, 200, 9000, 0, -60);
    Refining errors(tdb, view);
    ASSERT_TRUE(errors.refinement->run(Priority::error, 0));
    LodSettings settings = with_image();
    settings.max_triangles = errors.refinement->triangles();
    Refining nothing_left(tdb, view, settings);
    ASSERT_TRUE(nothing_left.refinement->run(Priority::error, 0));
    EXPECT_EQ(nothing_left.leaves(), errors.leaves());
    EXPECT_EQ(nothing_left.refinement->stop(), LodStop::met) << "tau is met: that the image could be finer is no fault";
    settings.max_triangles *= 2;
    Refining some_left(tdb, view, settings), all(tdb, view, with_image());
    ASSERT_TRUE(some_left.refinement->run(Priority::error, 0));
    ASSERT_TRUE(all.refinement->run(Priority::error, 0));
    EXPECT_LE(some_left.refinement->triangles(), settings.max_triangles);
    EXPECT_GT(some_left.tree.size(), errors.tree.size());
    EXPECT_LT(some_left.tree.size(), all.tree.size());
    EXPECT_EQ(some_left.refinement->stop(), LodStop::met);
}

TEST(LodRefinement, RoundTheEarthAsWell) {
    const WrittenTdb& ring = plain(513, 129, kLatticeClosed);
    FlatTdb tdb(ring);
    for (const ChunkKey& key : {ChunkKey{4, 0, 0}, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}}) tdb.set_error(key, 1e6f);
    View view = view_from(ring, 0, 40, 4e6, 0, -90);
    Refining run(tdb, view);
    ASSERT_TRUE(run.refinement->run(Priority::error, 0));
    ASSERT_TRUE(run.is_leaf({0, 0, 0}));
    EXPECT_TRUE(run.is_leaf({1, 7, 0})) << "the western neighbour is at the other end";
    EXPECT_TRUE(run.is_leaf({2, 2, 0}));
}

TEST(LodRefinement, AGroupIsSplitWhollyOrNotAtAll) {
    FlatTdb tdb(plain(513, 513, 0));
    for (const ChunkKey& key : {ChunkKey{4, 0, 0}, {3, 0, 0}, {2, 1, 1}, {1, 3, 3}}) tdb.set_error(key, 1000);
    const View view = from_above(plain(513, 513, 0));
    Refining whole(tdb, view);
    ASSERT_TRUE(whole.refinement->run(Priority::error, 0));
    std::set<std::size_t> sizes;
    for (std::uint32_t triangles = 2048; triangles <= whole.refinement->triangles(); triangles += 512) {
        LodSettings settings;
        settings.max_triangles = triangles;
        Refining run(tdb, view, settings);
        ASSERT_TRUE(run.refinement->run(Priority::error, 0));
        EXPECT_LE(run.refinement->triangles(), triangles);
        for (NodeIndex n = 0; n < run.tree.size(); ++n) {
            if (!run.tree.node(n).is_leaf) continue;
            for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
                const ChunkKey beside = tdb.lattice().neighbour(run.tree.node(n).key, side);
                EXPECT_TRUE(beside == kNoChunk || run.tree.find(beside) != kNoNode || run.tree.find(beside.parent()) != kNoNode);
            }
        }
        EXPECT_EQ(run.refinement->stop() == LodStop::met, run.leaves() == whole.leaves());
        sizes.insert(run.tree.size());
    }
    EXPECT_GE(sizes.size(), 3u) << "steps in between";
}

TEST(LodRefinement, TheWorstGoesFirstAndVisibilityMayChangeWhichThatIs) {
    const WrittenTdb& written = plain(513, 513, 0);
    FlatTdb tdb(written);
    tdb.set_error({4, 0, 0}, 5000);
    // Looking north from the southern end: quarters 0 and 1 are far, 2 and 3 near.
    const View view = view_from(written, 250, 500, 3000, 0, -5);
    tdb.set_error({3, 0, 0}, 4000);
    tdb.set_error({3, 0, 1}, 300);
    LodSettings settings;
    settings.max_chunks = 7;
    settings.haze_per_m = 1 / 2000.0;
    Refining clear(tdb, view, settings), hazy(tdb, view, settings);
    ASSERT_TRUE(clear.refinement->run(Priority::error, 0));
    EXPECT_EQ(clear.refinement->stop(), LodStop::chunks);
    EXPECT_FALSE(clear.is_leaf({3, 0, 0}));
    EXPECT_TRUE(clear.is_leaf({3, 0, 1}));
    ASSERT_TRUE(hazy.refinement->run(Priority::seen_error, 0));
    EXPECT_TRUE(hazy.is_leaf({3, 0, 0}));
    EXPECT_FALSE(hazy.is_leaf({3, 0, 1}));
}

TEST(LodRefinement, WhatIsNotHereHoldsUpOnlyWhatNeedsIt) {
    FlatTdb tdb(plain(513, 513, 0));
    for (const ChunkKey& key : {ChunkKey{4, 0, 0}, {3, 0, 0}, {3, 1, 1}}) tdb.set_error(key, 1000);
    tdb.is_available = [](const ChunkKey& key) { return key != ChunkKey{2, 1, 0}; };
    Refining run(tdb, from_above(plain(513, 513, 0)), {}, SelectionKind::drawn);
    ASSERT_TRUE(run.refinement->run(Priority::error, 0));
    EXPECT_TRUE(run.is_leaf({3, 0, 0}));
    EXPECT_EQ(run.tree.node(run.tree.find({3, 0, 0})).blocked, static_cast<std::uint8_t>(LodStop::not_arrived));
    EXPECT_FALSE(run.is_leaf({3, 1, 1}));
    EXPECT_EQ(run.refinement->stop(), LodStop::met) << "no budget was in the way";
    Refining ideal(tdb, from_above(plain(513, 513, 0)));
    ASSERT_TRUE(ideal.refinement->run(Priority::error, 0));
    EXPECT_FALSE(ideal.is_leaf({3, 0, 0}));
}

TEST(LodRefinement, ARaisedNeighbourIsSplitForWhatItDoesToOthers) {
    const WrittenTdb& written = plain(513, 513, 0);
    FlatTdb tdb(written);
    tdb.set_error({4, 0, 0}, 5000);
    // Harmless where it is, far from the eye; but its lift raises the border of the chunk under the eye.
    tdb.set_error({3, 0, 0}, 40);
    View view = view_from(written, 270, 270, 2000, 315, -60);
    LodSettings settings;
    settings.conservative_up = true;
    settings.tau_px = 40;
    Refining run(tdb, view, settings);
    ASSERT_TRUE(run.refinement->run(Priority::error, 5000));
    EXPECT_EQ(run.refinement->largest_lift_m(), 5000);
    settings.tau_px = 1;
    Refining strict(tdb, view, settings);
    ASSERT_TRUE(strict.refinement->run(Priority::error, 5000));
    EXPECT_FALSE(strict.is_leaf({3, 0, 0}));
    for (NodeIndex n = 0; n < strict.tree.size(); ++n) EXPECT_EQ(strict.tree.node(n).is_leaf ? strict.tree.node(n).lift_m : 0, 0);
}

TEST(LodRefinement, DrawnErrorCountsStripsWhereANeighbourIsCoarser) {
    const WrittenTdb& written = plain(513, 513, 0);
    ChunkEntry entry = written.entry({0, 3, 3});
    const View view = from_above(written);
    entry.above_m = 1;
    entry.strip_above_m = 4;
    const double mesh_px = drawn_error_px(entry, view, 0);
    EXPECT_GT(mesh_px, 0);
    EXPECT_NEAR(drawn_error_px(entry, view, kEdgeEast), 4 * mesh_px, 0.01 * mesh_px);
    EXPECT_NEAR(lifted_error_px(entry, view, 0, 2), 3 * mesh_px, 0.01 * mesh_px) << "raised by 2 on top of 1";
    EXPECT_NEAR(lifted_error_px(entry, view, kEdgeEast, 2), 6 * mesh_px, 0.01 * mesh_px);
    entry.below_m = 50;
    EXPECT_NEAR(drawn_error_px(entry, view, 0), 50 * mesh_px, 0.1 * mesh_px);
    EXPECT_NEAR(lifted_error_px(entry, view, 0, 2), 3 * mesh_px, 0.01 * mesh_px) << "nothing is below what is raised";
}

}  // namespace
}  // namespace tedavis::terrain::test_lod_refinement
