#include "render_core/draw/symbology/map_symbols.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_map_symbols {
namespace {

using base::radians;
using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::scene_input;
using test_support::scene_state;
using test_support::text_of;

struct Screen {
    std::uint32_t width, height;
};
constexpr base::DisplayUnits kInFeet = base::DisplayUnits::feet_and_knots, kInMetres = base::DisplayUnits::metric;
constexpr Screen kScreens[] = {{640, 480}, {1920, 1080}, {768, 1024}, {320, 240}, {240, 320}};
constexpr ElementShow kShows[] = {ElementShow::normal, ElementShow::substituted, ElementShow::flagged, ElementShow::failed,
                                  ElementShow::absent};

/// A map of 20 km to the nearest edge.
SymbologyInput map_input(double heading_deg, double up_deg, Screen screen = {1024, 768}, double range_m = 20'000) {
    SymbologyInput input = scene_input(scene_state(heading_deg, 3, 20), screen.width, screen.height);
    input.over = SymbolGround::map;
    input.map = {radians(up_deg), 0.5 * std::min(screen.width, screen.height) / range_m};
    return input;
}

bool is_color(const QuadVertex& v, design::Color color) {
    return v.rgba[0] == color.red && v.rgba[1] == color.green && v.rgba[2] == color.blue;
}
bool has_color(const QuadBatch& batch, design::Color color) {
    return std::any_of(batch.vertices().begin(), batch.vertices().end(), [&](const auto& v) { return is_color(v, color); });
}

struct Drawn {
    explicit Drawn(const SymbologyInput& input, Screen screen = {1024, 768})
        : layout(make_layout(screen.width, screen.height, 96)) {
        build_map_symbols(Painter(store.batch, layout), input);
    }
    [[nodiscard]] const QuadBatch& batch() const { return store.batch; }
    [[nodiscard]] std::string text() const { return text_of(store.batch); }
    BatchStore store;
    Layout layout;
};

TEST(MapSymbols, TheRingHasTheLargestRoundNumberThatFits) {
    struct Case {
        double room_px, px_per_m;
        const char* label;
        double miles;
    };
    for (const Case& c : {Case{200, 0.02, "5 NM", 5}, Case{200, 200.0 / 1852, "1 NM", 1}, Case{200, 200.0 / 1851, "0.5 NM", 0.5},
                          Case{100, 0.9, "0.05 NM", 0.05}, Case{300, 1e-4, "500 NM", 500}}) {
        const RangeRing ring = range_ring(c.room_px, c.px_per_m, kInFeet);
        EXPECT_EQ(ring.label, c.label);
        EXPECT_DOUBLE_EQ(ring.radius_m, c.miles * 1852);
    }
    EXPECT_EQ(range_ring(10, 1, kInFeet).radius_m, 0) << "none fits";
    EXPECT_EQ(range_ring(200, 0.02, kInMetres).label, "10 KM");
    EXPECT_DOUBLE_EQ(range_ring(200, 0.02, kInMetres).radius_m, 10'000);
    EXPECT_EQ(range_ring(std::numeric_limits<double>::quiet_NaN(), 1, kInFeet).radius_m, 0);
}

/// Every range that a design may state has its ring on every screen, with room to spare for no more than the next larger one.
TEST(MapSymbols, EveryRangeHasARing) {
    for (const Screen& screen : kScreens)
        for (double range_m = 500; range_m <= 500'000; range_m *= 1.19) {
            const Drawn drawn(map_input(40, 0, screen, range_m), screen);
            EXPECT_NE(drawn.text().find("NM"), std::string::npos) << screen.width << " " << range_m;
        }
}

TEST(MapSymbols, TheRingIsDrawnAtItsRadius) {
    const Drawn drawn(map_input(40, 0));
    ASSERT_NE(drawn.text().find("5NM"), std::string::npos) << drawn.text();
    test_support::Picture picture(1024, 768, {0, 0, 0});
    test_support::rasterize(drawn.batch(), picture);
    const double radius_px = 5 * 1852 * 384 / 20'000.0;
    for (const double angle_deg : {20.0, 80.0, 170.0, 200.0, 275.0}) {
        const double x = 512 + radius_px * std::sin(radians(angle_deg)), y = 384 - radius_px * std::cos(radians(angle_deg));
        EXPECT_GT(picture.at(static_cast<int>(x), static_cast<int>(y)).red, 100) << angle_deg;
        const double inside = (radius_px - 6) / radius_px;
        EXPECT_LT(picture.at(static_cast<int>(512 + inside * (x - 512)), static_cast<int>(384 + inside * (y - 384))).red, 50);
    }
}

SymbologyInput oblique_input(double above_ground_m, double turn_deg = 0, bool flat = false) {
    SymbologyInput input = map_input(40, 0);
    input.map.is_oblique = true;
    input.map.is_flat = flat;
    input.map.look_down_rad = radians(30);
    input.map.turn_rad = radians(turn_deg);
    input.map.above_ground_m = above_ground_m;
    return input;
}

/// Where the ring would pass through ground that is shown elsewhere, it is left out.
TEST(MapSymbols, TheRingIsBrokenWhereTheGroundIsMoved) {
    SymbologyInput input = map_input(0, 0);
    const Drawn whole(input);
    const RangeRing ring = range_ring(200, input.map.px_per_m, kInFeet);
    const auto radius = static_cast<float>(ring.radius_m * input.map.px_per_m);
    const Point middle = whole.layout.screen.center();
    MagnifiedSign sign;
    sign.middle = {middle.x - radius, middle.y};
    sign.radius_px = 30;
    sign.reach_px = 60;
    sign.power = 1;
    sign.compression = 1;
    ASSERT_TRUE(input.map.magnified.try_push_back(sign));
    const Drawn broken(input);
    const auto vertices_near = [&](const Drawn& drawn, Point at) {
        return std::count_if(drawn.batch().vertices().begin(), drawn.batch().vertices().end(), [&](const QuadVertex& v) {
            return is_color(v, test_support::day_color(SymbolRole::scale)) && std::hypot(v.x - at.x, v.y - at.y) < 12;
        });
    };
    const Point there = sign.middle, opposite{middle.x + radius, middle.y};
    if (ring.radius_m > 0 && vertices_near(whole, there) > 0) {
        EXPECT_EQ(vertices_near(broken, there), 0);
        EXPECT_GT(vertices_near(broken, opposite), 0);
    }
}

TEST(MapSymbols, PlacesThatAreShownLargerSayByHowMuch) {
    SymbologyInput input = map_input(0, 0);
    EXPECT_EQ(Drawn(input).text().find("FOCUS"), std::string::npos);
    MagnifiedSign sign;
    sign.middle = {600, 500};
    sign.radius_px = 50;
    sign.reach_px = 120;
    sign.power = 2;
    sign.compression = 1;
    ASSERT_TRUE(input.map.magnified.try_push_back(sign));
    const std::string text = Drawn(input).text();
    EXPECT_NE(text.find("FOCUS4x"), std::string::npos) << text;
    EXPECT_NE(text.find("RIM1/2"), std::string::npos) << text;
    EXPECT_NE(text.find("DISTORTED4x"), std::string::npos) << text;
    sign.middle = {5000, 500};
    sign.power = 1;
    ASSERT_TRUE(input.map.magnified.try_push_back(sign));
    const std::string both = Drawn(input).text();
    EXPECT_EQ(both.find("FOCUS2x"), std::string::npos) << "far out of the picture";
    EXPECT_EQ(both.find("DISTORTED4x"), std::string::npos) << "not all alike";
    EXPECT_NE(both.find("DISTORTED"), std::string::npos);
}

TEST(MapSymbols, TheOrthographicViewSaysSo) {
    EXPECT_EQ(Drawn(map_input(40, 0)).text().find("ORTHO"), std::string::npos);
    const std::string text = Drawn(oblique_input(1000)).text();
    EXPECT_NE(text.find("ORTHO"), std::string::npos) << text;
    EXPECT_EQ(text.find("FLAT"), std::string::npos) << text;
    const std::string turned = Drawn(oblique_input(1000, -35, true)).text();
    EXPECT_NE(turned.find("FLAT"), std::string::npos) << turned;
    EXPECT_NE(turned.find("-035"), std::string::npos) << turned;
    SymbologyInput map = map_input(40, 0);
    map.map.is_flat = true;
    EXPECT_NE(Drawn(map).text().find("FLAT"), std::string::npos) << "a flat map too";
}

TEST(MapSymbols, ObliquelyTheRingLiesLevelRoundTheOwnShipsPlaceOnTheGround) {
    for (const double above_m : {0.0, 3000.0}) {
        const Drawn drawn(oblique_input(above_m));
        ASSERT_NE(drawn.text().find("5NM"), std::string::npos) << drawn.text();
        test_support::Picture picture(1024, 768, {0, 0, 0});
        test_support::rasterize(drawn.batch(), picture);
        const double px_per_m = 384 / 20'000.0, radius_px = 5 * 1852 * px_per_m;
        const double down_px = above_m * std::cos(radians(30)) * px_per_m;
        for (const double angle_deg : {20.0, 80.0, 170.0, 200.0, 275.0}) {
            const double x = 512 + radius_px * std::sin(radians(angle_deg));
            const double y = 384 + down_px - 0.5 * radius_px * std::cos(radians(angle_deg));
            EXPECT_GT(picture.at(static_cast<int>(x), static_cast<int>(y)).red, 100) << angle_deg << " " << above_m;
        }
        const auto half_way = picture.at(512, static_cast<int>(384 + 0.6 * down_px));
        EXPECT_EQ(half_way.red > 100, above_m > 0) << "a line leads down to it";
    }
    EXPECT_NE(Drawn(oblique_input(std::nan(""))).text().find("NM"), std::string::npos) << "without a height round the own ship";
}

/// Where the symbol's nose is: the middle of its colour lies ahead of the own ship, for wings and nose outweigh the tail.
Point nose_of(const QuadBatch& batch, design::Color color) {
    double x = 0, y = 0, count = 0;
    for (const QuadVertex& v : batch.vertices())
        if (is_color(v, color)) x += static_cast<double>(v.x), y += static_cast<double>(v.y), ++count;
    return {static_cast<float>(x / count), static_cast<float>(y / count)};
}

TEST(MapSymbols, TheOwnShipPointsAlongItsHeading) {
    for (const double up_deg : {0.0, 30.0, 300.0})
        for (const double heading_deg : {0.0, 77.0, 190.0, 359.0}) {
            const Drawn drawn(map_input(heading_deg, up_deg));
            const Point tail = nose_of(
                drawn.batch(), test_support::day_color(SymbolRole::reference));  // wings forward of, tail behind the middle
            const double angle = radians(heading_deg - up_deg);
            const double along = (tail.x - 512) * std::sin(angle) - (tail.y - 384) * std::cos(angle);
            const double aside = (tail.x - 512) * std::cos(angle) + (tail.y - 384) * std::sin(angle);
            EXPECT_NEAR(aside, 0, 0.1) << heading_deg << " " << up_deg;
            EXPECT_LT(along, -1) << "the tail is where the heading is not";
            EXPECT_GT(along, -12);
        }
}

TEST(MapSymbols, WithoutAHeadingTheOwnShipPointsNowhere) {
    SymbologyInput input = map_input(40, 0);
    input.decisions.view_heading = Signal::count_;
    const Drawn disc(input);
    input.view_heading_rad = 2;
    const Drawn other(input);
    ASSERT_EQ(disc.batch().vertices().size(), other.batch().vertices().size());
    for (std::size_t n = 0; n < disc.batch().vertices().size(); ++n)
        EXPECT_EQ(disc.batch().vertices()[n].x, other.batch().vertices()[n].x);
    EXPECT_TRUE(has_color(disc.batch(), test_support::day_color(SymbolRole::reference))) << "the position is good";
    input.decisions.view_heading = Signal::true_heading;
    EXPECT_NE(disc.batch().vertices().size(), Drawn(input).batch().vertices().size()) << "control";
}

TEST(MapSymbols, ATrackInTheHeadingsPlaceIsAmber) {
    SymbologyInput input = map_input(40, 0);
    input.decisions.view_heading = Signal::true_track;
    EXPECT_TRUE(has_color(Drawn(input).batch(), test_support::day_color(SymbolRole::caution)));
    EXPECT_FALSE(has_color(Drawn(input).batch(), test_support::day_color(SymbolRole::reference)));
}

TEST(MapSymbols, TheArrowPointsNorthAndSaysWhatIsUp) {
    struct Case {
        Signal source;
        ElementShow show;
        const char* label;
    };
    for (const Case& c :
         {Case{Signal::count_, ElementShow::normal, "NORTHUP"}, Case{Signal::true_track, ElementShow::normal, "TRKUP"},
          Case{Signal::true_heading, ElementShow::substituted, "HDGUP"}, Case{Signal::count_, ElementShow::flagged, "NORTHUP"}}) {
        SymbologyInput input = map_input(40, 0);
        input.decisions[Element::map_up] = {c.show, c.source};
        const Drawn drawn(input);
        EXPECT_NE(drawn.text().find(c.label), std::string::npos) << drawn.text();
        EXPECT_EQ(has_color(drawn.batch(), test_support::day_color(SymbolRole::caution)), c.show != ElementShow::normal)
            << c.label;
    }
    // The letter lies off the plate's middle towards the north.
    for (const double up_deg : {0.0, 90.0, 200.0}) {
        const Drawn north(map_input(40, up_deg)), opposite(map_input(40, up_deg + 180));
        float x = 0, y = 0;
        for (std::size_t n = 0; n < north.batch().vertices().size(); ++n) {
            const QuadVertex &a = north.batch().vertices()[n], &b = opposite.batch().vertices()[n];
            if (a.extent_x != -1.0f || a.u != b.u || a.v != b.v || (a.x == b.x && a.y == b.y)) continue;
            x = a.x - b.x, y = a.y - b.y;
            break;
        }
        EXPECT_NEAR(std::atan2(static_cast<double>(x), static_cast<double>(-y)), std::remainder(radians(-up_deg), 2 * base::kPi),
                    1e-3)
            << up_deg;
    }
}

TEST(MapSymbols, EverythingStaysInItsBoxInEveryPicture) {
    for (const Screen& screen : kScreens)
        for (const double up_deg : {0.0, 33.0, 211.0})
            for (const ElementShow position : kShows)
                for (const Signal heading : {Signal::true_heading, Signal::count_}) {
                    SymbologyInput input = map_input(100, up_deg, screen);
                    input.decisions[Element::position].show = position;
                    input.decisions.view_heading = heading;
                    const Drawn drawn(input, screen);
                    EXPECT_EQ(drawn.batch().use().refused, 0u);
                    EXPECT_EQ(drawn.batch().vertices().empty(), position == ElementShow::absent);
                    const Rect room = conformal_box(drawn.layout).shrunk(-2.5f);
                    for (const QuadVertex& v : drawn.batch().vertices())
                        ASSERT_TRUE(room.contains(Point{v.x, v.y})) << screen.width << " at " << v.x << ", " << v.y;
                }
}

TEST(MapSymbols, ALostPositionIsACrossThatSaysNothingElse) {
    SymbologyInput input = map_input(40, 0);
    input.decisions[Element::position].show = ElementShow::failed;
    const Drawn drawn(input);
    EXPECT_TRUE(has_color(drawn.batch(), test_support::day_color(SymbolRole::warning)));
    EXPECT_EQ(drawn.text(), "NOPOSITION");
    EXPECT_FALSE(has_color(drawn.batch(), test_support::day_color(SymbolRole::reference)));
}

TEST(MapSymbols, AStalePositionIsAmberAndSaysSo) {
    SymbologyInput input = map_input(40, 0);
    EXPECT_FALSE(has_color(Drawn(input).batch(), test_support::day_color(SymbolRole::caution))) << "control";
    input.decisions[Element::position].show = ElementShow::flagged;
    const Drawn drawn(input);
    EXPECT_FALSE(has_color(drawn.batch(), test_support::day_color(SymbolRole::reference)));
    EXPECT_TRUE(has_color(drawn.batch(), test_support::day_color(SymbolRole::caution)));
    EXPECT_NE(drawn.text().find("POSITIONSTALE"), std::string::npos);
}

TEST(MapSymbols, EachGroundHasItsOwnSymbols) {
    const Layout layout = make_layout(1024, 768, 96);
    SymbologyInput input = map_input(40, 0);
    const auto text_over = [&](SymbolGround ground) {
        BatchStore store;
        input.over = ground;
        build_symbology(store.batch, input, layout);
        EXPECT_EQ(store.batch.use().refused, 0u);
        return text_of(store.batch);
    };
    const std::string ahead = text_over(SymbolGround::perspective), map = text_over(SymbolGround::map),
                      moving = text_over(SymbolGround::moving);
    EXPECT_NE(map.find("NORTHUP"), std::string::npos);
    EXPECT_EQ(ahead.find("NORTHUP"), std::string::npos);
    EXPECT_EQ(moving.find("NORTHUP"), std::string::npos);
    for (const std::string& text : {ahead, map, moving}) {
        EXPECT_NE(text.find("HDGTRUE"), std::string::npos);
        EXPECT_NE(text.find("BAROFT"), std::string::npos);
    }
    EXPECT_LT(moving.size(), ahead.size()) << "no ladder on the way";
    input.shown.map = false;
    EXPECT_EQ(text_over(SymbolGround::map), moving) << "a design may leave them out";
}

TEST(MapSymbols, HostileNumbersDrawNothingWild) {
    for (const double hostile :
         {1e300, -1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        SymbologyInput input = map_input(40, 0);
        input.map.up_rad = input.view_heading_rad = hostile;
        const Drawn drawn(input);
        for (const QuadVertex& v : drawn.batch().vertices()) ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y));
    }
}

}  // namespace
}  // namespace tedavis::draw::test_map_symbols
