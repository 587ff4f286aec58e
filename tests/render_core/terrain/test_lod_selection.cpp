#include "render_core/terrain/lod_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "render_core/terrain/projected_error.hpp"
#include "tests/support/drawn_mesh_check.hpp"
#include "tests/support/resident_tdb.hpp"
#include "tests/support/selection.hpp"
#include "tests/support/terrain_views.hpp"

namespace tedavis::terrain {
namespace {

using test_support::project;
using test_support::ResidentTdb;
using test_support::Selection;
using test_support::some_views;
using test_support::TdbSpec;
using test_support::view_from;
using test_support::WrittenTdb;

double rough_height(double i, double j) {
    return 1200 + 500 * std::sin(i * 0.021) * std::cos(j * 0.017) + 30 * std::sin(i * 0.13 + j * 0.11) +
           0.6 * std::sin(i * 1.9) * std::cos(j * 2.3);
}

const WrittenTdb& region() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = 417;
        spec.rows = 353;
        spec.step_lon_deg = spec.step_lat_deg = 1 / 3600.0;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return rough_height(i, j); };
        return spec;
    }());
    return tdb;
}

/// Coarse posts, so that high mountains: the error is in what lies between them.
const WrittenTdb& world() {
    static const WrittenTdb tdb([] {
        TdbSpec spec = test_support::whole_earth(321, 161);
        spec.levels = 3;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 3000 + 2500 * std::sin(i * 0.7) * std::cos(j * 0.9); };
        return spec;
    }());
    return tdb;
}

std::vector<View> views_of(const WrittenTdb& tdb, int count, unsigned seed = 7) {
    return some_views(tdb, count, seed, tdb.lattice().is_closed() ? 400 : 1);
}

void expect_covered_once(const WrittenTdb& tdb, const View& view, const Selection& selection, std::uint32_t stride) {
    for (std::uint32_t j = 1; j + 2 < tdb.lattice().rows(); j += stride)
        for (std::uint32_t i = 0; i + 1 < tdb.lattice().columns(); i += stride) {
            if (!project(view, tdb.position(i, j)).visible) continue;
            int covering = 0;
            for (const SelectedChunk& chunk : selection.chunks) {
                const PostRange posts = tdb.lattice().posts_of(chunk.key);
                covering += i >= posts.i0 && i < posts.i1 && j >= posts.j0 && j < posts.j1 ? 1 : 0;
            }
            ASSERT_EQ(covering, 1) << "post " << i << ", " << j;
        }
}

void expect_balanced(const WrittenTdb& tdb, const Selection& selection) {
    std::set<std::uint64_t> chosen;
    for (const SelectedChunk& chunk : selection.chunks) chosen.insert(chunk.key.packed());
    for (const SelectedChunk& chunk : selection.chunks)
        for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
            ChunkKey beside = tdb.lattice().neighbour(chunk.key, side);
            if (beside == kNoChunk) {
                EXPECT_EQ(chunk.coarser_edges & side, 0);
                continue;
            }
            EXPECT_EQ(chosen.count(beside.packed()) != 0 && (chunk.coarser_edges & side) != 0, false);
            for (std::uint32_t up = 1; beside.level + 1 < tdb.lattice().levels(); ++up) {
                beside = beside.parent();
                if (chosen.count(beside.packed()) == 0) continue;
                EXPECT_EQ(up, 1u) << "levels differ by more than one";
                EXPECT_NE(chunk.coarser_edges & side, 0);
            }
        }
}

TEST(LodSelection, EveryVisiblePlaceIsCoveredOnceByChunksOneLevelApart) {
    for (const WrittenTdb* tdb : {&region(), &world()}) {
        ResidentTdb catalogue(*tdb);
        Selection selection;
        for (const View& view : views_of(*tdb, 10)) {
            ASSERT_TRUE(selection.select(catalogue, view, {}).within_budget);
            expect_covered_once(*tdb, view, selection, 3);
            expect_balanced(*tdb, selection);
        }
    }
}

