#include "host_sim/scene_builder/grid_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_grid_speed {
namespace {

using scene::Uncertainty;
using test_support::expect_user_error;

LayerDraft wind() {
    LayerDraft layer = test_support::small_grid();
    AttributeDraft east = layer.attributes[0];
    east.name = "east";
    east.uncertainties.clear();
    east.uncertainty_all = Uncertainty::from_level(0.5);
    AttributeDraft north = east;
    north.name = "north";
    for (std::size_t n = 0; n < east.values.size(); ++n) {
        east.values[n] = 3 * static_cast<float>(n);
        north.values[n] = -4 * static_cast<float>(n);
    }
    north.values[5] = std::numeric_limits<float>::quiet_NaN();
    north.uncertainties.assign(48, Uncertainty::from_level(0.25));
    north.uncertainties[2] = Uncertainty::from_level(0.75);
    north.uncertainties[3] = Uncertainty();
    layer.attributes = {east, north};
    return layer;
}

AttributeRecipe speed() {
    AttributeRecipe recipe;
    recipe.name = "speed";
    recipe.variable = "derived:wind_speed";
    return recipe;
}

AttributeDraft made(const AttributeRecipe& recipe = speed(), const LayerDraft& layer = wind()) {
    LayerRecipe of;
    of.name = "wind";
    return grid_speed(of, recipe, layer);
}

TEST(GridSpeed, IsTheVectorsLength) {
    const AttributeDraft draft = made();
    ASSERT_EQ(draft.values.size(), 48u);
    for (const std::size_t n : {0u, 1u, 47u}) EXPECT_FLOAT_EQ(draft.values[n], 5 * static_cast<float>(n));
    EXPECT_TRUE(std::isnan(draft.values[5])) << "one of the two is missing";
    EXPECT_EQ(draft.unit, "m/s");
    AttributeRecipe knots = speed();
    knots.factor = 2;
    knots.unit = "kt";
    EXPECT_FLOAT_EQ(made(knots).values[1], 10);
    EXPECT_EQ(made(knots).uncertainty_full, 8);
}

TEST(GridSpeed, IsAsUnsureAsTheLessSureComponent) {
    const AttributeDraft draft = made();
    EXPECT_EQ(draft.uncertainties[0], Uncertainty::from_level(0.5));
    EXPECT_EQ(draft.uncertainties[2], Uncertainty::from_level(0.75));
    EXPECT_FALSE(draft.uncertainties[3].is_known());
    EXPECT_EQ(draft.states[7], scene::ValueState::interpolated);
    EXPECT_EQ(draft.states[8], scene::ValueState::valid);
}

TEST(GridSpeed, IsNotSurerThanAComponentOnAScaleOfItsOwn) {
    LayerDraft layer = wind();
    for (AttributeDraft& attribute : layer.attributes) attribute.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    layer.attributes[1].uncertainty_full = 3 * layer.attributes[0].uncertainty_full;
    layer.attributes[1].uncertainty_growth_per_hour = 0.5;
    const AttributeDraft draft = made(speed(), layer);
    EXPECT_EQ(draft.uncertainty_full, layer.attributes[0].uncertainty_full);
    EXPECT_NEAR(draft.uncertainties[0].level(), 0.75, 1.0 / 100) << "0.25 of three times as much";
    EXPECT_EQ(draft.uncertainty_growth_per_hour, 0.5);
    layer.attributes[1].uncertainty_kind = scene::UncertaintyKind::percent;
    const AttributeDraft mixed = made(speed(), layer);
    EXPECT_EQ(mixed.uncertainty_kind, scene::UncertaintyKind::none);
    EXPECT_FALSE(mixed.uncertainties[0].is_known());
}

TEST(GridSpeed, PercentsAreNotScaledWithTheValues) {
    LayerDraft layer = wind();
    for (AttributeDraft& attribute : layer.attributes) attribute.uncertainty_kind = scene::UncertaintyKind::percent;
    AttributeRecipe half = speed();
    half.factor = 0.5;
    EXPECT_EQ(made(half, layer).uncertainty_full, layer.attributes[0].uncertainty_full);
}

TEST(GridSpeed, OtherQuantitiesAndGridsAreRefused) {
    AttributeRecipe own = speed();
    own.uncertainty.kind = scene::UncertaintyKind::percent;
    own.uncertainty.value = 3;
    expect_user_error([&] { static_cast<void>(made(own)); }, "has the uncertainty of the wind");

    AttributeRecipe cross = speed();
    cross.variable = "derived:cross_wind";
    expect_user_error([&] { static_cast<void>(made(cross)); }, "is for lines");
    expect_user_error([&] { static_cast<void>(made(speed(), test_support::small_grid())); }, "'east' and 'north'");
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_speed
