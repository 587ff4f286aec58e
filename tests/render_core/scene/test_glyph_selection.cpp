#include "render_core/scene/glyph_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/scene/glyph_sites.hpp"

namespace tedavis::scene::test_glyph_selection {
namespace {

using test_support::glyph_view;
using test_support::HeldField;
using test_support::HeldSelection;
using test_support::kGlyphAnchor;
using test_support::scattered_numbers;
using test_support::sees_sphere;
using test_support::wind_lattice;

std::uint32_t sum(const GlyphCounts& counts) { return counts.drawn + counts.aggregated + counts.hidden; }

/// Numbers of the sites that are drawn themselves.
std::set<int> drawn_numbers(const GlyphSelection& selection) {
    std::set<int> numbers;
    for (const SelectedGlyph& glyph : selection.glyphs())
        if (!glyph.is_aggregate) numbers.insert(static_cast<int>(glyph.summary.value));
    return numbers;
}

struct Scattered {
    explicit Scattered(const GlyphFrame& frame_, int count = 4000)
        : frame(frame_), sites(scattered_numbers(frame, count, 30000, 4000)), held(8192), chosen(8192) {
        held.fill(sites, frame, GlyphValues::number);
    }
    const GlyphCounts& look(const glm::dvec3& from, const glm::dvec3& to, const GlyphSettings& settings = {}) {
        view = glyph_view(frame, from, to);
        return chosen.selection.select(held.field, view, settings);
    }
    GlyphFrame frame;
    std::vector<GlyphSite> sites;
    HeldField held;
    HeldSelection chosen;
    GlyphView view;
};

const glm::dvec3 kFrom(-20000, -28000, 5000), kTo(5000, 4000, 500);

TEST(GlyphSelection, EverySiteIsCountedOnce) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    for (int turn = 0; turn < 12; ++turn) {
        const double angle = turn * 0.5236;
        for (const double distance : {500.0, 9000.0, 60000.0}) {
            const glm::dvec3 from(0, 0, 1500), to(distance * std::sin(angle), distance * std::cos(angle), 1000);
            EXPECT_EQ(sum(scattered.look(from - to, from)), 4000u);
        }
    }
}

/// Against the definition, site by site.
TEST(GlyphSelection, WhatIsLargeEnoughAndInViewIsDrawnItself) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    const GlyphCounts counts = scattered.look(kFrom, kTo);
    const std::set<int> drawn = drawn_numbers(scattered.chosen.selection);
    EXPECT_EQ(drawn.size(), counts.drawn);
    int large = 0;
    for (std::size_t n = 0; n < scattered.sites.size(); ++n) {
        const GlyphSite& site = scattered.sites[n];
        const double distance = glm::distance(site.place, scattered.view.eye);
        const double px = site.size_m * scattered.view.focal_px / distance;
        const bool is_seen = sees_sphere(scattered.view, site.place, 0.5 * site.size_m);
        if (px >= 6.001 && is_seen) {
            ++large;
            EXPECT_EQ(drawn.count(static_cast<int>(n)), 1u) << px << " px";
        }
        if (!sees_sphere(scattered.view, site.place, 0.5 * site.size_m + 6 * distance / scattered.view.focal_px)) {
            EXPECT_EQ(drawn.count(static_cast<int>(n)), 0u);
        }
    }
    EXPECT_GT(large, 150);
    EXPECT_GT(counts.aggregated, 200u);
    EXPECT_GT(counts.hidden, 200u);
    EXPECT_EQ(counts.over_most, 0u);
}

