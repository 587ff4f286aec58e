#include "host_sim/scene_builder/feature_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_feature_value {
namespace {

SourceFeature mast() {
    SourceFeature feature;
    feature.points.resize(3);
    feature.fields = {{"height", "30"},   {"kind", "Turbine"},  {"number", "1"},
                      {"odd", "about 3"}, {"trust", "guessed"}, {"sigma", "2"}};
    feature.point_values["speed"] = {10, std::nan(""), 30};
    return feature;
}

AttributeRecipe recipe(const std::string& variable) {
    AttributeRecipe recipe;
    recipe.name = recipe.variable = variable;
    return recipe;
}

AttributeRecipe kinds(const std::string& variable) {
    AttributeRecipe classed = recipe(variable);
    classed.scale = scene::AttributeScale::nominal;
    classed.classes = {"mast", "turbine"};
    return classed;
}

TEST(FeatureValue, NumbersAreConverted) {
    Misfits misfits;
    AttributeRecipe height = recipe("height");
    height.factor = 0.5;
    EXPECT_EQ(feature_value(height, mast(), misfits), 15);
    EXPECT_TRUE(std::isnan(feature_value(recipe("none"), mast(), misfits))) << "not stated";
    EXPECT_EQ(misfits.count, 0u);
    EXPECT_TRUE(std::isnan(feature_value(recipe("odd"), mast(), misfits)));
    EXPECT_TRUE(std::isnan(feature_value(recipe("kind"), mast(), misfits)));
    EXPECT_EQ(misfits.count, 2u);
    EXPECT_EQ(misfits.first, "about 3");
}

TEST(FeatureValue, ClassesAreNamesOrNumbers) {
    Misfits misfits;
    AttributeRecipe kind = kinds("kind");
    kind.factor = 7;
    EXPECT_EQ(feature_value(kind, mast(), misfits), 1) << "a name needs no conversion";
    EXPECT_EQ(feature_value(kinds("number"), mast(), misfits), 1);
    EXPECT_TRUE(std::isnan(feature_value(kinds("height"), mast(), misfits))) << "there is no class 30";
    EXPECT_TRUE(std::isnan(feature_value(kinds("odd"), mast(), misfits)));
    EXPECT_EQ(misfits.first, "about 3");
}

TEST(FeatureValue, PointsHaveTheirOwnOrTheFeatures) {
    Misfits misfits;
    EXPECT_EQ(point_value(recipe("speed"), mast(), 2, misfits), 30);
    EXPECT_TRUE(std::isnan(point_value(recipe("speed"), mast(), 1, misfits)));
    EXPECT_EQ(point_value(recipe("height"), mast(), 1, misfits), 30);
    EXPECT_TRUE(std::isnan(feature_value(recipe("speed"), mast(), misfits))) << "of three points none is the feature's";
    SourceFeature single = mast();
    single.points.resize(1);
    single.point_values["speed"] = {44};
    EXPECT_EQ(feature_value(recipe("speed"), single, misfits), 44);
    EXPECT_EQ(misfits.count, 0u);
}

TEST(FeatureValue, UncertaintyIsANumberAVariableOrAClass) {
    Misfits misfits;
    AttributeRecipe height = recipe("height");
    EXPECT_FALSE(feature_uncertainty(height, mast(), misfits).is_known());
    height.uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    height.uncertainty.full = 8;
    height.uncertainty.value = 4;
    EXPECT_EQ(feature_uncertainty(height, mast(), misfits).level(), 0.5);
    height.uncertainty.value.reset();
    height.uncertainty.variable = "sigma";
    EXPECT_NEAR(feature_uncertainty(height, mast(), misfits).level(), 0.25, 1.0 / 254);
    height.uncertainty.variable = "speed";
    EXPECT_EQ(point_uncertainty(height, mast(), 0, misfits).level(), 1);
    EXPECT_FALSE(point_uncertainty(height, mast(), 1, misfits).is_known()) << "missing is unknown, never certain";
    height.uncertainty.kind = scene::UncertaintyKind::ordinal;
    height.uncertainty.variable = "trust";
    height.uncertainty.classes = {"sure", "likely", "guessed", "unlikely", "impossible"};
    EXPECT_EQ(feature_uncertainty(height, mast(), misfits).level(), 0.5);
    EXPECT_EQ(point_uncertainty(height, mast(), 2, misfits).level(), 0.5);
    AttributeRecipe unstated = height;
    unstated.uncertainty.kind = scene::UncertaintyKind::none;
    EXPECT_FALSE(feature_uncertainty(unstated, mast(), misfits).is_known()) << "words without a kind say nothing";
    EXPECT_EQ(misfits.count, 0u);
    for (const char* const beyond : {"5", "-1"}) {
        SourceFeature other = mast();
        other.fields["trust"] = beyond;
        EXPECT_FALSE(feature_uncertainty(height, other, misfits).is_known()) << "no class " << beyond;
    }
    height.uncertainty.variable = "odd";
    EXPECT_FALSE(feature_uncertainty(height, mast(), misfits).is_known());
    EXPECT_EQ(misfits.count, 1u);
}

TEST(FeatureValue, VariablesAreFieldsColumnsOrValuesOfPoints) {
    SourceFeatures source;
    source.features = {mast()};
    source.columns = {"empty"};
    for (const char* const known : {"height", "empty", "speed"}) EXPECT_TRUE(is_stated(source, known)) << known;
    EXPECT_FALSE(is_stated(source, "hight"));
    EXPECT_TRUE(is_of_points(source, "speed"));
    EXPECT_FALSE(is_of_points(source, "height"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_feature_value
