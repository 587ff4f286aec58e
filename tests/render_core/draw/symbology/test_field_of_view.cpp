#include <gtest/gtest.h>

#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_field_of_view {
namespace {

using test_support::BatchStore;
using test_support::scene_input;
using test_support::scene_state;
using test_support::text_of;

std::string text_at(double field_of_view_deg, std::uint32_t width, std::uint32_t height) {
    SymbologyInput input = scene_input(scene_state(0, 0, 0), width, height);
    input.view = make_view_frame(width, height, base::radians(field_of_view_deg), 0, 0, 0);
    const Layout layout = make_layout(width, height, 96);
    BatchStore store;
    build_field_of_view(Painter(store.batch, layout), input);
    const Rect room = field_of_view_box(layout).shrunk(-2.5f);
    for (const QuadVertex& vertex : store.batch.vertices()) EXPECT_TRUE(room.contains(Point{vertex.x, vertex.y}));
    return text_of(store.batch);
}

TEST(FieldOfView, IsStatedInDegreesAcrossTheWidth) {
    for (const auto& [width, height] : {std::pair{640u, 480u}, {1280u, 720u}, {480u, 800u}}) {
        EXPECT_EQ(text_at(60, width, height).substr(0, 5), "FOV60") << width;
        EXPECT_EQ(text_at(45, width, height).substr(0, 5), "FOV45") << width << ": control";
    }
}

TEST(FieldOfView, IsThatOfThePicture) {
    SymbologyInput input = scene_input(scene_state(0, 0, 0), 640, 480);
    const Layout layout = make_layout(640, 480, 96);
    BatchStore store;
    const auto states_it = [&] {
        build_symbology(store.batch, input, layout);
        return text_of(store.batch).find("FOV60") != std::string::npos;
    };
    EXPECT_TRUE(states_it());
    input.over = SymbolGround::map;
    EXPECT_FALSE(states_it()) << "the map has a range ring";
    input.over = SymbolGround::perspective;
    input.decisions.unusual_attitude = true;
    EXPECT_FALSE(states_it()) << "a recovery picture has what is needed to recover";
    input.decisions.unusual_attitude = false;
    input.decisions[policy::Element::attitude].show = policy::ElementShow::failed;
    EXPECT_FALSE(states_it()) << "nothing is shown across the width";
}

}  // namespace
}  // namespace tedavis::draw::test_field_of_view
