// Headings on the horizon line (P01, P04).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_horizon_headings {
namespace {

using flight::Signal;
using policy::Element;
using test_support::BatchStore;
using test_support::kSceneNow;
using test_support::scene_input;
using test_support::scene_state;
using test_support::text_of;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1280, 720}, {480, 640}};

/// A white line begins on the horizon at a true direction and rises from it.
bool has_tick(const QuadBatch& batch, const SymbologyInput& input, double direction_deg, float text_px) {
    const ProjectedPoint place = project(input.view, direction_of(base::radians(direction_deg), 0));
    const auto vertices = batch.vertices();
    const float near_px = std::max(2.0f, 0.12f * text_px);  // half a line and the pixel in which it fades out
    return std::any_of(vertices.begin(), vertices.end(), [&](const QuadVertex& v) {
        return v.rgba[0] == 255 && v.rgba[1] == 255 && v.rgba[2] == 255 && std::abs(v.x - place.at.x) < near_px &&
               std::abs(v.y - (place.at.y - 0.35f * text_px)) < near_px;
    });
}

TEST(HorizonHeadings, P04TicksStandAtTheirDirections) {
    for (const Screen& screen : kScreens) {
        const SymbologyInput input = scene_input(scene_state(33, 0, 0), screen.width, screen.height);
        const Layout layout = make_layout(screen.width, screen.height, 96);
        BatchStore store;
        build_attitude(Painter(store.batch, layout), input);
        for (const double direction : {30.0, 40.0})
            EXPECT_TRUE(has_tick(store.batch, input, direction, layout.text_px)) << direction;
        EXPECT_FALSE(has_tick(store.batch, input, 36.0, layout.text_px)) << "the control";
        EXPECT_NE(text_of(store.batch).find('3'), std::string::npos);
    }
}

TEST(HorizonHeadings, P04AMagneticDisplayHasMagneticOnesOrNone) {
    flight::AircraftState state = scene_state(33, 0, 0);
    state[Signal::true_heading] = {};
    state[Signal::magnetic_heading] = {base::radians(33), kSceneNow};
    state[Signal::magnetic_variation] = {base::radians(4), kSceneNow};
    const Layout layout = make_layout(640, 480, 96);
    SymbologyInput input = scene_input(state, 640, 480);
    ASSERT_EQ(input.decisions[Element::heading].source, Signal::magnetic_heading);
    BatchStore magnetic;
    build_attitude(Painter(magnetic.batch, layout), input);
    EXPECT_TRUE(has_tick(magnetic.batch, input, 34, layout.text_px)) << "030 magnetic";
    EXPECT_FALSE(has_tick(magnetic.batch, input, 30, layout.text_px));
    input.from_true_rad = NAN;
    BatchStore unknown;
    build_attitude(Painter(unknown.batch, layout), input);
    EXPECT_FALSE(has_tick(unknown.batch, input, 34, layout.text_px));
}

TEST(HorizonHeadings, P04AHeadingThatIsStaleHasNone) {
    flight::AircraftState state = scene_state(243, 0, 0);
    state[Signal::true_track] = {};
    state[Signal::magnetic_heading] = {};
    state[Signal::true_heading] = {base::radians(243), kSceneNow - base::Duration::milliseconds(700)};
    const Layout layout = make_layout(640, 480, 96);
    const SymbologyInput input = scene_input(state, 640, 480);
    ASSERT_EQ(input.decisions[Element::heading].show, policy::ElementShow::flagged);
    BatchStore store;
    build_attitude(Painter(store.batch, layout), input);
    EXPECT_EQ(text_of(store.batch).find('N'), std::string::npos) << "the view faces north, the aircraft does not";
    EXPECT_FALSE(has_tick(store.batch, input, 0, layout.text_px));
}

TEST(HorizonHeadings, P01TheHorizonLineCrossesTheWholeScreen) {
    for (const Screen& screen : kScreens) {
        const SymbologyInput input = scene_input(scene_state(33, 2, 0), screen.width, screen.height);
        BatchStore store;
        build_attitude(Painter(store.batch, make_layout(screen.width, screen.height, 96)), input);
        const double y = screen.height / 2.0 + input.view.focal_px * std::tan(base::radians(2));
        double left = 1e9, right = -1e9;
        for (const QuadVertex& v : store.batch.vertices())
            if (std::abs(static_cast<double>(v.y) - y) < 3)
                left = std::min(left, static_cast<double>(v.x)), right = std::max(right, static_cast<double>(v.x));
        EXPECT_LE(left, 1) << screen.width;
        EXPECT_GE(right, screen.width - 1.0) << screen.width;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_horizon_headings