// Whatever is left of the budgets: what errors need comes first, and what a finer image would spoil is undone.
TEST(LodSelection, AFinerImageNeverCostsAccuracy) {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = spec.rows = 225;
        spec.step_lon_deg = spec.step_lat_deg = 1 / 3600.0;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return i < 120 ? rough_height(i, j) : 1200.0; };
        spec.drape_level = 0;
        return spec;
    }());
    ResidentTdb catalogue(tdb);
    Selection without, with;
    int finer = 0;
    for (const bool lifted : {false, true})
        for (const std::uint32_t triangles : {6000u, 20000u, 250000u})
            for (const View& view : views_of(tdb, 8)) {
                LodSettings settings;
                settings.max_triangles = triangles;
                settings.conservative_up = lifted;
                settings.haze_per_m = 1e-5;
                without.select(catalogue, view, settings);
                settings.drape = {30.9 / 4, 0};
                with.select(catalogue, view, settings);
                EXPECT_EQ(with.result.within_budget, without.result.within_budget);
                EXPECT_LE(with.result.tau_reached_px, without.result.tau_reached_px);
                EXPECT_LE(with.result.triangles, std::max(triangles, without.result.triangles));
                expect_balanced(tdb, with);
                finer += with.result.triangles > without.result.triangles ? 1 : 0;
            }
    EXPECT_GT(finer, 5);
}

/// The largest distance in pixels between a true post in view and the drawn one.
double drawn_error_px(const WrittenTdb& tdb, const View& view, const Selection& selection) {
    double worst = 0;
    for (const SelectedChunk& chunk : selection.chunks)
        test_support::visit_drawn_posts(tdb, chunk, 2, [&](std::uint32_t i, std::uint32_t j, const glm::dvec3& drawn) {
            const auto a = project(view, tdb.position(i, j)), b = project(view, drawn);
            if (a.visible && b.visible) worst = std::max(worst, std::hypot(a.x - b.x, a.y - b.y));
        });
    return worst;
}

TEST(LodSelection, NoDrawnPostIsFurtherFromItsTrueOneThanReported) {
    ResidentTdb catalogue(region());
    Selection selection;
    double tightest = 0;
    for (const double tau : {0.5, 2.0, 8.0})
        for (const View& view : views_of(region(), 6)) {
            LodSettings settings;
            settings.tau_px = tau;
            const LodResult& result = selection.select(catalogue, view, settings);
            EXPECT_EQ(result.reason, LodStop::met);
            EXPECT_LE(result.worst_error_px, tau);
            EXPECT_EQ(result.tau_reached_px, tau);
            const double drawn_px = drawn_error_px(region(), view, selection);
            EXPECT_LE(drawn_px, result.worst_error_px * (1 + 1e-6) + 1e-3);
            tightest = std::max(tightest, drawn_px / tau);
        }
    EXPECT_GT(tightest, 0.05) << "errors that never come near their bound prove little";
}

/// Straight down from afar an error of height displaces nothing, and the roots would do.
TEST(LodSelection, HeightsCountWhereTheyAreAskedForAndNoFurtherThanPixelsShow) {
    ResidentTdb catalogue(region());
    Selection selection;
    View view = view_from(region(), 200, 180, 4'000'000, 0, -90);
    double most = 0;
    for (const double px_per_m : {0.002, 0.01, 0.03, 0.1, 1.0}) {
        view.focal_px = px_per_m * 4'000'000;
        LodSettings settings;
        const std::uint32_t places_only = selection.select(catalogue, view, settings).triangles;
        settings.height_weight = 1;
        const LodResult& result = selection.select(catalogue, view, settings);
        EXPECT_LE(result.worst_error_px, settings.tau_px);
        EXPECT_EQ(result.reason, LodStop::met);
        EXPECT_GE(result.triangles, places_only);
        most = std::max(most, static_cast<double>(result.triangles) / places_only);
        for (const SelectedChunk& chunk : selection.chunks) {
            const ChunkEntry& entry = *chunk.entry;
            const double error_m = std::max(double{entry.above_m}, double{entry.below_m});
            const double area_m2 = 4 * double{entry.half_extent_m[0]} * double{entry.half_extent_m[1]};
            const double cell_px = px_per_m * std::sqrt(2 * area_m2 / entry.triangle_count);
            const bool is_fine = error_m * px_per_m <= 1.01 || cell_px <= 2.02 * kFinestCell_px || entry.children == 0;
            EXPECT_TRUE(is_fine) << px_per_m << ": " << error_m << " m in cells of " << cell_px << " px";
        }
    }
    EXPECT_GT(most, 3) << "control: without them fewer triangles do";
}

