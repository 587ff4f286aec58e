#include "render_core/draw/data/glyph_sites.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_glyph_sites {
namespace {

using test_support::ElementOfTest;

constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// 3 x 2 posts without levels; one is missing.
host_sim::LayerDraft wind_draft() {
    host_sim::LayerDraft layer;
    layer.name = "wind";
    layer.role = scene::LayerRole::wind;
    layer.shape = scene::LayerShape::grid;
    layer.grid = {base::radians(9), base::radians(47), base::radians(0.01), base::radians(0.01), 3, 2, 1, 1};
    for (const char* name : {"east", "north"}) {
        host_sim::AttributeDraft attribute;
        attribute.name = name;
        attribute.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
        attribute.uncertainty_all = scene::Uncertainty::from_level(0.25);
        for (int n = 0; n < 6; ++n) attribute.values.push_back(static_cast<float>(name[0] == 'e' ? n : 10 * n));
        layer.attributes.push_back(attribute);
    }
    layer.attributes[0].values[4] = std::numeric_limits<float>::quiet_NaN();
    return layer;
}

/// A field with what an element has put into it.
class FilledField {
public:
    FilledField(ElementOfTest& test, std::int64_t time_ns, std::uint32_t step = 1000)
        : block_(scene::GlyphField::bytes_needed(256)), arena_(block_.data(), block_.size()) {
        EXPECT_TRUE(field.start(arena_, 256));
        GlyphSites sites;
        begun = sites.begin(test.input(), time_ns, field);
        if (!begun) return;
        for (steps = 1; !sites.step(test.ground, field, step); ++steps) continue;
        while (field.step(1000) == scene::GlyphProgress::more) continue;
    }
    [[nodiscard]] scene::GlyphSummary all() const { return field.summary(field.root()); }

