#include "render_core/scene/glyph_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <map>

#include "tests/support/scene/glyph_sites.hpp"

namespace tedavis::scene::test_glyph_field {
namespace {

using test_support::HeldField;
using test_support::kGlyphAnchor;
using test_support::scattered_numbers;
using test_support::wind_lattice;

std::vector<std::uint32_t> leaves_below(const GlyphField& field, GlyphRef top) {
    std::vector<GlyphRef> stack{top};
    std::vector<std::uint32_t> leaves;
    while (!stack.empty()) {
        const GlyphRef ref = stack.back();
        stack.pop_back();
        if (ref.is_leaf())
            leaves.push_back(ref.index());
        else
            for (const GlyphRef part : field.group(ref).parts) stack.push_back(part);
    }
    return leaves;
}

std::vector<GlyphRef> groups_of(const GlyphField& field) {
    std::vector<GlyphRef> groups, stack{field.root()};
    while (!stack.empty()) {
        const GlyphRef ref = stack.back();
        stack.pop_back();
        if (ref.is_leaf()) continue;
        groups.push_back(ref);
        for (const GlyphRef part : field.group(ref).parts) stack.push_back(part);
    }
    return groups;
}

/// By brute force, from the sites as they were given; a site is found by its number.
void expect_means_of_sites(const GlyphField& field, const std::vector<GlyphSite>& sites) {
    const GlyphFrame& frame = field.frame();
    for (const GlyphRef group : groups_of(field)) {
        const GlyphSummary& summary = field.summary(group);
        long double value = 0, code = 0;
        glm::dvec3 place(0);
        float size = 0;
        const std::vector<std::uint32_t> leaves = leaves_below(field, group);
        for (const std::uint32_t leaf : leaves) {
            const GlyphSite& site = sites[static_cast<std::size_t>(field.summary(GlyphRef::leaf(leaf)).value)];
            const glm::dvec3 local = glm::transpose(frame.axes) * (site.place - frame.anchor);
            value += site.value;
            code += site.uncertainty.code();
            place += local;
            size = std::fmax(size, site.size_m);
            ASSERT_LE(glm::distance(local, glm::dvec3(summary.place)), radius_m(summary) + 0.02);
        }
        const auto count = static_cast<long double>(leaves.size());
        ASSERT_EQ(summary.members, leaves.size());
        ASSERT_NEAR(summary.value, static_cast<double>(value / count), 1e-6 * sites.size());
        ASSERT_LT(glm::distance(glm::dvec3(summary.place), place / static_cast<double>(count)), 0.02);
        ASSERT_EQ(summary.uncertainty.code(), std::ceil(static_cast<double>(code / count)));
        ASSERT_FLOAT_EQ(summary.size_m, size);
    }
}

TEST(GlyphField, EveryGroupIsTheMeanOfItsSites) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 20000);
    const std::vector<GlyphSite> sites = scattered_numbers(frame, 3000, 20000, 4000);
    HeldField held(4096);
    held.fill(sites, frame, GlyphValues::number);
    ASSERT_EQ(held.field.leaves(), sites.size());
    EXPECT_EQ(groups_of(held.field).size(), sites.size() - 1);
    std::vector<std::uint32_t> leaves = leaves_below(held.field, held.field.root());
    std::sort(leaves.begin(), leaves.end());
    for (std::uint32_t n = 0; n < leaves.size(); ++n) ASSERT_EQ(leaves[n], n) << "every site hangs in the tree once";
    expect_means_of_sites(held.field, sites);
}

TEST(GlyphField, GroupsKeepTogetherWhatIsNear) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 128000 / 3.0);
    HeldField held(4096);
    held.fill(wind_lattice(frame, 64, 64, 1, 1000, 100), frame, GlyphValues::wind);
    int groups_of_16 = 0;
    for (const GlyphRef group : groups_of(held.field)) {
        const GlyphSummary& summary = held.field.summary(group);
        // A square of so many posts, or two of them side by side.
        const double side = std::sqrt(2.0 * summary.members) * 1000;
        if (summary.members != 16) continue;
        EXPECT_LE(radius_m(summary), 0.5 * std::hypot(side, 0.5 * side) + 1);
        ++groups_of_16;
    }
    EXPECT_GE(groups_of_16, 15 * 15) << "halves of a cube: 4 x 4 posts, but for the border";
}