TEST(LodSelection, EyesInsideBoxesAndFarOutAreNumbers) {
    ResidentTdb catalogue(region());
    Selection selection;
    for (const double above_m : {0.0, 0.5, 30.0, 400000.0})
        for (const double pitch_deg : {-90.0, -45.0, 0.0, 45.0, 90.0}) {
            const View view = view_from(region(), 100, 100, above_m, 77, pitch_deg);
            const LodResult& result = selection.select(catalogue, view, {});
            EXPECT_TRUE(result.within_budget);
            EXPECT_TRUE(std::isfinite(result.worst_error_px));
            EXPECT_TRUE(result.worst_error_px <= 1 || result.reason == LodStop::at_data_limit);
        }
}

TEST(LodSelection, ASmallerTauNeverGivesACoarserChunk) {
    for (const WrittenTdb* tdb : {&region(), &world()}) {
        ResidentTdb catalogue(*tdb);
        Selection selection;
        for (const View& view : views_of(*tdb, 5)) {
            std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> level;
            for (double tau = 64; tau > 0.2; tau /= 1.7) {
                LodSettings settings;
                settings.tau_px = tau;
                (void)selection.select(catalogue, view, settings);
                for (const SelectedChunk& chunk : selection.chunks) {
                    const PostRange posts = tdb->lattice().posts_of(chunk.key);
                    for (std::uint32_t j = posts.j0; j < posts.j1; j += 32)
                        for (std::uint32_t i = posts.i0; i < posts.i1; i += 32) {
                            const auto known = level.insert({{i, j}, chunk.key.level}).first;
                            EXPECT_LE(chunk.key.level, known->second);
                            known->second = chunk.key.level;
                        }
                }
            }
        }
    }
}

TEST(LodSelection, IsAFunctionOfTheViewAlone) {
    ResidentTdb catalogue(region());
    const View view = views_of(region(), 3)[2];
    Selection fresh, used;
    for (const View& other : views_of(region(), 5, 99)) (void)used.select(catalogue, other, {});
    (void)fresh.select(catalogue, view, {});
    (void)used.select(catalogue, view, {});
    EXPECT_EQ(fresh.keys(), used.keys());
    EXPECT_EQ(fresh.result.worst_chunk, used.result.worst_chunk);
}

TEST(LodSelection, TurnedRoundTheEarthItIsTheSame) {
    // Heights of period 32 columns: turning by a whole number of chunks of every level is no change.
    const WrittenTdb tdb([] {
        TdbSpec spec = test_support::whole_earth(257, 129);
        spec.levels = 3;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) {
            return 3000 + 2500 * std::sin((i % 128) * base::kPi / 64) * std::cos(j * 0.9);
        };
        return spec;
    }());
    ResidentTdb catalogue(tdb);
    Selection here, there;
    for (const double heading : {0.0, 90.0, 200.0}) {
        (void)here.select(catalogue, view_from(tdb, 100, 40, 20000, heading, -20), {});
        (void)there.select(catalogue, view_from(tdb, 228, 40, 20000, heading, -20), {});
        std::multiset<std::uint64_t> turned, expected;
        for (const ChunkKey& key : here.keys()) {
            const std::uint32_t across = tdb.lattice().grid_columns(key.level);
            turned.insert(ChunkKey{key.level, (key.i + across / 2) % across, key.j}.packed());
        }
        for (const ChunkKey& key : there.keys()) expected.insert(key.packed());
        EXPECT_EQ(turned, expected);
    }
}

TEST(LodSelection, BudgetsAreNeverExceededAndSayWhatTheyCost) {
    ResidentTdb catalogue(region());
    Selection selection;
    int tried = 0;
    for (const View& view : views_of(region(), 8)) {
        LodSettings settings;
        settings.tau_px = 0.5;
        settings.cost = {50, 20};
        const LodResult ideal = selection.select(catalogue, view, settings);
        const auto expect_within = [&](LodStop reason) {
            const LodResult& result = selection.result;
            ASSERT_TRUE(result.within_budget);
            std::uint32_t triangles = 0;
            for (const SelectedChunk& chunk : selection.chunks) triangles += chunk.entry->triangle_count;
            EXPECT_EQ(triangles, result.triangles);
            EXPECT_EQ(selection.chunks.size(), result.chunks);
            EXPECT_EQ(result.reason, reason);
            EXPECT_GT(result.worst_error_px, 0.5);
            EXPECT_EQ(result.tau_reached_px, result.worst_error_px);
            expect_covered_once(region(), view, selection, 7);
            expect_balanced(region(), selection);
        };
        if (ideal.chunks < 12) continue;
        ++tried;
        for (const double share : {0.3, 0.7}) {
            LodSettings few = settings;
            few.max_triangles = static_cast<std::uint32_t>(share * ideal.triangles);
            (void)selection.select(catalogue, view, few);
            EXPECT_LE(selection.result.triangles, few.max_triangles);
            expect_within(LodStop::triangles);
            few = settings;
            few.max_chunks = static_cast<std::uint32_t>(share * ideal.chunks);
            (void)selection.select(catalogue, view, few);
            EXPECT_LE(selection.result.chunks, few.max_chunks);
            expect_within(LodStop::chunks);
            few = settings;
            few.max_ms = share * ideal.predicted_ms;
            (void)selection.select(catalogue, view, few);
            EXPECT_LE(selection.result.predicted_ms, few.max_ms);
            EXPECT_NEAR(selection.result.predicted_ms, 50e-6 * selection.result.triangles + 20e-3 * selection.result.chunks,
                        1e-9);
            expect_within(LodStop::milliseconds);
        }
    }
    EXPECT_GE(tried, 4);
}

