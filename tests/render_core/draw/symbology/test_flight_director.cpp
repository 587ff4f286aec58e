#include "render_core/draw/symbology/flight_director.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_flight_director {
namespace {

using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::scene_input;
using test_support::scene_state;
using test_support::text_of;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1280, 720}, {480, 640}};

struct Extent {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    [[nodiscard]] bool empty() const { return right < left; }
    [[nodiscard]] double middle_x() const { return (left + right) / 2; }
    [[nodiscard]] double middle_y() const { return (top + bottom) / 2; }
};

/// Of what has a color; `wide` keeps shapes by the share of their width.
Extent extent_of(const QuadBatch& batch, design::Color color, bool level) {
    Extent extent;
    const auto vertices = batch.vertices();
    for (std::size_t i = 0; i + 3 < vertices.size(); i += 4) {
        Extent shape;
        for (std::size_t n = i; n < i + 4; ++n) {
            shape.left = std::min(shape.left, static_cast<double>(vertices[n].x));
            shape.right = std::max(shape.right, static_cast<double>(vertices[n].x));
            shape.top = std::min(shape.top, static_cast<double>(vertices[n].y));
            shape.bottom = std::max(shape.bottom, static_cast<double>(vertices[n].y));
        }
        const bool has_color =
            vertices[i].rgba[0] == color.red && vertices[i].rgba[1] == color.green && vertices[i].rgba[2] == color.blue;
        const bool is_level = shape.right - shape.left > shape.bottom - shape.top;
        if (!has_color || is_level != level) continue;
        extent.left = std::min(extent.left, shape.left), extent.right = std::max(extent.right, shape.right);
        extent.top = std::min(extent.top, shape.top), extent.bottom = std::max(extent.bottom, shape.bottom);
    }
    return extent;
}

SymbologyInput directed(const Screen& screen, double pitch_deg, double roll_deg) {
    SymbologyInput input = scene_input(scene_state(30, 4, 0), screen.width, screen.height);
    input.decisions[Element::flight_director].show = ElementShow::normal;
    input.guidance.director_pitch_rad = base::radians(pitch_deg);
    input.guidance.director_roll_rad = base::radians(roll_deg);
    return input;
}

TEST(FlightDirector, P24BarsLieWhereTheAttitudeMustGo) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const SymbologyInput input = directed(screen, 3, 10);
        BatchStore store;
        build_flight_director(Painter(store.batch, layout), input);
        const Point c = layout.screen.center();
        const double t = static_cast<double>(layout.text_px);
        const Extent level = extent_of(store.batch, test_support::day_color(SymbolRole::engaged), true),
                     upright = extent_of(store.batch, test_support::day_color(SymbolRole::engaged), false);
        ASSERT_FALSE(level.empty() || upright.empty());
        const double up_px = input.view.focal_px * std::tan(base::radians(3));
        EXPECT_NEAR(level.middle_y(), static_cast<double>(c.y) - std::min(up_px, 4 * t), 0.6);
        EXPECT_NEAR(upright.middle_x(), static_cast<double>(c.x) + base::radians(10) * 10 * t, 0.6);
        // The control: another command lies elsewhere.
        BatchStore other;
        build_flight_director(Painter(other.batch, layout), directed(screen, -1, -5));
        EXPECT_GT(extent_of(other.batch, test_support::day_color(SymbolRole::engaged), true).middle_y(), level.middle_y() + 5);
        EXPECT_LT(extent_of(other.batch, test_support::day_color(SymbolRole::engaged), false).middle_x(), upright.middle_x() - 5);
    }
}

