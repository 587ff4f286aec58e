#include "host_sim/scene_builder/feature_layer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_feature_layer {
namespace {

using scene::AttributeOf;
using scene::LayerRole;
using scene::LayerShape;
using test_support::expect_user_error;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

LayerRecipe layer_of(LayerRole role) {
    LayerRecipe recipe;
    recipe.name = "things";
    recipe.title = "THINGS";
    recipe.source = "things.csv";
    recipe.role = role;
    return recipe;
}

AttributeRecipe& bind(LayerRecipe& recipe, const std::string& name) {
    recipe.attributes.emplace_back();
    recipe.attributes.back().name = recipe.attributes.back().variable = name;
    return recipe.attributes.back();
}

SourceFeature point(double latitude_deg, double longitude_deg, const std::map<std::string, std::string>& fields = {}) {
    SourceFeature feature;
    feature.points = {{latitude_deg, longitude_deg, {}, {}}};
    feature.fields = fields;
    return feature;
}

SourceFeature run(LayerShape shape, int count, double west_deg) {
    SourceFeature feature;
    feature.shape = shape;
    for (int n = 0; n < count; ++n) feature.points.push_back({46 + 0.01 * (n % 3), west_deg + 0.01 * n, 1000.0 + n, 1000 * n});
    return feature;
}

SourceFeatures masts() {
    SourceFeatures source;
    source.features = {point(46.8, 9.8, {{"name", "A"}, {"height", "40"}, {"kind", "mast"}, {"sigma", "2"}}),
                       point(46.9, 9.9, {{"height", "tall"}, {"kind", "Turbine"}}), point(46.7, 9.7, {{"name", "C"}})};
    return source;
}

TEST(FeatureLayer, PointsWithNamesHeightsAndAttributes) {
    LayerRecipe recipe = layer_of(LayerRole::obstacle);
    recipe.height_variable = "height";
    recipe.height_factor = 0.3048;
    recipe.height_datum = scene::HeightDatum::ground;
    AttributeRecipe& kind = bind(recipe, "kind");
    kind.scale = scene::AttributeScale::nominal;
    kind.classes = {"mast", "turbine"};
    AttributeRecipe& height = bind(recipe, "height");
    height.uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    height.uncertainty.variable = "sigma";
    height.uncertainty.full = 4;
    const FeatureLayer made = make_feature_layer(recipe, masts());
    const LayerDraft& draft = made.draft;
    EXPECT_EQ(draft.shape, LayerShape::points);
    EXPECT_EQ(draft.height_datum, scene::HeightDatum::ground);
    ASSERT_EQ(draft.points.size(), 3u);
    EXPECT_NEAR(base::degrees(draft.points[1].latitude_rad), 46.9, 1e-12);
    EXPECT_FLOAT_EQ(draft.points[0].height_m, 40 * 0.3048F);
    EXPECT_TRUE(std::isnan(draft.points[1].height_m)) << "on the ground";
    EXPECT_EQ(draft.points[0].time_ns, scene::kNoTime);
    EXPECT_THAT(draft.names, ElementsAre("A", "", "C"));
    EXPECT_EQ(draft.attributes[0].of, AttributeOf::feature);
    EXPECT_EQ(draft.attributes[0].values[0], 0);
    EXPECT_EQ(draft.attributes[0].values[1], 1);
    EXPECT_TRUE(std::isnan(draft.attributes[0].values[2]));
    EXPECT_TRUE(draft.attributes[0].uncertainties.empty());
    EXPECT_EQ(draft.attributes[1].values[0], 40);
    EXPECT_EQ(draft.attributes[1].uncertainties[0].level(), 0.5);
    EXPECT_FALSE(draft.attributes[1].uncertainties[2].is_known());
    EXPECT_THAT(made.notes,
                ElementsAre(HasSubstr("things: 1 values of 'height' are no numbers and count as missing (the first: 'tall')")))
        << "once, though heights and an attribute are read from it";
    EXPECT_EQ(draft.data_time_ns, scene::kNoTime);
}

TEST(FeatureLayer, HeightsOfTheFormatStayWithoutAVariable) {
    SourceFeatures source;
    source.height_datum = scene::HeightDatum::ellipsoid;
    source.features = {point(46, 9), run(LayerShape::points, 1, 9)};
    LayerRecipe recipe = layer_of(LayerRole::sample);
    const LayerDraft draft = make_feature_layer(recipe, source).draft;
    EXPECT_EQ(draft.height_datum, scene::HeightDatum::ellipsoid);
    EXPECT_TRUE(std::isnan(draft.points[0].height_m));
    EXPECT_EQ(draft.points[1].height_m, 1000);
    source.features[0].points[0].height_m = 2e5;
    expect_user_error([&] { (void)make_feature_layer(recipe, source); }, "is more than can be shown");
}

TEST(FeatureLayer, TheRoleChoosesTheShapeAndTheRestIsSaid) {
    SourceFeatures source;
    source.features = {point(46, 9), run(LayerShape::lines, 4, 9), run(LayerShape::areas, 5, 9), run(LayerShape::lines, 2, 9),
                       run(LayerShape::areas, 2, 9)};
    const FeatureLayer lines = make_feature_layer(layer_of(LayerRole::road), source);
    EXPECT_EQ(lines.draft.shape, LayerShape::lines);
    EXPECT_THAT(lines.draft.starts, ElementsAre(0, 4, 6));
    EXPECT_THAT(lines.notes, ElementsAre("things: 1 points are left out: the role shows lines",
                                         "things: 2 areas are left out: the role shows lines"));
    const FeatureLayer areas = make_feature_layer(layer_of(LayerRole::no_go), source);
    EXPECT_THAT(areas.draft.starts, ElementsAre(0, 5));
    EXPECT_THAT(areas.notes, ::testing::Contains("things: 1 areas have fewer than three points and are left out"));
    EXPECT_EQ(make_feature_layer(layer_of(LayerRole::place), source).draft.points.size(), 1u);
    source.features = {run(LayerShape::areas, 5, 9)};
    expect_user_error([&] { (void)make_feature_layer(layer_of(LayerRole::road), source); },
                      "things: its source has areas alone, and the role shows lines; choose another role or source");
}

TEST(FeatureLayer, TrajectoriesHaveValuesByPointAndTheirFaultsAreCounted) {
    SourceFeatures source;
    source.features = {run(LayerShape::lines, 5, 9), run(LayerShape::lines, 2, 10)};
    SourceFeature& first = source.features[0];
    first.points[2] = first.points[1];
    first.points[4].time_ns = 500;
    first.point_values["speed"] = {10, 11, std::nan(""), 13, 14};
    for (SourceFeature& feature : source.features) feature.fields["weight"] = "300";
    LayerRecipe recipe = layer_of(LayerRole::trajectory);
    (void)bind(recipe, "speed");
    (void)bind(recipe, "weight");
    const FeatureLayer made = make_feature_layer(recipe, source);
    ASSERT_EQ(made.draft.points.size(), 7u) << "nothing is dropped";
    const AttributeDraft &speed = made.draft.attributes[0], &weight = made.draft.attributes[1];
    EXPECT_EQ(speed.of, AttributeOf::point);
    ASSERT_EQ(speed.values.size(), 7u);
    EXPECT_EQ(speed.values[3], 13);
    EXPECT_TRUE(std::isnan(speed.values[2]));
    EXPECT_TRUE(std::isnan(speed.values[6])) << "the second one states none";
    EXPECT_EQ(weight.of, AttributeOf::feature);
    EXPECT_THAT(weight.values, ElementsAre(300, 300));
    EXPECT_THAT(made.notes,
                ElementsAre("things: 1 points repeat the one before", "things: 1 points are earlier than the one before"));
    EXPECT_EQ(made.draft.data_time_ns, 3000) << "the latest";
    source.data_time_ns = 4000;
    EXPECT_EQ(make_feature_layer(recipe, source).draft.data_time_ns, 4000) << "the file's, where it is later";
    recipe.data_time_ns = 77;
    EXPECT_EQ(make_feature_layer(recipe, source).draft.data_time_ns, 77);
}

TEST(FeatureLayer, UncertaintyOfPointsMakesAnAttributeOfPoints) {
    SourceFeatures source;
    source.features = {run(LayerShape::lines, 3, 9)};
    source.features[0].fields["weight"] = "300";
    source.features[0].point_values["sigma"] = {1, 2, std::nan("")};
    LayerRecipe recipe = layer_of(LayerRole::trajectory);
    AttributeRecipe& weight = bind(recipe, "weight");
    weight.uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    weight.uncertainty.variable = "sigma";
    weight.uncertainty.full = 2;
    const LayerDraft draft = make_feature_layer(recipe, source).draft;
    EXPECT_THAT(draft.attributes[0].values, ElementsAre(300, 300, 300));
    EXPECT_EQ(draft.attributes[0].uncertainties[0].level(), 0.5);
    EXPECT_FALSE(draft.attributes[0].uncertainties[2].is_known());
    recipe.attributes[0].uncertainty.variable.clear();
    recipe.attributes[0].uncertainty.value = 1;
    const LayerDraft alike = make_feature_layer(recipe, source).draft;
    EXPECT_TRUE(alike.attributes[0].uncertainties.empty());
    EXPECT_EQ(alike.attributes[0].uncertainty_all.level(), 0.5);
}

TEST(FeatureLayer, FiltersByRegionValueAndTime) {
    LayerRecipe recipe = layer_of(LayerRole::obstacle);
    recipe.prepare.region = RegionRecipe{9.65, 46.6, 9.85, 46.85};
    EXPECT_THAT(make_feature_layer(recipe, masts()).draft.names, ElementsAre("A", "C"));
    recipe.prepare.region.reset();
    (void)bind(recipe, "height");
    recipe.prepare.keep_attribute = "height";
    recipe.prepare.keep_least = 10;
    recipe.prepare.keep_most = 40;
    EXPECT_THAT(make_feature_layer(recipe, masts()).draft.names, ElementsAre("A")) << "missing values are not kept";
    recipe.prepare.keep_attribute = "weight";
    expect_user_error([&] { (void)make_feature_layer(recipe, masts()); }, "keep_attribute 'weight' is none of the attributes");
    recipe.prepare.keep_attribute = "height";
    recipe.prepare.keep_most = 39;
    const FeatureLayer none = make_feature_layer(recipe, masts());
    EXPECT_TRUE(none.draft.points.empty());
    EXPECT_THAT(none.notes, ::testing::Contains("things: nothing is left to show"));

    LayerRecipe flights = layer_of(LayerRole::trajectory);
    flights.from_ns = 1000;
    flights.until_ns = 2000;
    SourceFeatures source;
    source.features = {run(LayerShape::lines, 5, 9), run(LayerShape::lines, 1, 10)};
    EXPECT_THAT(make_feature_layer(flights, source).draft.starts, ElementsAre(0, 2));
}

TEST(FeatureLayer, TimesOfTables) {
    SourceFeatures source;
    source.features = {point(46, 9, {{"seen", "2020-04-12T09:47:00Z"}}), point(46, 9, {{"seen", "early"}}), point(46, 9)};
    LayerRecipe recipe = layer_of(LayerRole::sample);
    recipe.time_variable = "seen";
    const FeatureLayer made = make_feature_layer(recipe, source);
    EXPECT_EQ(made.draft.points[0].time_ns, 1'586'684'820'000'000'000);
    EXPECT_EQ(made.draft.points[1].time_ns, scene::kNoTime);
    EXPECT_EQ(made.draft.data_time_ns, 1'586'684'820'000'000'000);
    EXPECT_THAT(made.notes, ElementsAre(HasSubstr("1 values of 'seen' are no times such as 2026-06-01T14:00:00Z")));
}

TEST(FeatureLayer, WhatIsNotStatedIsRefusedWithWhatIs) {
    LayerRecipe recipe = layer_of(LayerRole::obstacle);
    (void)bind(recipe, "hight");
    expect_user_error([&] { (void)make_feature_layer(recipe, masts()); },
                      "things: 'hight' is not in things.csv, which states height, kind, name, sigma");
    for (std::string LayerRecipe::*const variable :
         {&LayerRecipe::height_variable, &LayerRecipe::name_variable, &LayerRecipe::time_variable}) {
        LayerRecipe misspelt = layer_of(LayerRole::obstacle);
        misspelt.*variable = "nosuch";
        expect_user_error([&] { (void)make_feature_layer(misspelt, masts()); }, "'nosuch' is not in things.csv");
    }
    SourceFeatures columns = masts();
    columns.columns = {"hight"};
    EXPECT_TRUE(std::isnan(make_feature_layer(recipe, columns).draft.attributes[0].values[0])) << "a column may be empty";
}

TEST(FeatureLayer, WordsForGridsAreRefused) {
    const auto refused = [](const LayerRecipe& recipe, const std::string& word) {
        expect_user_error([&] { (void)make_feature_layer(recipe, masts()); }, "things: '" + word + "' is for grids");
    };
    LayerRecipe recipe = layer_of(LayerRole::obstacle);
    recipe.prepare.smooth_cells = 1;
    refused(recipe, "smooth_cells");
    recipe = layer_of(LayerRole::obstacle);
    recipe.members = "bands";
    refused(recipe, "members");
    recipe = layer_of(LayerRole::obstacle);
    bind(recipe, "height").uncertainty.is_spread = true;
    refused(recipe, "is_spread");
}

TEST(FeatureLayer, EmptySetsAreEmptyLayers) {
    for (const LayerRole role : {LayerRole::obstacle, LayerRole::road, LayerRole::no_go}) {
        LayerRecipe recipe = layer_of(role);
        (void)bind(recipe, "height");
        const FeatureLayer made = make_feature_layer(recipe, {});
        EXPECT_EQ(made.draft.feature_count(), 0u);
        EXPECT_EQ(made.draft.attributes.size(), 1u);
        EXPECT_THAT(made.notes, ElementsAre("things: nothing is left to show"));
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_feature_layer