TEST(GlyphField, StepsDoNotMatter) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 20000);
    const std::vector<GlyphSite> sites = scattered_numbers(frame, 1000, 20000, 4000);
    HeldField whole(1024), stepped(1024);
    whole.fill(sites, frame, GlyphValues::number);
    stepped.field.begin(frame, GlyphValues::number);
    for (const GlyphSite& site : sites) stepped.field.add(site);
    int steps = 1;
    while (stepped.field.step(7) == GlyphProgress::more) {
        EXPECT_FALSE(stepped.field.is_ready());
        ++steps;
    }
    EXPECT_GT(steps, 1000) << "fourteen looks at each site, seven a step";
    const auto a = groups_of(whole.field), b = groups_of(stepped.field);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
        const GlyphSummary &first = whole.field.summary(a[n]), &second = stepped.field.summary(b[n]);
        ASSERT_EQ(first.place, second.place);
        ASSERT_EQ(first.value, second.value);
        ASSERT_EQ(first.reach_m, second.reach_m);
    }
}

/// The Earth turned under the field: cells follow its own axes.
TEST(GlyphField, GroupsTurnWithTheirFrame) {
    HeldField here(1024), there(1024);
    const earth::Geodetic other{base::radians(-33), base::radians(151), earth::EllipsoidHeight{1500}};
    const GlyphFrame frame = level_frame(kGlyphAnchor, 20000), turned = level_frame(other, 20000);
    here.fill(scattered_numbers(frame, 1000, 20000, 4000), frame, GlyphValues::number);
    there.fill(scattered_numbers(turned, 1000, 20000, 4000), turned, GlyphValues::number);
    const auto a = groups_of(here.field), b = groups_of(there.field);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n) {
        ASSERT_EQ(here.field.summary(a[n]).members, there.field.summary(b[n]).members);
        ASSERT_NEAR(here.field.summary(a[n]).value, there.field.summary(b[n]).value, 1e-3);
    }
}

TEST(GlyphField, NeighboursAreMergedWhereThereIsNoRoom) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 50000);
    const std::vector<GlyphSite> sites = wind_lattice(frame, 100, 100, 2, 1000, 1500);
    HeldField held(512);
    held.fill(sites, frame, GlyphValues::wind);
    EXPECT_LE(held.field.leaves(), 512u);
    EXPECT_GT(held.field.leaves(), 128u);
    long double east = 0, north = 0, speed = 0;
    std::uint32_t missing = 0;
    for (const GlyphSite& site : sites) {
        if (std::isnan(site.value)) {
            ++missing;
            continue;
        }
        east += site.value;
        north += site.north_mps;
        speed += std::hypot(site.value, site.north_mps);
    }
    const GlyphSummary& root = held.field.summary(held.field.root());
    EXPECT_EQ(root.members, sites.size());
    EXPECT_EQ(root.missing, missing);
    const long double valued = sites.size() - missing;
    EXPECT_NEAR(root.value, static_cast<double>(east / valued), 1e-5);
    EXPECT_NEAR(root.north_mps, static_cast<double>(north / valued), 1e-5);
    EXPECT_NEAR(root.speed_mps, static_cast<double>(speed / valued), 1e-5);
    std::uint32_t largest = 0, members = 0;
    for (const std::uint32_t leaf : leaves_below(held.field, held.field.root())) {
        const GlyphSummary& summary = held.field.summary(GlyphRef::leaf(leaf));
        largest = std::max(largest, summary.members);
        members += summary.members;
    }
    EXPECT_EQ(members, sites.size());
    EXPECT_LT(largest, 4 * sites.size() / held.field.leaves()) << "cells are alike everywhere";
}

