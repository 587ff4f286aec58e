// Selections under budgets of triangles, chunks, parts, nodes and milliseconds.
#include "render_core/terrain/lod_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/terrain/projected_error.hpp"
#include "tests/render_core/terrain/lod_grounds.hpp"
#include "tests/support/terrain/resident_tdb.hpp"

namespace tedavis::terrain::test_lod_budgets {
namespace {

using test_support::expect_balanced;
using test_support::expect_covered_once;
using test_support::ResidentTdb;
using test_support::rough_region;
using test_support::Selection;
using test_support::view_from;
using test_support::views_of;

TEST(LodSelection, WhatIsDrawnTwiceCostsTwice) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    int tried = 0;
    for (const View& view : views_of(rough_region(), 8)) {
        LodSettings settings;
        settings.tau_px = 0.5;
        const LodResult once = selection.select(catalogue, view, settings);
        if (once.chunks < 12) continue;
        const std::size_t middle = selection.chunks.size() / 2;
        const DepthSpan some = depth_span(*selection.chunks[middle].entry, view, 0);
        settings.twice = {some.near_m, some.far_m};
        (void)selection.select(catalogue, view, settings);
        std::uint32_t triangles = 0, twice = 0;
        for (const SelectedChunk& chunk : selection.chunks) {
            const DepthSpan span = depth_span(*chunk.entry, view, 0);
            const bool is_twice = span.far_m >= some.near_m && span.near_m <= some.far_m;
            triangles += chunk.entry->triangle_count * (is_twice ? 2u : 1u);
            twice += is_twice ? 1 : 0;
        }
        EXPECT_EQ(selection.result.triangles, triangles);
        EXPECT_GT(twice, 0u);
        settings.max_triangles = once.triangles;
        EXPECT_LE(selection.select(catalogue, view, settings).triangles, once.triangles) << "within the budget all the same";
        ++tried;
    }
    EXPECT_GT(tried, 2);
}

TEST(LodSelection, BudgetsAreNeverExceededAndSayWhatTheyCost) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    int tried = 0;
    for (const View& view : views_of(rough_region(), 8)) {
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
            expect_covered_once(rough_region(), view, selection, 7);
            expect_balanced(rough_region(), selection);
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
    ResidentTdb catalogue(rough_region());
    Selection selection;
    LodSettings settings;
    settings.max_triangles = 100;
    EXPECT_FALSE(selection.select(catalogue, view_from(rough_region(), 200, 200, 500, 0, -10), settings).within_budget);
    EXPECT_EQ(selection.result.chunks, 0u);
    EXPECT_EQ(selection.result.reason, LodStop::triangles);
}

TEST(LodSelection, FewSlotsAndFewNodesAreBudgetsToo) {
    ResidentTdb catalogue(rough_region());
    Selection few_slots(4000, 9), few_nodes(40);
    const View view = view_from(rough_region(), 200, 300, 500, 0, -10);
    EXPECT_EQ(few_slots.select(catalogue, view, {}).reason, LodStop::chunks);
    EXPECT_LE(few_slots.result.chunks, 9u);
    EXPECT_EQ(few_nodes.select(catalogue, view, {}).reason, LodStop::nodes);
    EXPECT_TRUE(few_nodes.result.within_budget);
    expect_covered_once(rough_region(), view, few_nodes, 7);
}

/// Over many views: a single one may be worse by the last split that fits.
TEST(LodSelection, UnderABudgetTheErrorStaysWhereItIsSeenLeast) {
    ResidentTdb catalogue(rough_region());
    Selection clear, hazy;
    const double haze_per_m = 1 / 1500.0;
    double seen_clear = 0, seen_hazy = 0, worst_clear = 0, worst_hazy = 0;  // logarithms
    for (const View& view : some_views(rough_region(), 12, 7, 3))
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

TEST(LodSelection, PartsInMemoryAreABudgetToo) {
    ResidentTdb catalogue(rough_region());
    Selection selection;
    LodSettings settings;
    settings.tau_px = 0.3;
    for (const View& view : views_of(rough_region(), 8)) {
        settings.max_parts = std::numeric_limits<std::uint32_t>::max();
        const double ideal_px = selection.select(catalogue, view, settings).worst_error_px;
        const auto parts_in_view = [&] {
            std::uint32_t parts = 0;
            for (const WantedChunk& chunk : selection.wanted())
                parts +=
                    chunk.key.level + 1 < rough_region().lattice().levels() && !is_outside_view(*chunk.entry, view) ? 1u : 0u;
            return parts;
        };
        const std::uint32_t all = parts_in_view();
        if (all < 8) continue;
        settings.max_parts = all / 2;
        (void)selection.select(catalogue, view, settings);
        EXPECT_LE(parts_in_view(), all / 2);
        EXPECT_EQ(selection.result.reason, LodStop::chunks);
        EXPECT_GE(selection.result.worst_error_px, ideal_px);
        expect_covered_once(rough_region(), view, selection, 7);
    }
}

}  // namespace
}  // namespace tedavis::terrain::test_lod_budgets
