#include "render_core/draw/data/placement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_placement {
namespace {

using test_support::ElementOfTest;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double height_of(ElementOfTest& test, double height_m) { return placed(test.input(), 0.8, 0.2, height_m).height_m; }

TEST(Placement, HeightsAreOverWhatTheLayerSays) {
    host_sim::LayerDraft layer = test_support::small_points();
    const auto with = [&](scene::HeightDatum datum) {
        layer.height_datum = datum;
        return ElementOfTest(layer);
    };
    ElementOfTest ground = with(scene::HeightDatum::ground), msl = with(scene::HeightDatum::msl);
    ElementOfTest ellipsoid = with(scene::HeightDatum::ellipsoid);
    EXPECT_EQ(height_of(ground, 40), 640);
    EXPECT_EQ(height_of(msl, 40), 90);
    EXPECT_EQ(height_of(ellipsoid, 40), 40);
    for (ElementOfTest* test : {&ground, &msl, &ellipsoid}) {
        EXPECT_EQ(height_of(*test, kNone), 600) << "on the ground";
        EXPECT_EQ(height_in_datum_m(test->input(), 0.8, 0.2, height_of(*test, 40)), 40) << "there and back";
    }
}

TEST(Placement, WithoutGroundNothingStandsOnIt) {
    ElementOfTest test(test_support::small_points());
    test.ground.is_known = false;
    EXPECT_FALSE(placed(test.input(), 0.8, 0.2, 40).is_known);
    host_sim::LayerDraft high = test_support::small_points();
    high.height_datum = scene::HeightDatum::msl;
    ElementOfTest other(high);
    other.ground.is_known = false;
    const Placed at = placed(other.input(), 0.8, 0.2, 40);
    EXPECT_TRUE(at.is_known);
    EXPECT_LT(glm::distance(at.place, earth::to_ecef({0.8, 0.2, {90}})), 1e-6);
}

TEST(Placement, OverTheGroundIsOverTheGroundWhateverTheLayerSays) {
    host_sim::LayerDraft layer = test_support::small_points();
    layer.height_datum = scene::HeightDatum::msl;
    ElementOfTest test(layer);
    EXPECT_EQ(placed_over_ground(test.input(), 0.8, 0.2, 30).height_m, 630);
    test.ground.is_known = false;
    EXPECT_FALSE(placed_over_ground(test.input(), 0.8, 0.2, 30).is_known);
}

TEST(Placement, AxesAreEastNorthAndUp) {
    const LocalAxes axes = local_axes(0.8, 0.2);
    EXPECT_LT(glm::distance(glm::cross(axes.east, axes.north), axes.up), 1e-12);
    const glm::dvec3 step = earth::to_ecef({0.8, 0.2 + 1e-6, {0}}) - earth::to_ecef({0.8, 0.2, {0}});
    EXPECT_GT(glm::dot(glm::normalize(step), axes.east), 0.999999);
}

TEST(Placement, ColorsComeFromTheValueOrSayThatThereIsNone) {
    ElementOfTest test(test_support::small_grid());
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 0), test.element.color) << "no encoding";
    test.element.by_color.attribute = "temperature";
    test.element.by_color.scale.palette = test_support::grey_palette();
    const design::Color missing{255, 0, 255, 255};
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 0), (design::Color{255, 255, 255}));
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 5), missing) << "NaN";
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 4711), missing) << "beyond the values";
    test.element.by_color.attribute = "smoke";
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 0), missing) << "no such attribute";
}

TEST(Placement, KindsHaveTheColorsOfTheirNames) {
    ElementOfTest test(test_support::small_points());  // mast, turbine, mast
    test.element.by_color.attribute = "kind";
    design::Palette& palette = test.element.by_color.scale.palette;
    palette = test_support::kinds_palette();
    const design::Color missing{255, 0, 255, 255};
    for (std::size_t n = 0; n < 3; ++n)
        EXPECT_EQ(encoded_color(test.input(), test.element.by_color, n), missing) << "no such names";
    palette.class_names[0] = "turbine";
    palette.class_names[1] = "mast";
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 0), palette.stops[1].color)
        << "in another order than the scene's";
    EXPECT_EQ(encoded_color(test.input(), test.element.by_color, 1), palette.stops[0].color);
    ElementOfTest numbers(test_support::small_grid());
    numbers.element.by_color.attribute = "temperature";
    numbers.element.by_color.scale.palette = palette;
    EXPECT_EQ(encoded_color(numbers.input(), numbers.element.by_color, 0), missing) << "numbers are no kinds";
}

TEST(Placement, WhatNobodyStatesIsNeverCertain) {
    ElementOfTest test(test_support::small_grid());
    test.element.by_color.attribute = "temperature";
    EXPECT_EQ(encoded_uncertainty(test.input(), 3), scene::Uncertainty::from_level(3 / 60.0));
    EXPECT_FALSE(encoded_uncertainty(test.input(), 5).is_known()) << "missing";
    EXPECT_FALSE(encoded_uncertainty(test.input(), 4711).is_known());
    test.element.by_color.attribute = "smoke";
    EXPECT_FALSE(encoded_uncertainty(test.input(), 0).is_known());
    test.element.by_color.attribute = "";
    EXPECT_EQ(encoded_uncertainty(test.input(), 3), scene::Uncertainty::from_level(3 / 60.0)) << "the first that is stated";
    ElementOfTest plain(test_support::small_areas());
    EXPECT_EQ(encoded_uncertainty(plain.input(), 0), scene::Uncertainty::from_code(0)) << "no value is shown, none is unsure";
}

TEST(Placement, AxesOfAPlaceInSpaceAreThoseOfItsCoordinates) {
    const LocalAxes by_angles = local_axes(0.8, 0.2), by_place = local_axes(earth::to_ecef({0.8, 0.2, {9000}}));
    EXPECT_LT(glm::distance(by_angles.east, by_place.east), 1e-9);
    EXPECT_LT(glm::distance(by_angles.north, by_place.north), 1e-5);
    EXPECT_LT(glm::distance(by_angles.up, by_place.up), 1e-5);
    const LocalAxes at_pole = local_axes(earth::to_ecef({base::radians(90), 0, {0}}));
    EXPECT_NEAR(glm::length(at_pole.east), 1, 1e-12);
    EXPECT_NEAR(glm::dot(at_pole.east, at_pole.up), 0, 1e-9);
}

TEST(Placement, AccuraciesAreThePointsOwnElseTheLayers) {
    constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
    host_sim::LayerDraft draft = test_support::small_points();
    draft.position_accuracy_m = 50;
    draft.height_accuracy_m = 0;
    host_sim::AttributeDraft own;
    own.name = "position_accuracy";
    own.values = {7, kNaN, 0};
    draft.attributes = {own};
    ElementOfTest test(draft);
    const scene::Layer& layer = test.input().layer;
    EXPECT_EQ(place_accuracy(layer, {0, 0}).level_m, 7);
    EXPECT_EQ(place_accuracy(layer, {0, 1}).level_m, 50);
    EXPECT_EQ(place_accuracy(layer, {0, 2}).level_m, 50) << "0 is no accuracy";
    EXPECT_EQ(place_accuracy(layer, {0, 0}).height_m, 0) << "nobody knows";
    EXPECT_TRUE(states_accuracy(layer));
    draft.position_accuracy_m = 0;
    EXPECT_TRUE(states_accuracy(ElementOfTest(draft).input().layer));
    draft.attributes.clear();
    EXPECT_FALSE(states_accuracy(ElementOfTest(draft).input().layer));
}

}  // namespace
}  // namespace tedavis::draw::test_placement
