#include "render_core/scene/area_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::scene::test_area_limits {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

void bind(host_sim::LayerDraft& layer, const char* name, float value, const std::vector<std::string>& classes = {}) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = AttributeOf::feature;
    attribute.values = {value};
    attribute.classes = classes;
    if (!classes.empty()) attribute.scale = AttributeScale::nominal;
    layer.attributes.push_back(attribute);
}

struct Stated {
    float floor_m, floor_datum, ceiling_m, ceiling_datum;
};
test_support::LoadedScene area(const Stated& stated) {
    host_sim::LayerDraft layer;
    layer.name = "zone";
    layer.shape = LayerShape::areas;
    layer.role = LayerRole::airspace;
    layer.points = {{0.8, 0.17, 0, 0, kNoTime}, {0.8, 0.171, 0, 0, kNoTime}, {0.801, 0.17, 0, 0, kNoTime}};
    layer.starts = {0, 3};
    bind(layer, "floor", stated.floor_m);
    bind(layer, "floor_datum", stated.floor_datum, {"msl", "ground", "standard"});
    bind(layer, "ceiling", stated.ceiling_m);
    bind(layer, "ceiling_datum", stated.ceiling_datum, {"msl", "ground", "standard"});
    return test_support::LoadedScene(layer);
}
std::string text_of(const Stated& stated, base::DisplayUnits units = base::DisplayUnits::feet_and_knots) {
    const test_support::LoadedScene loaded = area(stated);
    return std::string(limits_text(loaded.layer(), 0, units).view());
}

TEST(AreaLimits, AreWrittenAsOnCharts) {
    EXPECT_EQ(text_of({0, 1, 792.48f, 0}), "GND-2600 MSL");
    EXPECT_EQ(text_of({457.2f, 1, 1981.2f, 2}), "1500 AGL-FL065");
    EXPECT_EQ(text_of({304.8f, 0, 457.2f, 1}), "1000 MSL-1500 AGL");
    EXPECT_EQ(text_of({0, 0, 9906, 2}), "0 MSL-FL325") << "sea level is not the ground";
}

/// Metres have their letter, since charts do without; a flight level stays one.
TEST(AreaLimits, AreWrittenInMetresWhereTheDisplayIsMetric) {
    EXPECT_EQ(text_of({0, 1, 792.48f, 0}, base::DisplayUnits::metric), "GND-792M MSL");
    EXPECT_EQ(text_of({457.2f, 1, 1981.2f, 2}, base::DisplayUnits::metric), "457M AGL-FL065");
    EXPECT_LE(text_of({-1e9f, 0, 1e9f, 1}, base::DisplayUnits::metric).size(), 31u);
}

TEST(AreaLimits, WhatIsNotStatedIsSaid) {
    EXPECT_EQ(text_of({0, 1, kNone, 0}), "GND-?");
    EXPECT_EQ(text_of({kNone, 0, 792.48f, 0}), "?-2600 MSL");
    EXPECT_EQ(text_of({kNone, 0, kNone, 0}), "") << "nothing to say";
    EXPECT_LE(text_of({-1e9f, 0, 1e9f, 1}).size(), 31u);
}

TEST(AreaLimits, HaveTheirDatumElseTheLayers) {
    const test_support::LoadedScene loaded = area({100, 1, 200, 2});
    const AreaLimits limits = area_limits(loaded.layer(), 0);
    EXPECT_EQ(limits.floor.datum, HeightDatum::ground);
    EXPECT_EQ(limits.ceiling.datum, HeightDatum::msl) << "flight levels are drawn at their heights";
    EXPECT_NEAR(limits.ceiling.m, 200, 1e-6);
    host_sim::LayerDraft house;
    house.name = "house";
    house.shape = LayerShape::areas;
    house.points = {{0.8, 0.17, 0, 0, kNoTime}, {0.8, 0.171, 0, 0, kNoTime}, {0.801, 0.17, 0, 0, kNoTime}};
    house.starts = {0, 3};
    house.height_datum = HeightDatum::ellipsoid;
    bind(house, "height", 12);
    const test_support::LoadedScene built(house);
    const AreaLimits of_house = area_limits(built.layer(), 0);
    EXPECT_TRUE(std::isnan(of_house.floor.m));
    EXPECT_EQ(of_house.floor.datum, HeightDatum::ellipsoid);
    EXPECT_EQ(of_house.ceiling.datum, HeightDatum::ground) << "a height is over the ground";
}

}  // namespace
}  // namespace tedavis::scene::test_area_limits
