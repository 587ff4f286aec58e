#include "render_core/terrain/lod_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "render_core/terrain/projected_error.hpp"
#include "tests/render_core/terrain/drawn_mesh_check.hpp"
#include "tests/render_core/terrain/lod_grounds.hpp"
#include "tests/support/terrain/resident_tdb.hpp"

namespace tedavis::terrain::test_lod_selection {
namespace {

using test_support::expect_balanced;
using test_support::expect_covered_once;
using test_support::project;
using test_support::ResidentTdb;
using test_support::rough_height;
using test_support::rough_region;
using test_support::rough_world;
using test_support::Selection;
using test_support::TdbSpec;
using test_support::view_from;
using test_support::views_of;
using test_support::WrittenTdb;

TEST(LodSelection, EveryVisiblePlaceIsCoveredOnceByChunksOneLevelApart) {
    for (const WrittenTdb* tdb : {&rough_region(), &rough_world()}) {
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
    ResidentTdb catalogue(rough_region());
    Selection selection;
    double tightest = 0;
    for (const double tau : {0.5, 2.0, 8.0})
        for (const View& view : views_of(rough_region(), 6)) {
            LodSettings settings;
            settings.tau_px = tau;
            const LodResult& result = selection.select(catalogue, view, settings);
            EXPECT_EQ(result.reason, LodStop::met);
            EXPECT_LE(result.worst_error_px, tau);
            EXPECT_EQ(result.tau_reached_px, tau);
            const double drawn_px = drawn_error_px(rough_region(), view, selection);
            EXPECT_LE(drawn_px, result.worst_error_px * (1 + 1e-6) + 1e-3);
            tightest = std::max(tightest, drawn_px / tau);
        }
    EXPECT_GT(tightest, 0.05) << "errors that never come near their bound prove little";
}

/// Straight down from afar an error of height displaces nothing, and the roots would do.
TEST(LodSelection, HeightsCountWhereTheyAreAskedForAndNoFurtherThanPixelsShow) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    View view = view_from(rough_region(), 200, 180, 4'000'000, 0, -90);
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
    ResidentTdb catalogue(rough_region());
    Selection selection;
    for (const double above_m : {0.0, 0.5, 30.0, 400000.0})
        for (const double pitch_deg : {-90.0, -45.0, 0.0, 45.0, 90.0}) {
            const View view = view_from(rough_region(), 100, 100, above_m, 77, pitch_deg);
            const LodResult& result = selection.select(catalogue, view, {});
            EXPECT_TRUE(result.within_budget);
            EXPECT_TRUE(std::isfinite(result.worst_error_px));
            EXPECT_TRUE(result.worst_error_px <= 1 || result.reason == LodStop::at_data_limit);
        }
}

TEST(LodSelection, ASmallerTauNeverGivesACoarserChunk) {
    for (const WrittenTdb* tdb : {&rough_region(), &rough_world()}) {
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
    ResidentTdb catalogue(rough_region());
    const View view = views_of(rough_region(), 3)[2];
    Selection fresh, used;
    for (const View& other : views_of(rough_region(), 5, 99)) (void)used.select(catalogue, other, {});
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
    for (const WrittenTdb* tdb : {&rough_region(), &rough_world()}) {
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
}  // namespace tedavis::terrain::test_lod_selection
