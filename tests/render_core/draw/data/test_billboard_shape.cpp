#include "render_core/draw/data/billboard_shape.hpp"

#include <gtest/gtest.h>

#include "render_core/draw/font_atlas.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_billboard_shape {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

host_sim::LayerDraft village() {
    host_sim::LayerDraft layer;
    layer.name = "places";
    layer.role = scene::LayerRole::place;
    layer.points = {BillboardRoom::point(4000, 0, 1000), BillboardRoom::point(-4000, 0, 1000)};
    layer.names = {"Davos", "Klosters"};
    return layer;
}

TEST(BillboardShape, StandsOverItsPlaceWithRoomForItsName) {
    ElementOfTest test(village());
    const BillboardRoom room;
    const SignView& view = room.sheet.eye();
    BillboardShape shape;
    ASSERT_TRUE(billboard_shape(test.input(), 0, view, true, shape));
    EXPECT_EQ(shape.text.size(), 1u);
    EXPECT_FLOAT_EQ(shape.box.name_width_px, text_width_px("Davos", shape.line_px()));
    EXPECT_FLOAT_EQ(shape.box.middle.x, shape.spot.at.x);
    EXPECT_FLOAT_EQ(shape.box.middle.y + shape.box.half_px + kSignStem * view.text_px, shape.spot.at.y);
    constexpr float kRounding_px = 1e-3f;
    const Rect bare = shape.box.with(SignSide::none), right = shape.box.with(SignSide::right),
               left = shape.box.with(SignSide::left), above = shape.box.with(SignSide::above);
    EXPECT_TRUE(bare.contains(shape.spot.at));
    for (const Rect& box : {right, left, above}) {
        EXPECT_TRUE(box.contains(bare));
        EXPECT_GT(box.width * box.height, bare.width * bare.height);
    }
    EXPECT_GT(right.right() - bare.right(), shape.box.name_width_px - kRounding_px);
    EXPECT_GT(bare.x - left.x, shape.box.name_width_px - kRounding_px);
    EXPECT_GT(bare.y - above.y, shape.box.name_height_px - kRounding_px);
    const Rect raised = shape.box.raised(2, view.text_px).with(SignSide::none);
    EXPECT_FLOAT_EQ(bare.y - raised.y, 2.5f * view.text_px);
    EXPECT_LT(raised.bottom(), shape.spot.at.y) << "a long stem takes no room";
    EXPECT_FLOAT_EQ(shape.on_the_spot().middle.y, shape.spot.at.y);
    EXPECT_FALSE(billboard_shape(test.input(), 1, view, true, shape)) << "behind";
    ASSERT_TRUE(billboard_shape(test.input(), 0, view, false, shape));
    EXPECT_TRUE(shape.text.empty());
    EXPECT_EQ(shape.box.name_width_px, 0);
}

TEST(SignText, GivesUpItsFirstLine) {
    SignText text;
    text.add(BillboardText(""));
    EXPECT_TRUE(text.empty());
    text.add(BillboardText("Name"));
    text.add(BillboardText("GND-2600 MSL"));
    EXPECT_FLOAT_EQ(text.width_px(16), text_width_px("GND-2600 MSL", 16));
    text.drop_first();
    ASSERT_EQ(text.size(), 1u);
    EXPECT_EQ(text.line(0), "GND-2600 MSL");
}

}  // namespace
}  // namespace tedavis::draw::test_billboard_shape
