#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_air {
namespace {

using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::kSceneNow;

struct Air {
    explicit Air(double speed_kt = 12, double from_deg = 265, double temperature_c = -5) {
        state = test_support::scene_state(20, 0, 0);
        state[Signal::wind_speed] = {speed_kt * base::kMpsPerKnot, kSceneNow};
        state[Signal::wind_direction] = {base::radians(from_deg), kSceneNow};
        state[Signal::outside_temperature] = {273.15 + temperature_c, kSceneNow};
    }
    [[nodiscard]] SymbologyInput input() const { return test_support::scene_input(state, 640, 480); }
    void build(const SymbologyInput& shown, std::uint32_t width = 640, std::uint32_t height = 480) {
        layout = make_layout(width, height, 96);
        store.batch.clear();
        build_air(Painter(store.batch, layout), shown);
    }
    [[nodiscard]] std::string text(const SymbologyInput& shown) {
        build(shown);
        return test_support::text_of(store.batch);
    }
    [[nodiscard]] std::string text() { return text(input()); }

    flight::AircraftState state;
    Layout layout;
    BatchStore store;
};

/// From the middle of the arrow's square to the white corner that is farthest from it: the head, which is longer than the tail.
glm::dvec2 arrow_way(const QuadBatch& batch, const Rect& box) {
    const double half = 0.25 * static_cast<double>(box.height);
    const glm::dvec2 center{static_cast<double>(box.x) + half, static_cast<double>(box.y) + half};
    glm::dvec2 farthest(0);
    for (const QuadVertex& vertex : batch.vertices()) {
        const glm::dvec2 from = glm::dvec2(vertex.x, vertex.y) - center;
        if (vertex.rgba[0] == 255 && std::fabs(from.x) <= half && std::fabs(from.y) <= half &&
            glm::length(from) > glm::length(farthest))
            farthest = from;
    }
    return farthest;
}

TEST(AirReadout, SaysWindAndTemperature) {
    EXPECT_EQ(Air().text(),
              "265/12KTOAT-5\xB0"
              "C");
    EXPECT_EQ(Air(7.4, 4, 21).text(),
              "004/7KTOAT21\xB0"
              "C");
    EXPECT_EQ(Air(30, 0.2, 0).text().substr(0, 8), "360/30KT") << "north is 360";
    EXPECT_EQ(Air(0.3, 90, 0).text().substr(0, 4), "CALM");
}

TEST(AirReadout, StaleShowsItsAgeAndLostIsCrossedOut) {
    Air air;
    SymbologyInput shown = air.input();
    shown.decisions[Element::wind].show = ElementShow::flagged;
    shown.wind_age = base::Duration::milliseconds(14'400);
    EXPECT_EQ(air.text(shown).substr(0, 9), "265/1214S");
    shown.decisions[Element::wind].show = ElementShow::failed;
    const std::string lost = air.text(shown);
    EXPECT_EQ(lost.substr(0, 4), "WIND");
    EXPECT_EQ(lost.find("265"), std::string::npos);
    shown.decisions[Element::wind].show = ElementShow::absent;
    EXPECT_EQ(air.text(shown).find("WIND"), std::string::npos);
    shown.decisions[Element::outside_temperature].show = ElementShow::flagged;
    shown.temperature_age = base::Duration::seconds(25);
    EXPECT_NE(air.text(shown).find("25S"), std::string::npos);
    shown.decisions[Element::outside_temperature].show = ElementShow::failed;
    EXPECT_EQ(air.text(shown), "OAT");
    shown.decisions[Element::outside_temperature].show = ElementShow::absent;
    air.build(shown);
    EXPECT_TRUE(air.store.batch.vertices().empty());
}

TEST(AirReadout, AgesAreThoseOfTheOlderSignal) {
    Air air;
    air.state[Signal::wind_direction] = {1.0, kSceneNow - base::Duration::seconds(9)};
    air.state[Signal::wind_speed] = {1.0, kSceneNow - base::Duration::seconds(4)};
    EXPECT_EQ(air.input().wind_age.ns, base::Duration::seconds(9).ns);
    EXPECT_EQ(air.input().temperature_age.ns, 0);
}

TEST(AirReadout, TheArrowPointsWhereTheWindBlows) {
    Air air(20, 290);  // heading 20: from the left, to the right
    air.build(air.input());
    const Rect box = air.layout.air;
    glm::dvec2 way = arrow_way(air.store.batch, box);
    EXPECT_GT(way.x, 5);
    EXPECT_NEAR(way.y, 0, 1.5);
    SymbologyInput on_map = air.input();
    on_map.over = SymbolGround::map;
    on_map.map.up_rad = base::radians(290);  // from the top, downwards
    air.build(on_map);
    way = arrow_way(air.store.batch, box);
    EXPECT_NEAR(way.x, 0, 1.5);
    EXPECT_GT(way.y, 5);
    on_map.over = SymbolGround::moving;
    air.build(on_map);
    EXPECT_EQ(arrow_way(air.store.batch, box), glm::dvec2(0)) << "nobody knows what is up";
}

TEST(AirReadout, StaysInItsCornerWhateverTheNumbers) {
    for (const auto& [width, height] : {std::pair{640u, 480u}, {320u, 240u}, {240u, 320u}, {1920u, 1080u}, {480u, 800u}})
        for (const double number : {0.0, 1e9, -1e9, double{NAN}}) {
            Air air(number, number, number);
            SymbologyInput shown = air.input();
            for (const ElementShow show : {ElementShow::normal, ElementShow::flagged, ElementShow::failed}) {
                shown.decisions[Element::wind].show = shown.decisions[Element::outside_temperature].show = show;
                air.build(shown, width, height);
                EXPECT_TRUE(air.layout.attitude.contains(air.layout.air));
                const Rect room = air.layout.air.shrunk(-2.5f);
                for (const QuadVertex& vertex : air.store.batch.vertices())
                    ASSERT_TRUE(room.contains(Point{vertex.x, vertex.y})) << width << " " << number;
                EXPECT_EQ(air.store.batch.use().refused, 0u);
            }
        }
}

}  // namespace
}  // namespace tedavis::draw::test_air