TEST(GlyphSelection, GlyphsStandWhereTheirSitesAreAndAsLarge) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    scattered.look(kFrom, kTo);
    for (const SelectedGlyph& glyph : scattered.chosen.selection.glyphs()) {
        const double distance = glm::length(glm::dvec3(glyph.summary.place));
        EXPECT_NEAR(glyph.size_px, glyph.size_m * scattered.view.focal_px / distance, 1e-3);
        EXPECT_GE(glyph.size_px, 6 - 1e-4);
        if (glyph.is_aggregate) {
            EXPECT_LE(glyph.size_px, 24 + 1e-4);
            EXPECT_LT(glyph.summary.size_m * scattered.view.focal_px / distance, 6.0);
            continue;
        }
        const GlyphSite& site = scattered.sites[static_cast<std::size_t>(glyph.summary.value)];
        EXPECT_LT(glm::distance(site.place, scattered.view.eye + glm::dvec3(glyph.summary.place)), 0.02);
        const double own_px = site.size_m * scattered.view.focal_px / distance;
        EXPECT_NEAR(glyph.size_px, std::min(std::max(own_px, 6.0), 160.0), 1e-3);
    }
}

/// 100,000 of them in view: as many are counted, and the aggregates' means are those of all.
TEST(GlyphSelection, AHundredThousandInView) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 50000);
    const std::vector<GlyphSite> sites = wind_lattice(frame, 250, 200, 2, 300, 800);
    HeldField held(131072);
    held.fill(sites, frame, GlyphValues::wind);
    HeldSelection chosen(16384);
    const GlyphCounts counts =
        chosen.selection.select(held.field, glyph_view(frame, {0, -75000, 50000}, {0, 0, 0}), GlyphSettings{});
    EXPECT_EQ(sum(counts), 100'000u);
    EXPECT_EQ(counts.hidden, 0u);
    EXPECT_EQ(counts.over_most, 0u);
    EXPECT_LT(counts.glyphs, 10'000u);
    long double east = 0, shown_east = 0;
    for (const GlyphSite& site : sites)
        if (!std::isnan(site.value)) east += site.value;
    std::uint32_t members = 0;
    for (const SelectedGlyph& glyph : chosen.selection.glyphs()) {
        members += glyph.summary.members;
        shown_east += static_cast<long double>(glyph.summary.value) * (glyph.summary.members - glyph.summary.missing);
    }
    EXPECT_EQ(members, 100'000u);
    EXPECT_NEAR(static_cast<double>(shown_east), static_cast<double>(east), 1e-6 * 100'000);
}

TEST(GlyphSelection, MoreThanMayBeDrawnStaysTogetherFromAfar) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    const GlyphCounts all = scattered.look(kFrom, kTo);
    for (const std::uint32_t most : {1000u, 300u, 40u, 2u, 1u}) {
        ASSERT_LT(most, all.glyphs);
        GlyphSettings settings;
        settings.most_drawn = most;
        const GlyphCounts counts = scattered.look(kFrom, kTo, settings);
        EXPECT_EQ(sum(counts), 4000u);
        EXPECT_LE(counts.glyphs, most);
        if (most >= 40) {
            EXPECT_GT(counts.glyphs, most / 2) << "room is used";
        }
        EXPECT_GT(counts.over_most, 0u);
        EXPECT_EQ(scattered.chosen.selection.glyphs().size(), counts.glyphs);
    }
    GlyphSettings settings;
    settings.most_drawn = 0;
    const GlyphCounts none = scattered.look(kFrom, kTo, settings);
    EXPECT_EQ(none.hidden, 4000u);
    EXPECT_EQ(none.over_most, 4000u);
    EXPECT_EQ(none.glyphs, 0u);
}

TEST(GlyphSelection, NearGlyphsStayTheirOwnWhenRoomIsShort) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    GlyphSettings settings;
    settings.most_drawn = 400;
    scattered.look(kFrom, kTo, settings);
    double own_m = 0, together_m = 0;
    int own = 0, together = 0;
    for (const SelectedGlyph& glyph : scattered.chosen.selection.glyphs()) {
        (glyph.is_aggregate ? together_m : own_m) += glm::length(glyph.summary.place);
        ++(glyph.is_aggregate ? together : own);
    }
    ASSERT_GT(own, 20);
    ASSERT_GT(together, 20);
    EXPECT_LT(own_m / own, 0.7 * together_m / together);
}

TEST(GlyphSelection, LessDetailMeansFewerAndLargerGlyphs) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 50000);
    HeldField held(16384);
    held.fill(wind_lattice(frame, 100, 100, 1, 500, 1), frame, GlyphValues::wind);
    HeldSelection chosen(16384);
    std::uint32_t before = 0xFFFFFFFFu;
    for (double detail = 1; detail >= 0; detail -= 0.125) {
        GlyphSettings settings;
        settings.detail = detail;
        const GlyphCounts counts =
            chosen.selection.select(held.field, glyph_view(frame, {0, -50000, 25000}, {0, 0, 0}), settings);
        EXPECT_EQ(sum(counts), 10'000u);
        EXPECT_LE(counts.glyphs, before);
        before = counts.glyphs;
    }
    EXPECT_LT(before, 200u);
    EXPECT_GT(before, 4u);
}