TEST(FlightDirector, P24IsNeverLeftStandingWithoutItsSignals) {
    const Layout layout = make_layout(640, 480, 96);
    for (const ElementShow show : {ElementShow::flagged, ElementShow::failed, ElementShow::absent}) {
        SymbologyInput input = directed(kScreens[0], 3, 10);
        input.decisions[Element::flight_director].show = show;
        BatchStore store;
        build_flight_director(Painter(store.batch, layout), input);
        EXPECT_TRUE(extent_of(store.batch, test_support::day_color(SymbolRole::engaged), true).empty());
        EXPECT_EQ(store.batch.vertices().empty(), show == ElementShow::absent);
        EXPECT_EQ(text_of(store.batch).find("FD") != std::string::npos, show != ElementShow::absent);
    }
    SymbologyInput frozen = directed(kScreens[0], 3, 10);
    frozen.decisions[Element::attitude].show = ElementShow::flagged;
    BatchStore over_stale;
    build_flight_director(Painter(over_stale.batch, layout), frozen);
    EXPECT_TRUE(extent_of(over_stale.batch, test_support::day_color(SymbolRole::engaged), true).empty())
        << "no command over a stale attitude";
    EXPECT_NE(text_of(over_stale.batch).find("FD"), std::string::npos);
    SymbologyInput upset = directed(kScreens[0], 3, 10);
    upset.decisions.unusual_attitude = true;
    BatchStore store;
    build_flight_director(Painter(store.batch, layout), upset);
    EXPECT_TRUE(store.batch.vertices().empty()) << "nothing lies over the recovery picture";
}

TEST(FlightDirector, P25TheReferenceLiesAtTheGlidePathBelowTheHorizon) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        SymbologyInput input = scene_input(scene_state(30, 0, 0), screen.width, screen.height);
        input.decisions[Element::flight_path_reference].show = ElementShow::normal;
        input.guidance.path_reference_rad = base::radians(3);
        BatchStore store;
        build_path_reference(Painter(store.batch, layout), input);
        const Extent dashes = extent_of(store.batch, test_support::day_color(SymbolRole::selected), true);
        ASSERT_FALSE(dashes.empty());
        const double expected = static_cast<double>(layout.screen.center().y) + input.view.focal_px * std::tan(base::radians(3));
        EXPECT_NEAR(dashes.middle_y(), expected, 2.0);
        EXPECT_NE(text_of(store.batch).find("3.0"), std::string::npos);
        input.guidance.path_reference_rad = base::radians(5);
        BatchStore steeper;
        build_path_reference(Painter(steeper.batch, layout), input);
        EXPECT_GT(extent_of(steeper.batch, test_support::day_color(SymbolRole::selected), true).middle_y(), dashes.middle_y() + 5)
            << "the control";
    }
}

TEST(FlightDirector, P25FlaggedAndFailedReferencesAreSaid) {
    const Layout layout = make_layout(640, 480, 96);
    for (const ElementShow show : {ElementShow::flagged, ElementShow::failed}) {
        SymbologyInput input = scene_input(scene_state(30, 0, 0), 640, 480);
        input.decisions[Element::flight_path_reference].show = show;
        BatchStore store;
        build_path_reference(Painter(store.batch, layout), input);
        EXPECT_NE(text_of(store.batch).find("PATH"), std::string::npos);
        EXPECT_TRUE(extent_of(store.batch, test_support::day_color(SymbolRole::selected), true).empty());
    }
}

TEST(FlightDirector, StaysInTheAttitude) {
    for (const Screen& screen : kScreens)
        for (double pitch : {-40.0, -3.0, 3.0, 40.0})
            for (double roll : {-170.0, -20.0, 60.0}) {
                const Layout layout = make_layout(screen.width, screen.height, 96);
                SymbologyInput input = directed(screen, pitch, roll);
                input.decisions[Element::flight_path_reference].show = ElementShow::normal;
                input.guidance.path_reference_rad = base::radians(pitch);
                BatchStore store;
                build_flight_director(Painter(store.batch, layout), input);
                build_path_reference(Painter(store.batch, layout), input);
                for (const QuadVertex& v : store.batch.vertices())
                    ASSERT_TRUE(layout.attitude.shrunk(-2.5f).contains(Point{v.x, v.y}))
                        << screen.width << " " << v.x << " " << v.y;
            }
}

}  // namespace
}  // namespace tedavis::draw::test_flight_director