TEST(LodSelection, RootsThatDoNotFitAreNotDrawn) {
    ResidentTdb catalogue(region());
    Selection selection;
    LodSettings settings;
    settings.max_triangles = 100;
    EXPECT_FALSE(selection.select(catalogue, view_from(region(), 200, 200, 500, 0, -10), settings).within_budget);
    EXPECT_EQ(selection.result.chunks, 0u);
    EXPECT_EQ(selection.result.reason, LodStop::triangles);
}

TEST(LodSelection, FewSlotsAndFewNodesAreBudgetsToo) {
    ResidentTdb catalogue(region());
    Selection few_slots(4000, 9), few_nodes(40);
    const View view = view_from(region(), 200, 300, 500, 0, -10);
    EXPECT_EQ(few_slots.select(catalogue, view, {}).reason, LodStop::chunks);
    EXPECT_LE(few_slots.result.chunks, 9u);
    EXPECT_EQ(few_nodes.select(catalogue, view, {}).reason, LodStop::nodes);
    EXPECT_TRUE(few_nodes.result.within_budget);
    expect_covered_once(region(), view, few_nodes, 7);
}

/// Over many views: a single one may be worse by the last split that fits.
TEST(LodSelection, UnderABudgetTheErrorStaysWhereItIsSeenLeast) {
    ResidentTdb catalogue(region());
    Selection clear, hazy;
    const double haze_per_m = 1 / 1500.0;
    double seen_clear = 0, seen_hazy = 0, worst_clear = 0, worst_hazy = 0;  // logarithms
    for (const View& view : some_views(region(), 12, 7, 3))
        for (const double share : {0.2, 0.4, 0.6, 0.8}) {
            LodSettings settings;
            settings.tau_px = 0.3;
            settings.max_triangles = static_cast<std::uint32_t>(clear.select(catalogue, view, settings).triangles * share);
            if (clear.result.chunks < 12) continue;
            ASSERT_TRUE(clear.select(catalogue, view, settings).within_budget);
            settings.haze_per_m = haze_per_m;
            ASSERT_LE(hazy.select(catalogue, view, settings).triangles, settings.max_triangles);
            const auto seen_error_px = [&](const Selection& selection) {
                double worst = 0;
                for (const SelectedChunk& chunk : selection.chunks)
                    worst = std::max(worst, double{chunk.error_px} *
                                                std::max(0.05, std::exp(-box_distance_m(*chunk.entry, view) * haze_per_m)));
                return worst;
            };
            seen_clear += std::log(seen_error_px(clear));
            seen_hazy += std::log(seen_error_px(hazy));
            worst_clear += std::log(clear.result.worst_error_px);
            worst_hazy += std::log(hazy.result.worst_error_px);
        }
    EXPECT_LT(seen_hazy, seen_clear);
    EXPECT_GT(worst_hazy, worst_clear) << "at the cost of error in the haze";
}

TEST(LodSelection, WhatHasNotArrivedIsDrawnCoarserWithoutAHole) {
    ResidentTdb catalogue(region());
    Selection selection;
    for (const View& view : views_of(region(), 6)) {
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
            expect_covered_once(region(), view, selection, 11);
            expect_balanced(region(), selection);
            EXPECT_LE(selection.result.worst_error_px, last_px * (1 + 1e-12));
            last_px = selection.result.worst_error_px;
            EXPECT_EQ(selection.result.reason, last_px <= 0.5 ? LodStop::met : LodStop::not_arrived);
        }
        EXPECT_EQ(selection.keys(), ideal) << "with all that was wanted the ideal is drawn";
        catalogue.is_available = nullptr;
    }
}

