#include "render_core/draw/data/billboard_place.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_billboard_place {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

host_sim::LayerDraft square(scene::LayerRole role) {
    host_sim::LayerDraft layer;
    layer.name = "one";
    layer.role = role;
    layer.shape = scene::LayerShape::areas;
    layer.points = {BillboardRoom::point(3000, -500, 0), BillboardRoom::point(3000, 500, 0), BillboardRoom::point(4000, 500, 0),
                    BillboardRoom::point(4000, -500, 0)};
    layer.starts = {0, 4};
    return layer;
}

TEST(BillboardPlace, AreasHaveItInTheirMiddle) {
    ElementOfTest test(square(scene::LayerRole::building));
    scene::ScenePoint anchor{}, middle = BillboardRoom::point(3500, 0, 0);
    ASSERT_TRUE(anchor_of(test.input(), 0, anchor));
    EXPECT_NEAR(anchor.latitude_rad, middle.latitude_rad, 1e-9);
    EXPECT_NEAR(anchor.longitude_rad, middle.longitude_rad, 1e-9);
    const Placed place = place_of(test.input(), 0, anchor);
    ASSERT_TRUE(place.is_known);
    EXPECT_DOUBLE_EQ(place.height_m, test.ground.height);
}

TEST(BillboardPlace, AirspacesHaveItAtTheirCeiling) {
    host_sim::LayerDraft zone = square(scene::LayerRole::no_go);
    host_sim::AttributeDraft ceiling;
    ceiling.name = "ceiling";
    ceiling.of = scene::AttributeOf::feature;
    ceiling.values = {900};
    zone.attributes.push_back(ceiling);
    ElementOfTest test(zone);
    scene::ScenePoint anchor{};
    ASSERT_TRUE(anchor_of(test.input(), 0, anchor));
    EXPECT_TRUE(has_limits(test.input().layer));
    EXPECT_DOUBLE_EQ(place_of(test.input(), 0, anchor).height_m, 900 + test.ground.undulation);
    ElementOfTest house(square(scene::LayerRole::building));
    EXPECT_FALSE(has_limits(house.input().layer));
}

TEST(BillboardPlace, OnlyObstaclesHaveOneStem) {
    ElementOfTest house(square(scene::LayerRole::building));
    EXPECT_EQ(sign_stems(house.input().layer), kSignStems);
    host_sim::LayerDraft masts;
    masts.name = "masts";
    masts.role = scene::LayerRole::obstacle;
    masts.points = {BillboardRoom::point(3000, 0, 0)};
    ElementOfTest mast(masts);
    EXPECT_EQ(sign_stems(mast.input().layer), 1);
}

}  // namespace
}  // namespace tedavis::draw::test_billboard_place