TEST(GlyphSelection, TurnsWithTheWorld) {
    Scattered here(level_frame(kGlyphAnchor, 30000));
    Scattered there(level_frame({base::radians(-33), base::radians(151), earth::EllipsoidHeight{1500}}, 30000));
    const GlyphCounts a = here.look(kFrom, kTo), b = there.look(kFrom, kTo);
    const std::set<int> first = drawn_numbers(here.chosen.selection), second = drawn_numbers(there.chosen.selection);
    std::vector<int> different;
    std::set_symmetric_difference(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(different));
    EXPECT_LE(different.size(), first.size() / 500) << "but for rounding at the limits";
    EXPECT_NEAR(a.aggregated, b.aggregated, 10);
    EXPECT_NEAR(a.hidden, b.hidden, 10);
}

TEST(GlyphSelection, AMetreChangesLittle) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    const auto places = [&] {
        std::set<std::array<float, 2>> values;
        for (const SelectedGlyph& glyph : scattered.chosen.selection.glyphs())
            values.insert({glyph.summary.value, static_cast<float>(glyph.summary.members)});
        return values;
    };
    for (const std::uint32_t most : {8192u, 500u}) {
        GlyphSettings settings;
        settings.most_drawn = most;
        scattered.look(kFrom, kTo, settings);
        const auto before = places();
        scattered.look(kFrom + glm::dvec3(0.6, 0.6, 0.5), kTo, settings);
        const auto after = places();
        std::vector<std::array<float, 2>> kept;
        std::set_intersection(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(kept));
        EXPECT_GT(kept.size(), before.size() * 97 / 100);
    }
}

TEST(GlyphSelection, SameArgumentsSameGlyphsWhateverWasBefore) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    GlyphSettings settings;
    settings.most_drawn = 600;
    scattered.look(kFrom, kTo, settings);
    const base::Span<const SelectedGlyph> glyphs = scattered.chosen.selection.glyphs();
    const std::vector<SelectedGlyph> before(glyphs.begin(), glyphs.end());
    scattered.look(kTo, kFrom);
    scattered.look(kFrom, kTo, settings);
    ASSERT_EQ(scattered.chosen.selection.glyphs().size(), before.size());
    for (std::size_t n = 0; n < before.size(); ++n) {
        ASSERT_EQ(scattered.chosen.selection.glyphs()[n].summary.place, before[n].summary.place);
        ASSERT_EQ(scattered.chosen.selection.glyphs()[n].size_m, before[n].size_m);
    }
}

