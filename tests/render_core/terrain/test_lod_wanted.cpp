// What a selection asks for, and what is drawn while it has not arrived.
#include "render_core/terrain/lod_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "render_core/terrain/projected_error.hpp"
#include "tests/render_core/terrain/lod_grounds.hpp"
#include "tests/support/terrain/resident_tdb.hpp"

namespace tedavis::terrain::test_lod_wanted {
namespace {

using test_support::expect_balanced;
using test_support::expect_covered_once;
using test_support::ResidentTdb;
using test_support::rough_region;
using test_support::Selection;
using test_support::view_from;
using test_support::views_of;

TEST(LodSelection, WhatHasNotArrivedIsDrawnCoarserWithoutAHole) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    for (const View& view : views_of(rough_region(), 6)) {
        LodSettings settings;
        settings.tau_px = 0.5;
        (void)selection.select(catalogue, view, settings);
        const std::vector<WantedChunk> wanted = selection.wanted();
        const std::vector<ChunkKey> ideal = selection.keys();
        std::set<std::uint64_t> here;
        catalogue.is_available = [&](const ChunkKey& key) { return here.count(key.packed()) != 0; };
        double last_px = 1e300;
        // In the order of the list: roots first, and the picture only ever gets better.
        for (std::size_t count = 1; count <= wanted.size(); ++count) {
            here.insert(wanted[count - 1].key.packed());
            if (count % 5 != 1 && count != wanted.size()) continue;
            (void)selection.select(catalogue, view, settings, SelectionKind::drawn);
            for (const SelectedChunk& chunk : selection.chunks) ASSERT_NE(chunk.slot, kNoSlot);
            expect_covered_once(rough_region(), view, selection, 11);
            expect_balanced(rough_region(), selection);
            EXPECT_LE(selection.result.worst_error_px, last_px * (1 + 1e-12));
            last_px = selection.result.worst_error_px;
            EXPECT_EQ(selection.result.reason, last_px <= 0.5 ? LodStop::met : LodStop::not_arrived);
        }
        EXPECT_EQ(selection.keys(), ideal) << "with all that was wanted the ideal is drawn";
        catalogue.is_available = nullptr;
    }
}

TEST(LodSelection, WantedAreTheDrawnAndTheirAncestorsAncestorsFirst) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    for (const View& view : views_of(rough_region(), 6)) {
        (void)selection.select(catalogue, view, {});
        const std::vector<WantedChunk> wanted = selection.wanted();
        std::set<std::uint64_t> listed, expected;
        for (const WantedChunk& chunk : wanted) {
            EXPECT_TRUE(chunk.key.level + 1 == rough_region().lattice().levels() ||
                        listed.count(chunk.key.parent().packed()) != 0)
                << "an ancestor comes before its descendants";
            EXPECT_EQ(key_of(*chunk.entry), chunk.key);
            EXPECT_TRUE(listed.insert(chunk.key.packed()).second) << "once";
        }
        for (ChunkKey key : selection.keys())
            for (; key.level < rough_region().lattice().levels(); key = key.parent()) expected.insert(key.packed());
        EXPECT_TRUE(std::includes(listed.begin(), listed.end(), expected.begin(), expected.end()));
        bool beside_the_view = false;
        for (const WantedChunk& chunk : wanted) {
            const bool in_view = expected.count(chunk.key.packed()) != 0 || !is_outside_view(*chunk.entry, view);
            EXPECT_FALSE(in_view && beside_the_view) << "what is out of view comes after all";
            beside_the_view = !in_view;
        }
        const std::vector<WantedChunk> few = selection.wanted(5);
        ASSERT_EQ(few.size(), std::min<std::size_t>(5, wanted.size()));
        for (std::size_t n = 0; n < few.size(); ++n) EXPECT_EQ(few[n].key, wanted[n].key);
    }
}

/// The worst error of a view of which `resident` has arrived.
double drawn_with(const std::vector<WantedChunk>& resident, const View& view) {
    ResidentTdb catalogue(rough_region());
    std::set<std::uint64_t> here;
    for (const WantedChunk& chunk : resident) here.insert(chunk.key.packed());
    catalogue.is_available = [&](const ChunkKey& key) { return here.count(key.packed()) != 0; };
    Selection selection;
    return selection.select(catalogue, view, {}, SelectionKind::drawn).worst_error_px;
}

TEST(LodSelection, AViewThatTurnsFindsCoarserChunksBesideTheOld) {
    const View view = view_from(rough_region(), 200, 180, 400, 0, -20);
    ResidentTdb catalogue(rough_region());
    Selection selection;
    (void)selection.select(catalogue, view, {});
    const std::vector<WantedChunk> wanted = selection.wanted();
    std::vector<WantedChunk> seen;
    for (const WantedChunk& chunk : wanted)
        if (!is_outside_view(*chunk.entry, view)) seen.push_back(chunk);
    ASSERT_LT(seen.size(), wanted.size());
    int rescued = 0;
    for (double heading_deg = 20; heading_deg < 350; heading_deg += 30) {
        const View turned = view_from(rough_region(), 200, 180, 400, heading_deg, -20);
        const double with_px = drawn_with(wanted, turned), without_px = drawn_with(seen, turned);
        EXPECT_LE(with_px, without_px);
        rescued += with_px < 0.25 * without_px ? 1 : 0;
    }
    EXPECT_GT(rescued, 3);
}

TEST(LodSelection, WhatWaitsIsToldFromWhatBudgetsForbid) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    LodSettings settings;
    const View view = view_from(rough_region(), 200, 340, 3000, 0, -10);
    settings.max_triangles = 1500;
    const LodResult poor = selection.select(catalogue, view, settings);
    ASSERT_GT(poor.worst_coarse_px, settings.tau_px);
    EXPECT_EQ(poor.worst_waiting_px, 0);
    settings.max_triangles = 250000;
    catalogue.is_available = [](const ChunkKey& key) { return key.level + 1 >= rough_region().lattice().levels(); };
    const LodResult early = selection.select(catalogue, view, settings, SelectionKind::drawn);
    ASSERT_GT(early.worst_waiting_px, settings.tau_px);
    EXPECT_EQ(early.worst_waiting_px, early.worst_coarse_px);
    settings.haze_per_m = 1e-3;
    const LodResult hazy = selection.select(catalogue, view, settings, SelectionKind::drawn);
    EXPECT_LT(hazy.worst_waiting_px, hazy.worst_coarse_px) << "as far as it is seen";
    EXPECT_GE(hazy.worst_waiting_px, 0.05 * hazy.worst_coarse_px);
}

TEST(LodSelection, MissingDirectoryPagesHoldTheRefinementUp) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    catalogue.is_missing = [](const ChunkKey& key) { return key.level == 0 && key.i >= 4; };
    const View view = view_from(rough_region(), 200, 310, 300, 0, -3);
    LodSettings settings;
    settings.tau_px = 0.2;
    (void)selection.select(catalogue, view, settings);
    EXPECT_EQ(selection.result.reason, LodStop::not_arrived);
    EXPECT_GT(selection.result.tau_reached_px, 0.2);
    expect_covered_once(rough_region(), view, selection, 7);
    for (const ChunkKey& key : selection.keys()) EXPECT_FALSE(catalogue.is_missing(key));
}

}  // namespace
}  // namespace tedavis::terrain::test_lod_wanted