TEST(LodSelection, WantedAreTheDrawnAndTheirAncestorsAncestorsFirst) {
    ResidentTdb catalogue(region());
    Selection selection;
    for (const View& view : views_of(region(), 6)) {
        (void)selection.select(catalogue, view, {});
        const std::vector<WantedChunk> wanted = selection.wanted();
        std::set<std::uint64_t> listed, expected;
        for (const WantedChunk& chunk : wanted) {
            EXPECT_TRUE(chunk.key.level + 1 == region().lattice().levels() || listed.count(chunk.key.parent().packed()) != 0)
                << "an ancestor comes before its descendants";
            EXPECT_EQ(key_of(*chunk.entry), chunk.key);
            EXPECT_TRUE(listed.insert(chunk.key.packed()).second) << "once";
        }
        for (ChunkKey key : selection.keys())
            for (; key.level < region().lattice().levels(); key = key.parent()) expected.insert(key.packed());
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
    ResidentTdb catalogue(region());
    std::set<std::uint64_t> here;
    for (const WantedChunk& chunk : resident) here.insert(chunk.key.packed());
    catalogue.is_available = [&](const ChunkKey& key) { return here.count(key.packed()) != 0; };
    Selection selection;
    return selection.select(catalogue, view, {}, SelectionKind::drawn).worst_error_px;
}

TEST(LodSelection, AViewThatTurnsFindsCoarserChunksBesideTheOld) {
    const View view = view_from(region(), 200, 180, 400, 0, -20);
    ResidentTdb catalogue(region());
    Selection selection;
    (void)selection.select(catalogue, view, {});
    const std::vector<WantedChunk> wanted = selection.wanted();
    std::vector<WantedChunk> seen;
    for (const WantedChunk& chunk : wanted)
        if (!is_outside_view(*chunk.entry, view)) seen.push_back(chunk);
    ASSERT_LT(seen.size(), wanted.size());
    int rescued = 0;
    for (double heading_deg = 20; heading_deg < 350; heading_deg += 30) {
        const View turned = view_from(region(), 200, 180, 400, heading_deg, -20);
        const double with_px = drawn_with(wanted, turned), without_px = drawn_with(seen, turned);
        EXPECT_LE(with_px, without_px);
        rescued += with_px < 0.25 * without_px ? 1 : 0;
    }
    EXPECT_GT(rescued, 3);
}

TEST(LodSelection, PartsInMemoryAreABudgetToo) {
    ResidentTdb catalogue(region());
    Selection selection;
    LodSettings settings;
    settings.tau_px = 0.3;
    for (const View& view : views_of(region(), 8)) {
        settings.max_parts = std::numeric_limits<std::uint32_t>::max();
        const double ideal_px = selection.select(catalogue, view, settings).worst_error_px;
        const auto parts_in_view = [&] {
            std::uint32_t parts = 0;
            for (const WantedChunk& chunk : selection.wanted())
                parts += chunk.key.level + 1 < region().lattice().levels() && !is_outside_view(*chunk.entry, view) ? 1u : 0u;
            return parts;
        };
        const std::uint32_t all = parts_in_view();
        if (all < 8) continue;
        settings.max_parts = all / 2;
        (void)selection.select(catalogue, view, settings);
        EXPECT_LE(parts_in_view(), all / 2);
        EXPECT_EQ(selection.result.reason, LodStop::chunks);
        EXPECT_GE(selection.result.worst_error_px, ideal_px);
        expect_covered_once(region(), view, selection, 7);
    }
}

TEST(LodSelection, WhatTheDataAllowToBeFinerIsSeenThroughTheHaze) {
    ResidentTdb catalogue(region());
    Selection selection;
    LodSettings settings;
    settings.max_triangles = 1500;
    const View view = view_from(region(), 200, 340, 3000, 0, -10);
    const LodResult clear = selection.select(catalogue, view, settings);
    ASSERT_GT(clear.worst_coarse_px, settings.tau_px);
    EXPECT_EQ(clear.worst_seen_px, clear.worst_coarse_px);
    settings.haze_per_m = 1e-3;
    const LodResult hazy = selection.select(catalogue, view, settings);
    EXPECT_LT(hazy.worst_seen_px, hazy.worst_coarse_px);
    EXPECT_GE(hazy.worst_seen_px, 0.05 * hazy.worst_coarse_px);
    settings.max_triangles = 250000;
    settings.tau_px = 1e-4;
    const LodResult fine = selection.select(catalogue, view, settings);
    EXPECT_EQ(fine.reason, LodStop::at_data_limit);
    EXPECT_GT(fine.worst_error_px, settings.tau_px);
    EXPECT_LE(fine.worst_seen_px, settings.tau_px) << "the data allow no better";
}

TEST(LodSelection, MissingDirectoryPagesHoldTheRefinementUp) {
    ResidentTdb catalogue(region());
    Selection selection;
    catalogue.is_missing = [](const ChunkKey& key) { return key.level == 0 && key.i >= 4; };
    const View view = view_from(region(), 200, 310, 300, 0, -3);
    LodSettings settings;
    settings.tau_px = 0.2;
    (void)selection.select(catalogue, view, settings);
    EXPECT_EQ(selection.result.reason, LodStop::not_arrived);
    EXPECT_GT(selection.result.tau_reached_px, 0.2);
    expect_covered_once(region(), view, selection, 7);
    for (const ChunkKey& key : selection.keys()) EXPECT_FALSE(catalogue.is_missing(key));
}

TEST(LodSelection, CoarseSourcesEndTheRefinementAtTheirData) {
    // The eastern half is exact at level 1; its neighbours of level 0 are as far as the data go.
    const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = spec.rows = 257;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return rough_height(i, j); };
        spec.is_exact = [](const ChunkKey& key) { return key.level == 1 && key.i >= 2; };
        return spec;
    }());
    ResidentTdb catalogue(tdb);
    Selection selection;
    LodSettings settings;
    settings.tau_px = 1e-3;
    const View view = view_from(tdb, 150, 250, 800, 0, -15);
    (void)selection.select(catalogue, view, settings);
    expect_covered_once(tdb, view, selection, 5);
    expect_balanced(tdb, selection);
    for (const SelectedChunk& chunk : selection.chunks) EXPECT_EQ(chunk.entry->children, 0);
    EXPECT_EQ(selection.result.reason, LodStop::at_data_limit) << "strips beside the coarser half remain";
    EXPECT_LE(drawn_error_px(tdb, view, selection), selection.result.worst_error_px);
}

