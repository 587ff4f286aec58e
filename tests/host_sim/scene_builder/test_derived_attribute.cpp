#include "host_sim/scene_builder/derived_attribute.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <limits>

#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_derived_attribute {
namespace {

using scene::Uncertainty;
using scene::ValueState;
using test_support::expect_user_error;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::int64_t kHour_ns = 3'600'000'000'000;
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

/// East 10 m/s at 1000 m and 20 at 3000, 8 more an hour later; north 4 everywhere. Standard deviations 2 and 1 m/s.
LayerDraft wind() {
    LayerDraft layer = test_support::small_grid();
    layer.name = "wind";
    layer.attributes.clear();
    AttributeDraft east, north;
    east.name = "east";
    north.name = "north";
    for (AttributeDraft* a : {&east, &north}) {
        a->uncertainty_kind = scene::UncertaintyKind::standard_deviation;
        a->uncertainty_full = 4;
        a->uncertainty_all = Uncertainty::from_level(a == &east ? 0.5 : 0.25);
    }
    for (const float time : {0.0f, 8.0f})
        for (const float level : {10.0f, 20.0f})
            for (int post = 0; post < 12; ++post) {
                east.values.push_back(level + time);
                north.values.push_back(4);
            }
    layer.attributes = {east, north};
    return layer;
}

/// Two lines over the grid at 2000 m, half an hour into it: one east, one north; 10 s a point.
LayerDraft flights() {
    LayerDraft layer;
    layer.name = "flights";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    for (int n = 0; n < 3; ++n) layer.points.push_back(test_support::scene_point(46.5, 9.2 + 0.01 * n, 2000));
    for (int n = 0; n < 3; ++n) layer.points.push_back(test_support::scene_point(46.4 + 0.01 * n, 9.2, 2000));
    for (std::size_t n = 0; n < 6; ++n)
        layer.points[n].time_ns = kHour_ns / 2 + static_cast<std::int64_t>(n % 3) * 10'000'000'000;
    layer.starts = {0, 3, 6};
    return layer;
}

LayerRecipe recipe_of(const std::string& quantity) {
    LayerRecipe recipe;
    recipe.name = "flights";
    recipe.wind_layer = "wind";
    AttributeRecipe attribute;
    attribute.name = quantity;
    attribute.variable = "derived:" + quantity;
    recipe.attributes = {attribute};
    return recipe;
}

struct Made {
    AttributeDraft attribute;
    std::vector<std::string> notes;
};
Made derive(const LayerRecipe& recipe, LayerDraft layer = flights(), const LayerDraft& field = wind()) {
    Made made;
    made.notes = add_derived(recipe, layer, {layer, field});
    made.attribute = layer.attributes.at(0);
    return made;
}

double value(const Made& made, std::size_t n) { return double{made.attribute.values.at(n)}; }
double unsure_mps(const Made& made, std::size_t n) {
    return made.attribute.uncertainties.at(n).level() * made.attribute.uncertainty_full;
}

// The wind there: east 15 + 4 (more by 8 * 10 s / 1 h a point), north 4.
constexpr double kEast = 19, kNorth = 4;

TEST(DerivedAttribute, WindAlongAndAcrossTheTrack) {
    const Made head = derive(recipe_of("head_wind")), cross = derive(recipe_of("cross_wind"));
    EXPECT_EQ(head.attribute.of, scene::AttributeOf::point);
    EXPECT_EQ(head.attribute.unit, "m/s");
    EXPECT_TRUE(head.notes.empty());
    // East of a meridian's middle the way is not exactly a parallel; a thousandth of the wind.
    EXPECT_NEAR(value(head, 1), -kEast - 8 * 10 / 3600.0, 0.01) << "eastwards the wind is from behind";
    EXPECT_NEAR(value(cross, 1), kNorth, 0.01) << "and the southerly part from the right";
    EXPECT_NEAR(value(head, 3), -kNorth, 1e-3) << "northwards";
    EXPECT_NEAR(value(cross, 3), -kEast, 1e-3) << "from the left";
    EXPECT_NEAR(unsure_mps(head, 1), 2, 0.02);
    EXPECT_NEAR(unsure_mps(cross, 1), 1, 0.02);
    EXPECT_NEAR(unsure_mps(head, 3), 1, 0.02);
    EXPECT_NEAR(unsure_mps(cross, 3), 2, 0.02);
    const Made strength = derive(recipe_of("cross_wind_speed"));
    EXPECT_NEAR(value(strength, 1), kNorth, 0.01);
    EXPECT_NEAR(value(strength, 3), kEast, 1e-3) << "whatever the side";
    EXPECT_NEAR(unsure_mps(strength, 3), 2, 0.02);
    EXPECT_EQ(head.attribute.uncertainty_kind, scene::UncertaintyKind::standard_deviation);
}

TEST(DerivedAttribute, WindSpeedNeedsNoTrack) {
    LayerDraft still = flights();
    for (scene::ScenePoint& point : still.points)
        point.longitude_rad = still.points[0].longitude_rad, point.latitude_rad = still.points[0].latitude_rad;
    const Made speed = derive(recipe_of("wind_speed"), still);
    EXPECT_NEAR(value(speed, 0), std::hypot(kEast, kNorth), 1e-4);
    EXPECT_NEAR(unsure_mps(speed, 0), std::hypot(2 * kEast, 1 * kNorth) / std::hypot(kEast, kNorth), 0.02);
    const Made cross = derive(recipe_of("cross_wind"), still);
    EXPECT_TRUE(std::isnan(cross.attribute.values[1]));
    EXPECT_THAT(cross.notes,
                ElementsAre(HasSubstr("flights: 'derived:cross_wind' is missing at 6 of 6 points, which stand still")));
}

TEST(DerivedAttribute, OutsideOfTheWindThereIsNone) {
    LayerDraft layer = flights();
    layer.points[0].height_m = 3500;
    layer.points[1].time_ns = 2 * kHour_ns;
    layer.points[3].height_m = kMissing;
    layer.points[4].longitude_rad += 1;
    const Made speed = derive(recipe_of("wind_speed"), layer);
    for (std::size_t n = 0; n < 6; ++n) {
        const bool is_outside = n != 2 && n != 5;
        EXPECT_EQ(std::isnan(speed.attribute.values[n]), is_outside) << n;
        EXPECT_EQ(speed.attribute.uncertainties[n].is_known(), !is_outside) << n;
    }
    LayerRecipe held = recipe_of("wind_speed");
    held.wind_time_ns = 0;
    EXPECT_NEAR(value(derive(held, layer), 1), std::hypot(15, 4), 1e-4) << "a stated time goes before the points' own";
    EXPECT_EQ(derive(held, layer).attribute.derived_time_ns, 0) << "legends state it";
    EXPECT_FALSE(speed.attribute.derived_time_ns);
    EXPECT_EQ(speed.attribute.derived_from, held.wind_layer);
    EXPECT_EQ(derive(recipe_of("ground_speed"), layer).attribute.derived_from, "") << "its own";
}

TEST(DerivedAttribute, WhatIsNotSureOfTheWindIsNotSureOfItsParts) {
    LayerDraft field = wind();
    for (AttributeDraft& a : field.attributes) {
        a.uncertainty_kind = scene::UncertaintyKind::ordinal;
        a.states.assign(a.values.size(), ValueState::interpolated);
    }
    const Made cross = derive(recipe_of("cross_wind"), flights(), field);
    EXPECT_NEAR(cross.attribute.uncertainties[3].level(), 0.5, 0.01) << "no unit: the worse of both";
    EXPECT_EQ(cross.attribute.states[3], ValueState::interpolated);
    field.attributes[1].uncertainty_all = Uncertainty();
    EXPECT_FALSE(derive(recipe_of("cross_wind"), flights(), field).attribute.uncertainties[3].is_known());
}

/// Of 10 percent of 20 m/s from either side a small cross wind has more than 10 percent.
TEST(DerivedAttribute, PercentsOfASmallPartAreMany) {
    LayerDraft field = wind();
    for (AttributeDraft& a : field.attributes) {
        a.uncertainty_kind = scene::UncertaintyKind::percent;
        a.uncertainty_full = 100;
        a.uncertainty_all = Uncertainty::from_level(0.1);
    }
    LayerRecipe knots = recipe_of("head_wind");
    knots.attributes[0].factor = 2;
    const Made head = derive(knots, flights(), field);
    EXPECT_NEAR(unsure_mps(head, 1), 10, 0.5) << "eastwards the head wind is the east wind, and percents are not scaled";
    const Made cross = derive(recipe_of("cross_wind"), flights(), field);
    EXPECT_NEAR(unsure_mps(cross, 1), 10, 0.5) << "control";
    LayerDraft diagonal = flights();
    // North-east over the ground such that the wind's two parts nearly cancel across the track.
    const double track_rad = std::atan2(kEast, kNorth) - 0.01;
    for (std::size_t n = 0; n < 3; ++n) {
        const glm::dvec2 gone = 1000.0 * static_cast<double>(n) * glm::dvec2(std::sin(track_rad), std::cos(track_rad));
        diagonal.points[n] = test_support::scene_point(46.5 + gone.y / 111'200, 9.2 + gone.x / 76'700, 2000);
        diagonal.points[n].time_ns = flights().points[n].time_ns;
    }
    const Made across = derive(recipe_of("cross_wind"), diagonal, field);
    EXPECT_LT(std::abs(value(across, 1)), 1);
    EXPECT_GT(unsure_mps(across, 1), 50) << "percent";
}

TEST(DerivedAttribute, OfTwoKindsOfUncertaintyNobodyKnows) {
    LayerDraft field = wind();
    field.attributes[1].uncertainty_kind = scene::UncertaintyKind::percent;
    const Made mixed = derive(recipe_of("cross_wind"), flights(), field);
    EXPECT_EQ(mixed.attribute.uncertainty_kind, scene::UncertaintyKind::none);
    EXPECT_FALSE(mixed.attribute.uncertainties[1].is_known());
}

TEST(DerivedAttribute, SpeedsAreThoseOfThePoints) {
    LayerDraft layer = flights();
    for (std::size_t n = 3; n < 6; ++n) layer.points[n].height_m = 2000 + 30 * static_cast<float>(n - 3);
    const Made ground = derive(recipe_of("ground_speed"), layer), vertical = derive(recipe_of("vertical_speed"), layer);
    // A degree of latitude at 46.4: 111,169 m by the series of the meridian's arc; one of longitude at 46.5: 76,771 m.
    EXPECT_NEAR(value(ground, 4), 1111.69 / 10, 0.02);
    EXPECT_NEAR(value(ground, 1), 767.71 / 10, 0.02);
    EXPECT_NEAR(value(vertical, 4), 3, 1e-4);
    EXPECT_NEAR(value(vertical, 3), 3, 1e-4) << "of what there is at an end";
    EXPECT_NEAR(value(vertical, 1), 0, 1e-4);
    layer.points[5].time_ns = scene::kNoTime;
    const Made torn = derive(recipe_of("vertical_speed"), layer);
    EXPECT_TRUE(std::isnan(torn.attribute.values[4]));
    EXPECT_THAT(torn.notes, ElementsAre(HasSubstr("missing at 2 of 6 points, which have no time")));
}

TEST(DerivedAttribute, FactorsConvertValueAndUncertainty) {
    LayerRecipe knots = recipe_of("cross_wind");
    knots.attributes[0].factor = 2;
    knots.attributes[0].unit = "half";
    const Made made = derive(knots);
    EXPECT_NEAR(value(made, 3), -2 * kEast, 1e-3);
    EXPECT_NEAR(unsure_mps(made, 3), 4, 0.04);
    EXPECT_EQ(made.attribute.unit, "half");
}

TEST(DerivedAttribute, StandsAtItsPlaceAmongTheOthers) {
    LayerRecipe recipe = recipe_of("ground_speed");
    AttributeRecipe stated;
    stated.name = stated.variable = "mass";
    recipe.attributes.push_back(stated);
    ASSERT_EQ(without_derived(recipe).attributes.size(), 1u);
    EXPECT_EQ(without_derived(recipe).attributes[0].name, "mass");
    LayerDraft layer = flights();
    AttributeDraft mass;
    mass.name = "mass";
    mass.values.assign(6, 1);
    layer.attributes = {mass};
    static_cast<void>(add_derived(recipe, layer, {layer}));
    ASSERT_EQ(layer.attributes.size(), 2u);
    EXPECT_EQ(layer.attributes[0].name, "ground_speed");
    EXPECT_EQ(layer.attributes[1].name, "mass");
}

TEST(DerivedAttribute, WhatCannotBeDerivedIsSaid) {
    const auto expect = [](const LayerRecipe& recipe, const std::string& words, const LayerDraft& layer = flights(),
                           const LayerDraft& field = wind()) { expect_user_error([&] { derive(recipe, layer, field); }, words); };
    expect(recipe_of("fuel"), "flights: 'derived:fuel' is nothing that can be derived");
    LayerRecipe recipe = recipe_of("cross_wind");
    recipe.wind_layer = "";
    expect(recipe, "needs 'wind_layer'");
    recipe.wind_layer = "flights";
    expect(recipe, "'flights' is none of this scene file");
    expect(recipe_of("cross_wind"), "is for lines", test_support::small_points());
    LayerDraft field = wind();
    field.attributes.pop_back();
    expect(recipe_of("cross_wind"), "needs the attributes 'east' and 'north' (m/s) of 'wind'", flights(), field);
    LayerDraft ellipsoid = flights();
    ellipsoid.height_datum = scene::HeightDatum::ellipsoid;
    expect(recipe_of("cross_wind"), "needs heights over the same level", ellipsoid);
    recipe = recipe_of("cross_wind");
    recipe.attributes[0].uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    expect(recipe, "has the uncertainty of the wind");
    recipe = recipe_of("ground_speed");
    recipe.attributes[0].scale = scene::AttributeScale::ordinal;
    expect(recipe, "is quantitative");
}

}  // namespace
}  // namespace tedavis::host_sim::test_derived_attribute