TEST(GlyphSelection, WhatTheFieldMergedCountsAsAggregated) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 50000);
    HeldField held(512);
    held.fill(wind_lattice(frame, 100, 100, 1, 300, 1), frame, GlyphValues::wind);
    HeldSelection chosen(1024);
    const GlyphCounts counts = chosen.selection.select(held.field, glyph_view(frame, {0, -40000, 20000}, {0, 0, 0}), {});
    EXPECT_EQ(sum(counts), 10'000u);
    EXPECT_GT(counts.glyphs, 50u);
    EXPECT_LT(counts.drawn, 50u) << "but on the border every leaf stands for several";
    EXPECT_GT(counts.aggregated, 5'000u);
}

TEST(GlyphSelection, AFieldThatIsNotReadyIsHidden) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 1000);
    HeldField held(64);
    HeldSelection chosen(64);
    const GlyphView view = glyph_view(frame, {0, -2000, 500}, {0, 0, 0});
    EXPECT_EQ(sum(chosen.selection.select(held.field, view, {})), 0u);
    held.field.begin(frame, GlyphValues::number);
    GlyphSite site;
    site.place = frame.anchor;
    site.size_m = 100;
    held.field.add(site);
    EXPECT_EQ(chosen.selection.select(held.field, view, {}).hidden, 1u);
    held.field.step(100);
    EXPECT_EQ(chosen.selection.select(held.field, view, {}).drawn, 1u);
    site.place.x = std::nan("");
    held.fill({site, site}, frame, GlyphValues::number);
    EXPECT_EQ(chosen.selection.select(held.field, view, {}).hidden, 2u) << "misplaced ones as well";
}

TEST(GlyphSelection, NothingIsLargerThanTheMost) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 1000);
    HeldField held(64);
    HeldSelection chosen(64);
    GlyphSite site;
    site.place = frame.anchor;
    site.size_m = 100;
    held.fill({site}, frame, GlyphValues::number);
    for (const double distance_m : {6.0, 60.0, 600.0, 6000.0}) {
        chosen.selection.select(held.field, glyph_view(frame, {0, -distance_m, 0}, {0, 0, 0}), {});
        ASSERT_EQ(chosen.selection.glyphs().size(), 1u);
        const double px = 100 * 900 / distance_m;
        EXPECT_NEAR(chosen.selection.glyphs()[0].size_px, std::min(px, 160.0), 1e-3);
    }
}

TEST(GlyphSelection, MemoryIsWhatItSays) {
    std::vector<unsigned char> block(GlyphSelection::bytes_needed(1000));
    base::Arena arena(block.data(), block.size()), small(block.data(), block.size() / 2), none;
    GlyphSelection enough, less, nothing;
    EXPECT_TRUE(enough.start(arena, 1000));
    EXPECT_FALSE(less.start(small, 1000));
    EXPECT_FALSE(nothing.start(none, 0));
}

/// Left and right of the view's middle.
TEST(GlyphSelection, OnlyCrowdedRegionsHaveFewerGlyphs) {
    Scattered scattered(level_frame(kGlyphAnchor, 30000));
    DetailRegions crowded;
    for (std::size_t row = 0; row < DetailRegions::kDown; ++row)
        for (std::size_t column = 0; column < DetailRegions::kAcross / 2; ++column)
            crowded.factor[row * DetailRegions::kAcross + column] = 0.25f;
    const auto sides = [&](const DetailRegions* regions) {
        GlyphSettings settings;
        settings.regions = regions;
        const GlyphCounts counts = scattered.look(kFrom, kTo, settings);
        EXPECT_EQ(sum(counts), 4000u);
        std::pair<int, int> found{0, 0};
        const GlyphView& view = scattered.view;
        for (const SelectedGlyph& glyph : scattered.chosen.selection.glyphs()) {
            const glm::dvec3 way(glyph.summary.place);
            const double across = glm::dot(way, view.right) / glm::dot(way, view.forward) / view.half_width_tangent;
            // Groups across the middle are in either.
            if (across < -0.1) ++found.first;
            if (across > 0.1) ++found.second;
        }
        return found;
    };
    const auto [left, right] = sides(nullptr);
    const auto [left_crowded, right_beside] = sides(&crowded);
    ASSERT_GT(left, 50);
    EXPECT_LT(left_crowded, left / 2);
    EXPECT_NEAR(right_beside, right, 3) << "but for groups whose mean place is on the left";
    const DetailRegions whole;
    EXPECT_EQ(sides(&whole), std::pair(left, right));
}

}  // namespace
}  // namespace tedavis::scene::test_glyph_selection