TEST(LodSelection, RaisedSurfacesAreNowhereBelowTheTrueOneAndWithinTau) {
    for (const WrittenTdb* tdb : {&region(), &world()}) {
        ResidentTdb catalogue(*tdb);
        Selection selection;
        double largest_lift_m = 0;
        for (const View& view : views_of(*tdb, 5)) {
            LodSettings settings;
            settings.tau_px = 3;
            settings.conservative_up = true;
            const LodResult& result = selection.select(catalogue, view, settings);
            ASSERT_TRUE(result.within_budget);
            EXPECT_LE(result.worst_error_px, 3);
            expect_covered_once(*tdb, view, selection, 5);
            expect_balanced(*tdb, selection);
            for (const SelectedChunk& chunk : selection.chunks) {
                largest_lift_m = std::max(largest_lift_m, double{chunk.lift.own_m});
                test_support::visit_drawn_posts(*tdb, chunk, 3, [&](std::uint32_t i, std::uint32_t j, const glm::dvec3& drawn) {
                    const glm::dvec3 up = glm::normalize(tdb->lattice().position(i, j, 1000) - tdb->lattice().position(i, j, 0));
                    const double above_m = glm::dot(drawn - tdb->position(i, j), up);
                    ASSERT_GE(above_m, -1e-3 * std::max(1.0, double{chunk.lift.own_m}));
                });
            }
            EXPECT_LE(drawn_error_px(*tdb, view, selection), result.worst_error_px * (1 + 1e-6) + 1e-3);
        }
        EXPECT_GT(largest_lift_m, 0.5) << "nothing was raised";
    }
}

TEST(LodSelection, ReasonsHaveNames) {
    EXPECT_STREQ(to_string(LodStop::met), "met");
    EXPECT_STREQ(to_string(LodStop::not_arrived), "not_arrived");
    EXPECT_STREQ(to_string(LodStop::at_data_limit), "at_data_limit");
}

}  // namespace
}  // namespace tedavis::terrain