    scene::GlyphField field;
    bool begun = false;
    int steps = 0;

private:
    std::vector<unsigned char> block_;
    base::Arena arena_;
};

TEST(GlyphSites, WindHasASiteAPostAndItsMean) {
    ElementOfTest test(wind_draft());
    const FilledField filled(test, 0);
    ASSERT_TRUE(filled.begun);
    EXPECT_EQ(filled.field.given(), 6u);
    EXPECT_EQ(filled.field.values(), scene::GlyphValues::wind);
    const scene::GlyphSummary all = filled.all();
    EXPECT_EQ(all.missing, 1u);
    EXPECT_NEAR(all.value, (0 + 1 + 2 + 3 + 5) / 5.0, 1e-5);
    EXPECT_NEAR(all.north_mps, 10 * (0 + 1 + 2 + 3 + 5) / 5.0, 1e-4);
}

TEST(GlyphSites, StepsChangeNothing) {
    ElementOfTest test(wind_draft());
    const FilledField at_once(test, 0), in_steps(test, 0, 1);
    EXPECT_GT(in_steps.steps, 5);
    EXPECT_EQ(at_once.all().value, in_steps.all().value);
    EXPECT_EQ(at_once.all().place, in_steps.all().place);
}

TEST(GlyphSites, PostsStandOverTheGroundOrAtTheDesignsHeights) {
    ElementOfTest test(wind_draft());
    const auto height_of = [&] {
        const FilledField filled(test, 0);
        const scene::GlyphFrame& frame = filled.field.frame();
        return earth::from_ecef(frame.anchor + frame.axes * glm::dvec3(filled.all().place)).height.m;
    };
    EXPECT_NEAR(height_of(), 600 + kOverGround_m, 0.5);
    EXPECT_TRUE(test.element.heights_m.try_push_back(1000) && test.element.heights_m.try_push_back(3000));
    EXPECT_NEAR(height_of(), 2050, 0.5);
    const FilledField two(test, 0);
    EXPECT_EQ(two.field.given(), 12u) << "a site a post and height";
    test.element.heights_over_ground = true;
    EXPECT_NEAR(height_of(), 2600, 0.5) << "600 m is the ground's";
}

TEST(GlyphSites, WhatHasALinkKnowsHowFarItFloats) {
    ElementOfTest test(wind_draft());
    const auto over = [&] { return FilledField(test, 0).all().over_ground_m; };
    EXPECT_TRUE(std::isnan(over())) << "nobody asks";
    test.element.link = true;
    EXPECT_NEAR(over(), kOverGround_m, 1e-2);
    EXPECT_TRUE(test.element.heights_m.try_push_back(1000) && test.element.heights_m.try_push_back(3000));
    EXPECT_NEAR(over(), (1000 + 3000) / 2.0 + 50 - 600, 1e-2) << "the geoid lies 50 m over the ellipsoid";
    ElementOfTest points(test_support::small_points());
    points.element.link = true;
    const FilledField filled(points, 0);
    const scene::Layer& layer = points.input().layer;
    double mean = 0;
    for (const scene::ScenePoint& point : layer.points) {
        const bool on_ground = layer.entry->height_datum == scene::HeightDatum::ground || std::isnan(point.height_m);
        const double height_m = std::isnan(point.height_m) ? 0 : double{point.height_m};
        mean += (on_ground ? height_m : height_m - 600) / 3;
    }
    EXPECT_NEAR(filled.all().over_ground_m, mean, 1e-2);
}

TEST(GlyphSites, WithoutGroundTheyHaveNoPlace) {
    ElementOfTest test(wind_draft());
    test.ground.is_known = false;
    const FilledField filled(test, 0);
    EXPECT_EQ(filled.field.misplaced(), 6u);
    EXPECT_EQ(filled.field.given(), 6u) << "counted all the same";
}

TEST(GlyphSites, LittleDetailHasTheFirstHeights) {
    ElementOfTest test(wind_draft());
    for (const double height_m : {200.0, 400.0, 600.0, 800.0}) ASSERT_TRUE(test.element.heights_m.try_push_back(height_m));
    for (const auto& [detail, heights] : {std::pair<double, std::uint32_t>{1, 4}, {0.6, 3}, {0.25, 1}, {0, 1}}) {
        test.element.detail = detail;
        EXPECT_EQ(FilledField(test, 0).field.given(), heights * 6) << detail;
        EXPECT_EQ(glyph_count(test.element, test.input().layer), heights * 6);
    }
}

TEST(GlyphSites, GlyphsAreAsLargeAsPostsAreApartOrAsTheDesignSays) {
    ElementOfTest test(wind_draft());
    const double spacing = base::radians(0.01) * earth::prime_vertical_radius_m(base::radians(47)) * std::cos(base::radians(47));
    EXPECT_NEAR(FilledField(test, 0).all().size_m, kShareOfSpacing * spacing, 1);
    host_sim::LayerDraft coarse = wind_draft();
    coarse.grid.step_lon_rad *= 25;
    coarse.grid.step_lat_rad *= 25;
    ElementOfTest wide(coarse);
    EXPECT_NEAR(FilledField(wide, 0).all().size_m, kMaxGridGlyph_m, 1e-3);
    test.element.size_m = 77;
    EXPECT_NEAR(FilledField(test, 0).all().size_m, 77, 1e-3);
}

TEST(GlyphSites, ValuesAreThoseOfTheTimeAndAge) {
    host_sim::LayerDraft layer = test_support::small_grid();
    layer.attributes[0].uncertainty_growth_per_hour = 0.1;
    ElementOfTest test(layer);
    test.element.by_color.attribute = "temperature";
    const scene::GlyphSummary first = FilledField(test, 0).all(), later = FilledField(test, kHour_ns / 2).all();
    EXPECT_NEAR(later.value - first.value, 12, 0.5) << "24 K an hour";
    EXPECT_EQ(first.missing, 1u);
    const scene::GlyphSummary old = FilledField(test, 5 * kHour_ns).all();
    EXPECT_GT(old.uncertainty.level(), later.uncertainty.level());
    EXPECT_TRUE(glyphs_change(test.input().layer, *glyph_attribute(test.element, test.input().layer)));
}

TEST(GlyphSites, PointsHaveTheirOwnValues) {
    ElementOfTest test(test_support::small_points());
    const FilledField filled(test, 0);
    ASSERT_TRUE(filled.begun);
    EXPECT_EQ(filled.field.values(), scene::GlyphValues::category);
    EXPECT_EQ(filled.field.given(), 3u);
    EXPECT_TRUE(filled.all().is_mixed) << "masts and a turbine";
    EXPECT_NEAR(filled.all().size_m, kPointGlyph_m, 1e-3);
    EXPECT_FALSE(glyphs_change(test.input().layer, *glyph_attribute(test.element, test.input().layer)));
}

TEST(GlyphSites, WhatTheLayerDoesNotHaveGivesNone) {
    ElementOfTest test(test_support::small_points());
    test.element.by_color.attribute = "smoke";
    EXPECT_FALSE(FilledField(test, 0).begun);
    host_sim::LayerDraft bare = test_support::small_points();
    bare.attributes.clear();
    ElementOfTest alike(bare);
    const FilledField places(alike, 0);
    EXPECT_TRUE(places.begun) << "points that say nothing but where they are";
    EXPECT_EQ(places.field.given(), 3u);
    EXPECT_EQ(places.all().missing, 0u);
    EXPECT_FALSE(places.all().uncertainty.is_known());
    ElementOfTest empty(test_support::small_meshes());
    EXPECT_FALSE(FilledField(empty, 0).begun) << "no attribute at all";
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_sites
