#include "render_core/scene/obstacle_stand.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/draw/built_element.hpp"

namespace tedavis::scene::test_obstacle_stand {
namespace {

using test_support::LevelGround;
using test_support::LoadedScene;
using test_support::scene_point;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

host_sim::LayerDraft mast(float height_m, HeightDatum datum) {
    host_sim::LayerDraft layer;
    layer.name = "masts";
    layer.role = LayerRole::obstacle;
    layer.height_datum = datum;
    layer.points = {scene_point(46.8, 9.8, height_m)};
    return layer;
}

host_sim::AttributeDraft attribute(const char* name, float value) {
    host_sim::AttributeDraft made;
    made.name = name;
    made.of = AttributeOf::feature;
    made.values = {value};
    return made;
}

ObstacleStand stand(const host_sim::LayerDraft& draft, double height_m, LevelGround& ground) {
    const LoadedScene loaded(draft);
    return obstacle_stand(loaded.layer(), loaded.layer().points[0], height_m, kUnknownObstacle_m, ground);
}

/// Ground of 600 m above the ellipsoid, of which the geoid is 50 m above it.
TEST(ObstacleStand, TheTopIsThatOfItsDatumAndTheFootIsTheGround) {
    LevelGround ground;
    EXPECT_DOUBLE_EQ(stand(mast(120, HeightDatum::ground), 120, ground).top_m, 720);
    EXPECT_DOUBLE_EQ(stand(mast(700, HeightDatum::msl), 120, ground).top_m, 750);
    EXPECT_DOUBLE_EQ(stand(mast(700, HeightDatum::ellipsoid), 120, ground).top_m, 700);
    EXPECT_DOUBLE_EQ(stand(mast(700, HeightDatum::msl), 120, ground).foot_m, 600);
    EXPECT_DOUBLE_EQ(stand(mast(700, HeightDatum::msl), 120, ground).height_m(), 150);
    EXPECT_DOUBLE_EQ(stand(mast(500, HeightDatum::ellipsoid), 120, ground).foot_m, 380) << "its top is below the ground";
}

TEST(ObstacleStand, WithoutHeightItStandsOverTheGround) {
    LevelGround ground;
    const ObstacleStand stated = stand(mast(kNone, HeightDatum::msl), 45, ground);
    EXPECT_DOUBLE_EQ(stated.top_m, 645);
    EXPECT_TRUE(stated.is_stated);
    const ObstacleStand unknown = stand(mast(kNone, HeightDatum::msl), std::nan(""), ground);
    EXPECT_DOUBLE_EQ(unknown.top_m, 700);
    EXPECT_FALSE(unknown.is_stated);
    ground.is_known = false;
    EXPECT_FALSE(stand(mast(kNone, HeightDatum::msl), 45, ground).is_known());
    EXPECT_DOUBLE_EQ(stand(mast(700, HeightDatum::msl), 45, ground).foot_m, 705);
}

TEST(ObstacleStand, AccuraciesAreTheFeaturesElseTheLayers) {
    host_sim::LayerDraft layer = mast(120, HeightDatum::ground);
    layer.position_accuracy_m = 20;
    layer.height_accuracy_m = 5;
    const auto accuracy = [&] { return obstacle_accuracy(LoadedScene(layer).layer(), 0); };
    EXPECT_DOUBLE_EQ(accuracy().level_m, 20);
    EXPECT_DOUBLE_EQ(accuracy().height_m, 5);
    layer.attributes.push_back(attribute("position", 75));
    EXPECT_DOUBLE_EQ(accuracy().level_m, 75);
    host_sim::AttributeDraft height = attribute("height", 120);
    height.uncertainty_kind = UncertaintyKind::standard_deviation;
    height.uncertainty_full = 20;
    height.uncertainties = {Uncertainty::from_level(0.5)};
    layer.attributes.push_back(height);
    EXPECT_NEAR(accuracy().height_m, 20, 0.2) << "two standard deviations";
    layer.attributes[1].uncertainties = {Uncertainty()};
    EXPECT_NEAR(accuracy().height_m, 40, 0.2) << "unknown";
    layer.attributes[1].uncertainty_kind = UncertaintyKind::interval;
    layer.attributes[1].uncertainties = {Uncertainty::from_level(0.5)};
    EXPECT_NEAR(accuracy().height_m, 10, 0.1);
    layer.attributes[1].uncertainty_kind = UncertaintyKind::percent;
    layer.attributes[1].uncertainty_full = 0.2f;
    EXPECT_NEAR(accuracy().height_m, 12, 0.1) << "10 % of its height";
}

}  // namespace
}  // namespace tedavis::scene::test_obstacle_stand
