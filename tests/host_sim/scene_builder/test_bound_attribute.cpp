#include "host_sim/scene_builder/bound_attribute.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tedavis::host_sim::test_bound_attribute {
namespace {

TEST(BoundAttribute, SaysWhatItsRecipeSays) {
    AttributeRecipe recipe;
    recipe.name = "gust";
    recipe.unit = "m/s";
    recipe.uncertainty.full = 10;
    recipe.uncertainty.kind = scene::UncertaintyKind::interval;
    const AttributeDraft draft = bind_attribute(recipe);
    EXPECT_EQ(draft.name, "gust");
    EXPECT_EQ(draft.unit, "m/s");
    EXPECT_EQ(draft.uncertainty_full, 10);
    EXPECT_EQ(draft.uncertainty_kind, scene::UncertaintyKind::interval);
    EXPECT_TRUE(draft.values.empty());
}

TEST(BoundAttribute, ValuesAreConvertedAndWhatIsNoneIsMissing) {
    AttributeRecipe recipe;
    recipe.factor = 2;
    recipe.offset = 1;
    recipe.missing = {-9999};
    recipe.least = -50;
    recipe.most = 50;
    EXPECT_EQ(bound_value(recipe, 20), 41);
    for (const double none : {-9999.0, -51.0, 51.0, std::nan(""), HUGE_VAL}) EXPECT_TRUE(std::isnan(bound_value(recipe, none)));
    recipe.undetected = -8888;
    recipe.undetected_value = -32;
    EXPECT_EQ(bound_value(recipe, -8888), -63) << "a look that found nothing is a value";
}

TEST(BoundAttribute, ClassesAreWholeNumbers) {
    AttributeRecipe recipe;
    recipe.scale = scene::AttributeScale::nominal;
    recipe.classes = {"a", "b"};
    EXPECT_EQ(bound_value(recipe, 1), 1);
    for (const double none : {2.0, -1.0, 0.5}) EXPECT_TRUE(std::isnan(bound_value(recipe, none))) << none;
}

TEST(BoundAttribute, ClassesMayHaveNumbersOfTheSourcesOwn) {
    AttributeRecipe recipe;
    recipe.scale = scene::AttributeScale::nominal;
    recipe.classes = {"wood", "grass", "water"};
    recipe.class_values = {10, 30, 80};
    EXPECT_EQ(bound_value(recipe, 10), 0);
    EXPECT_EQ(bound_value(recipe, 80), 2);
    for (const double none : {0.0, 1.0, 20.0, 255.0, std::nan("")}) EXPECT_TRUE(std::isnan(bound_value(recipe, none))) << none;
    recipe.missing = {80};
    EXPECT_TRUE(std::isnan(bound_value(recipe, 80)));
}

TEST(BoundAttribute, UncertaintiesBecomeLevels) {
    AttributeRecipe recipe;
    EXPECT_FALSE(bound_uncertainty(recipe, 1).is_known()) << "nothing is said";
    recipe.uncertainty.kind = scene::UncertaintyKind::standard_deviation;
    recipe.uncertainty.full = 8;
    EXPECT_NEAR(bound_uncertainty(recipe, 2).level(), 0.25, 1.0 / 254);
    EXPECT_EQ(bound_uncertainty(recipe, 20).level(), 1);
    EXPECT_FALSE(bound_uncertainty(recipe, std::nan("")).is_known());
    EXPECT_FALSE(bound_uncertainty(recipe, -1).is_known());
    recipe.uncertainty.value = 4;
    EXPECT_NEAR(bound_uncertainty(recipe, 2).level(), 0.5, 1.0 / 254) << "one number for all";
    recipe.uncertainty = {};
    recipe.uncertainty.kind = scene::UncertaintyKind::percent;
    recipe.uncertainty.is_quality = true;
    EXPECT_NEAR(bound_uncertainty(recipe, 0.9).level(), 0.1, 1.0 / 254) << "how sure, instead of how unsure";
}

TEST(BoundAttribute, WhatIsStatedKeepsItsUnit) {
    AttributeRecipe recipe;
    recipe.factor = 2;
    recipe.missing = {-9999};
    recipe.most = 50;
    recipe.undetected = -8888;
    recipe.undetected_value = -32;
    EXPECT_EQ(stated_value(recipe, 20), 20);
    EXPECT_EQ(stated_value(recipe, -8888), -32);
    for (const double none : {-9999.0, 51.0, std::nan("")}) EXPECT_TRUE(std::isnan(stated_value(recipe, none))) << none;
}

TEST(BoundAttribute, UncertaintiesBeyondTheirRangeAreUnknown) {
    AttributeRecipe recipe;
    UncertaintyRecipe& unsure = recipe.uncertainty;
    const auto is_known = [&](double stated) { return bound_uncertainty(recipe, stated).is_known(); };
    for (const scene::UncertaintyKind kind : {scene::UncertaintyKind::standard_deviation, scene::UncertaintyKind::interval,
                                              scene::UncertaintyKind::percent, scene::UncertaintyKind::ordinal})
        for (const bool is_quality : {false, true}) {
            unsure.kind = kind;
            unsure.is_quality = is_quality;
            unsure.full = 50;
            for (const double none : {-0.01, -1e300, HUGE_VAL, -HUGE_VAL, std::nan("")}) EXPECT_FALSE(is_known(none)) << none;
            for (const double stated : {0.0, 20.0, 50.0}) EXPECT_TRUE(is_known(stated)) << stated;
            EXPECT_EQ(bound_uncertainty(recipe, is_quality ? 50 : 0).level(), 0) << "control: the surest is the surest";
            const bool is_bounded = is_quality || kind == scene::UncertaintyKind::ordinal;
            EXPECT_EQ(is_known(51), !is_bounded) << "a deviation has no most, and then counts as the least sure";
            EXPECT_EQ(is_known(101), !is_bounded && kind != scene::UncertaintyKind::percent);
        }
    unsure.full = 0.1;  // whose quotient is no round number
    EXPECT_EQ(bound_uncertainty(recipe, double{0.1f}).level(), 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_bound_attribute