/// A merged leaf against the sites in its box: the same members, the same mean.
TEST(GlyphField, MergedLeavesAreTheMeansOfTheirMembers) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 256000 / 3.0);
    const std::vector<GlyphSite> sites = wind_lattice(frame, 64, 64, 1, 2000, 1);
    HeldField held(400);
    held.fill(sites, frame, GlyphValues::wind);
    std::map<std::uint32_t, int> sizes;
    for (const std::uint32_t leaf : leaves_below(held.field, held.field.root())) {
        const GlyphSummary& summary = held.field.summary(GlyphRef::leaf(leaf));
        long double east = 0;
        std::uint32_t members = 0, valued = 0;
        for (const GlyphSite& site : sites) {
            const glm::dvec3 local = glm::transpose(frame.axes) * (site.place - frame.anchor);
            const glm::dvec3 off = glm::abs(local - glm::dvec3(summary.place)) - glm::dvec3(summary.reach_m);
            if (std::max({off.x, off.y, off.z}) > 1) continue;
            ++members;
            if (std::isnan(site.value)) continue;
            ++valued;
            east += site.value;
        }
        ++sizes[members];
        ASSERT_EQ(summary.members, members);
        ASSERT_EQ(summary.members - summary.missing, valued);
        if (valued > 0) {
            ASSERT_NEAR(summary.value, static_cast<double>(east / valued), 1e-5);
        }
    }
    int most_alike = 0;
    for (const auto& [members, leaves] : sizes) most_alike = std::max(most_alike, leaves);
    EXPECT_GT(most_alike, static_cast<int>(held.field.leaves()) * 7 / 10) << "squares of a lattice are alike but on its border";
}

TEST(GlyphField, WhatHasNoPlaceIsCountedAndLeftOut) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 1000);
    HeldField held(64);
    held.field.begin(frame, GlyphValues::number);
    GlyphSite site;
    site.place = {std::nan(""), 0, 0};
    EXPECT_FALSE(held.field.add(site));
    site.place = frame.anchor + glm::dvec3(1e9, 0, 0);
    site.size_m = -3;
    EXPECT_TRUE(held.field.add(site)) << "far outside is a place";
    site.place.x = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(held.field.add(site));
    EXPECT_EQ(held.field.step(100), GlyphProgress::done);
    EXPECT_EQ(held.field.given(), 3u);
    EXPECT_EQ(held.field.misplaced(), 2u);
    ASSERT_EQ(held.field.leaves(), 1u);
    EXPECT_TRUE(held.field.root().is_leaf());
    EXPECT_EQ(held.field.summary(held.field.root()).size_m, 0);
}

TEST(GlyphField, NoSitesAndSitesAtOnePlace) {
    const GlyphFrame frame = level_frame(kGlyphAnchor, 1000);
    HeldField held(64);
    held.fill({}, frame, GlyphValues::number);
    EXPECT_TRUE(held.field.is_ready());
    EXPECT_EQ(held.field.leaves(), 0u);
    GlyphSite site;
    site.place = frame.anchor;
    site.value = 2;
    held.fill(std::vector<GlyphSite>(50, site), frame, GlyphValues::number);
    EXPECT_EQ(held.field.leaves(), 50u);
    EXPECT_EQ(held.field.summary(held.field.root()).members, 50u);
    held.fill(std::vector<GlyphSite>(5000, site), frame, GlyphValues::number);
    EXPECT_LE(held.field.leaves(), 64u);
    EXPECT_EQ(held.field.summary(held.field.root()).members, 5000u);
    EXPECT_FLOAT_EQ(held.field.summary(held.field.root()).value, 2);
}

TEST(GlyphField, MemoryIsWhatItSays) {
    for (const std::uint32_t sites : {kMinGlyphSites, 1000u, 131072u}) {
        const std::uint64_t bytes = GlyphField::bytes_needed(sites);
        EXPECT_EQ(GlyphField::sites_within(bytes), sites);
        EXPECT_EQ(GlyphField::sites_within(bytes - 1), sites - 1);
        std::vector<unsigned char> block(bytes);
        base::Arena arena(block.data(), block.size()), small(block.data(), block.size() / 2);
        GlyphField field, other;
        EXPECT_TRUE(field.start(arena, sites));
        EXPECT_FALSE(other.start(small, sites));
    }
    base::Arena none;
    GlyphField field;
    EXPECT_FALSE(field.start(none, kMinGlyphSites - 1));
    EXPECT_EQ(GlyphField::sites_within(0), 0u);
}

}  // namespace
}  // namespace tedavis::scene::test_glyph_field
