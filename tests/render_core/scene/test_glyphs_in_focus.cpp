// Glyph selection with foci: what is in one is selected as without foci, the rest makes way.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/scene/glyph_sites.hpp"

namespace tedavis::scene::test_glyphs_in_focus {
namespace {

using test_support::glyph_view;
using test_support::HeldField;
using test_support::HeldSelection;
using test_support::kGlyphAnchor;

constexpr int kSites = 6000;

FocusRegion disc(const glm::dvec2& middle, double radius_m, double width_m) {
    FocusRegion region = focus_region_at(kGlyphAnchor.latitude_rad, kGlyphAnchor.longitude_rad);
    region.radius_m = radius_m;
    region.context.width_m = width_m;
    region.points[0] = middle;
    region.point_count = 1;
    return region;
}

/// Numbers 0 .. kSites at random places over 60 km, each seen by its own number where it stands for itself.
struct Scattered {
    explicit Scattered(const FocusRegion& region)
        : frame(level_frame(kGlyphAnchor, 30'000)),
          sites(test_support::scattered_numbers(frame, kSites, 30'000, 3000)),
          held(8192),
          chosen(8192) {
        held.fill(sites, frame, GlyphValues::number);
        EXPECT_TRUE(regions.try_push_back(region));
        focus.regions = &regions;
        focus.coarser.fill(1);
        focus.across.fill(1);
        focus.least_degree = 0.5;
    }
    const GlyphCounts& select(bool with_focus) {
        GlyphSettings settings;
        settings.least_px = 2;
        settings.cell_px = 8;
        settings.focus = with_focus ? &focus : nullptr;
        return chosen.selection.select(held.field, glyph_view(frame, {0, -35'000, 9000}, {0, 4000, 0}), settings);
    }
    /// By numbers: the degrees of those that stand for themselves.
    std::map<int, int> singles() const {
        std::map<int, int> found;
        for (const SelectedGlyph& glyph : chosen.selection.glyphs())
            if (!glyph.is_aggregate) found[static_cast<int>(glyph.summary.value)] = glyph.degree;
        return found;
    }
    double degree(int number) const {
        const glm::dvec3& place = sites[static_cast<std::size_t>(number)].place;
        return focus_degree(regions[0], place, height_m(regions[0], place));
    }

    GlyphFrame frame;
    std::vector<GlyphSite> sites;
    HeldField held;
    HeldSelection chosen;
    FocusRegions regions;
    GlyphFocus focus;
};

TEST(GlyphsInFocus, AreAsTheyAreWithoutIt) {
    Scattered scattered(disc({2000, 3000}, 5000, 6000));
    const GlyphCounts all = scattered.select(false);
    const std::map<int, int> before = scattered.singles();
    for (const auto& [number, degree] : before) EXPECT_EQ(degree, SelectedGlyph::kInFocus);
    scattered.focus.coarser.fill(12);
    scattered.focus.coarser[GlyphFocus::kSteps] = 1;
    const GlyphCounts fewer = scattered.select(true);
    EXPECT_EQ(fewer.drawn + fewer.aggregated + fewer.hidden, static_cast<std::uint32_t>(kSites));
    EXPECT_LT(fewer.glyphs, all.glyphs / 2) << "elsewhere they are aggregated";
    const std::map<int, int> after = scattered.singles();
    int in_focus = 0;
    for (const auto& [number, degree] : before) {
        if (scattered.degree(number) < 1) continue;
        ++in_focus;
        ASSERT_EQ(after.count(number), 1u) << number;
        EXPECT_EQ(after.at(number), SelectedGlyph::kInFocus);
    }
    EXPECT_GT(in_focus, 40);
}

/// However large they are on the screen.
TEST(GlyphsInFocus, BesideItGroupsOfSoManyAcrossAreOne) {
    Scattered scattered(disc({2000, 3000}, 5000, 6000));
    const GlyphCounts all = scattered.select(true);
    scattered.focus.across.fill(20);
    scattered.focus.across[GlyphFocus::kSteps] = 1;
    const GlyphCounts fewer = scattered.select(true);
    EXPECT_LT(fewer.glyphs, all.glyphs * 3 / 4);
    EXPECT_EQ(fewer.drawn + fewer.aggregated + fewer.hidden, static_cast<std::uint32_t>(kSites));
}

TEST(GlyphsInFocus, EachHasItsDegreeByPlace) {
    FocusRegion region = disc({2000, 3000}, 5000, 6000);
    region.context.levels = 3;
    Scattered scattered(region);
    scattered.select(true);
    int between = 0;
    for (const auto& [number, degree] : scattered.singles()) {
        EXPECT_NEAR(degree, 255 * scattered.degree(number), 0.51) << number;
        between += degree > 0 && degree < 255 ? 1 : 0;
    }
    EXPECT_GT(between, 20);
}

TEST(GlyphsInFocus, AContextThatIsNotShownIsHiddenAndCounted) {
    Scattered scattered(disc({2000, 3000}, 5000, 6000));
    const std::uint32_t hidden = scattered.select(true).hidden;
    scattered.focus.hides_context = true;
    const GlyphCounts counts = scattered.select(true);
    EXPECT_EQ(counts.drawn + counts.aggregated + counts.hidden, static_cast<std::uint32_t>(kSites));
    EXPECT_GT(counts.hidden, hidden + 1000);
    for (const auto& [number, degree] : scattered.singles()) EXPECT_GT(degree, 0) << number;
    std::uint32_t shown = 0;
    for (const SelectedGlyph& glyph : scattered.chosen.selection.glyphs()) shown += glyph.summary.members;
    EXPECT_EQ(shown, counts.drawn + counts.aggregated);
}

TEST(GlyphsInFocus, NoMemberOfTheFocusIsLostInAGroup) {
    Scattered scattered(disc({-9000, 12'000}, 1500, 0));
    scattered.focus.hides_context = true;
    scattered.focus.coarser.fill(40);
    scattered.focus.coarser[GlyphFocus::kSteps] = 1;
    scattered.select(true);
    std::uint32_t members = 0, expected = 0;
    for (const SelectedGlyph& glyph : scattered.chosen.selection.glyphs()) members += glyph.summary.members;
    for (int n = 0; n < kSites; ++n) expected += scattered.degree(n) >= 1 ? 1 : 0;
    EXPECT_GE(members, expected);
    EXPECT_GT(expected, 0u);
    EXPECT_LT(members, expected + 12) << "a control: hardly more than these";
}

TEST(GlyphsInFocus, ByValueWhereAFocusMeansTheGlyphsOwn) {
    Scattered scattered(disc({0, 0}, 60'000, 0));  // where such values are: anywhere
    scattered.focus.by_value[0] = true;
    scattered.focus.ranges[0] = {1000, 1500, 200, 1};
    scattered.focus.hides_context = true;
    scattered.select(true);
    int in_focus = 0;
    for (const auto& [number, degree] : scattered.singles()) {
        EXPECT_GE(number, 800);
        EXPECT_LE(number, 1700);
        EXPECT_EQ(degree, number >= 1000 && number <= 1500 ? 255 : 128) << number;
        in_focus += degree == 255 ? 1 : 0;
    }
    EXPECT_GT(in_focus, 50);
}

}  // namespace
}  // namespace tedavis::scene::test_glyphs_in_focus
