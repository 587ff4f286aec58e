#include "render_core/draw/symbology/compass_rose.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/drawn_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_compass_rose {
namespace {

using base::degrees;
using base::radians;
using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::drawn_shapes_of;
using test_support::drawn_text;
using test_support::DrawnGlyph;
using test_support::DrawnLine;
using test_support::DrawnShapes;
using test_support::is_same_color;
using test_support::scene_input;
using test_support::scene_state;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1280, 720}, {480, 640}};
constexpr Screen kAllScreens[] = {{320, 240},  {240, 320},   {640, 480},   {480, 640},   {800, 480},   {1024, 768},
                                  {768, 1024}, {1080, 1920}, {1920, 1080}, {2560, 1080}, {1080, 2560}, {3840, 2160}};

struct Rose {
    explicit Rose(Screen size = {640, 480}, double heading_deg = 47.2)
        : screen(size), input(scene_input(scene_state(heading_deg, 0, 0), size.width, size.height)) {
        input.guidance.turn_rate_radps = 0;
    }
    [[nodiscard]] Layout layout() const { return make_layout(screen.width, screen.height, 96); }
    [[nodiscard]] CompassRose rose() const { return make_compass_rose(layout()); }
    template <class Build>
    [[nodiscard]] DrawnShapes drawn(const Build& build) const {
        BatchStore store;
        const Layout made = layout();
        build(Painter(store.batch, made), make_compass_rose(made));
        EXPECT_EQ(store.batch.use().refused, 0u);
        return drawn_shapes_of(store.batch);
    }
    [[nodiscard]] DrawnShapes card() const {
        return drawn([&](const Painter& painter, const CompassRose& rose) {
            painter.batch().set_clip(rose.card);
            build_rose_card(painter, rose, input.heading_rad);
        });
    }
    [[nodiscard]] DrawnShapes marks() const {
        return drawn([&](const Painter& painter, const CompassRose& rose) { build_rose_marks(painter, rose, input); });
    }
    [[nodiscard]] DrawnShapes trend() const {
        return drawn([&](const Painter& painter, const CompassRose& rose) { build_turn_trend(painter, rose, input); });
    }
    [[nodiscard]] DrawnShapes texts() const {
        return drawn([&](const Painter& painter, const CompassRose& rose) { build_rose_texts(painter, rose, input); });
    }
    [[nodiscard]] DrawnShapes whole() const {
        BatchStore store;
        build_heading(Painter(store.batch, layout()), input);
        return drawn_shapes_of(store.batch);
    }

    Screen screen;
    SymbologyInput input;
};

double apart_deg(double a, double b) { return std::fabs(std::remainder(a - b, 360.0)); }

/// Clockwise from straight up, seen from `center`.
double angle_deg(Point center, Point at) {
    return degrees(std::atan2(static_cast<double>(at.x - center.x), static_cast<double>(center.y - at.y)));
}
double distance(Point a, Point b) { return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y)); }

/// Where two lines meet: the center of a card whose ticks they are.
Point crossing(const DrawnLine& a, const DrawnLine& b) {
    const double ax = a.to.x - a.from.x, ay = a.to.y - a.from.y, bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
    const double along = ((b.from.x - a.from.x) * by - (b.from.y - a.from.y) * bx) / (ax * by - ay * bx);
    return {static_cast<float>(a.from.x + along * ax), static_cast<float>(a.from.y + along * ay)};
}

std::vector<DrawnLine> white_lines(const DrawnShapes& shapes) {
    std::vector<DrawnLine> lines;
    for (const DrawnLine& line : shapes.lines)
        if (is_same_color(line.color, test_support::day_color(SymbolRole::scale))) lines.push_back(line);
    return lines;
}

std::string expected_label(int tick_deg) {
    const std::string winds = tick_deg == 0 ? "N" : tick_deg == 90 ? "E" : tick_deg == 180 ? "S" : tick_deg == 270 ? "W" : "";
    return winds.empty() ? std::to_string(tick_deg / 10) : winds;
}

/// What is wrong with a card for this heading; empty where nothing is: ticks each 5 degrees that all point to one center, longer
/// ones each 10, labels each 30, over at least 90 degrees around the top.
std::string card_fault(const DrawnShapes& shapes, double heading_deg) {
    const std::vector<DrawnLine> ticks = white_lines(shapes);
    if (ticks.size() < 20) return "too few ticks";
    const Point center = crossing(ticks[0], ticks[3]);
    double longest = 0;
    for (const DrawnLine& tick : ticks) longest = std::max(longest, distance(tick.from, tick.to));
    std::set<int> seen;
    for (const DrawnLine& tick : ticks) {
        const double from_deg = angle_deg(center, tick.from), to_deg = angle_deg(center, tick.to);
        if (apart_deg(from_deg, to_deg) > 0.5) return "a tick that is not radial";
        const int tick_deg = 5 * static_cast<int>(std::lround((to_deg + heading_deg) / 5));
        if (apart_deg(to_deg + heading_deg, tick_deg) > 0.2) return "a tick off its direction";
        const bool is_long = distance(tick.from, tick.to) > 0.8 * longest;
        if (apart_deg(to_deg, 0) < 85 && is_long != (tick_deg % 10 == 0)) return "a tick of the wrong length";
        seen.insert((tick_deg + 720) % 360);
    }
    for (int tick_deg = 0; tick_deg < 360; tick_deg += 5) {
        const double angle = std::remainder(tick_deg - heading_deg, 360.0);
        if (std::fabs(angle) < 85 && seen.count(tick_deg) == 0) return "no tick at " + std::to_string(tick_deg);
        if (std::fabs(angle) > 75 || tick_deg % 30 != 0) continue;
        std::string label;
        for (const DrawnGlyph& glyph : shapes.glyphs)
            if (apart_deg(angle_deg(center, glyph.at), angle) < 14 &&
                is_same_color(glyph.color, test_support::day_color(SymbolRole::scale)))
                label += glyph.character;
        if (label != expected_label(tick_deg)) return "label " + label + " at " + std::to_string(tick_deg);
    }
    return {};
}

TEST(CompassRose, P21TheCardHasTicksAt5And10DegreesAndLabelsAt30) {
    for (const Screen& screen : kScreens)
        for (const double heading_deg : {0.0, 47.2, 95.0, 181.3, 270.0, 359.6}) {
            const Rose rose(screen, heading_deg);
            DrawnShapes shapes = rose.card();
            EXPECT_EQ(card_fault(shapes, heading_deg), "") << screen.width << " " << heading_deg;
            EXPECT_NE(card_fault(shapes, heading_deg + 1), "") << "control: turned";
            // The tick at the top is always in sight.
            const CompassRose made = rose.rose();
            const auto top = std::min_element(shapes.lines.begin(), shapes.lines.end(), [&](const auto& a, const auto& b) {
                const auto off = [&](const DrawnLine& line) {
                    return is_same_color(line.color, test_support::day_color(SymbolRole::scale))
                               ? apart_deg(angle_deg(made.center, line.to), 0)
                               : 999;
                };
                return off(a) < off(b);
            });
            const DrawnLine kept = *top;
            top->color = test_support::day_color(SymbolRole::caution);
            EXPECT_NE(card_fault(shapes, heading_deg), "") << "control: recolored";
            *top = kept;
            top->to.x += 0.1f * made.radius;
            EXPECT_NE(card_fault(shapes, heading_deg), "") << "control: moved";
            shapes.lines.erase(top);
            EXPECT_NE(card_fault(shapes, heading_deg), "") << "control: removed";
        }
}

TEST(CompassRose, P21TheSmallestScreensHaveACoarserCardThatIsStillRead) {
    for (const Screen& screen : {Screen{320, 240}, {240, 320}}) {
        const DrawnShapes shapes = Rose(screen, 0).card();
        const CompassRose rose = Rose(screen, 0).rose();
        const std::vector<DrawnLine> ticks = white_lines(shapes);
        double nearest = 999;
        for (std::size_t i = 0; i < ticks.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, distance(ticks[i].to, ticks[j].to));
        EXPECT_GE(nearest, 4) << screen.width;
        EXPECT_EQ(drawn_text(shapes, test_support::day_color(SymbolRole::scale)).substr(0, 1), "N");
        for (const DrawnGlyph& glyph : shapes.glyphs) EXPECT_TRUE(rose.card.contains(glyph.at));
    }
}

TEST(CompassRose, TextsAreAtLeast11PixelsHighFrom480PixelsOn) {
    const auto smallest_px = [](const DrawnShapes& shapes) {
        float smallest = 999;
        for (const DrawnGlyph& glyph : shapes.glyphs) smallest = std::min(smallest, glyph.em_px);
        return smallest;
    };
    for (const Screen& screen : kScreens) {
        Rose rose(screen);
        for (const ElementShow show : {ElementShow::normal, ElementShow::flagged}) {
            for (const Element element : {Element::selected_heading, Element::waypoint_bearing, Element::turn_rate})
                rose.input.decisions[element].show = show;
            EXPECT_GE(smallest_px(rose.card()), 10.99f) << screen.width;
            EXPECT_GE(smallest_px(rose.texts()), 10.99f) << screen.width;
        }
    }
    const DrawnShapes tiny = Rose({640, 480}).drawn([](const Painter& painter, const CompassRose& rose) {
        painter.batch().text("12", rose.center, TextAnchor::center, {9.6f, painter.color(SymbolRole::scale)});
    });
    EXPECT_LT(smallest_px(tiny), 10) << "control";
}

TEST(CompassRose, TheRoseIsWholeInPortraitAndElseShowsAtLeast200Degrees) {
    for (const Screen& screen : kAllScreens) {
        const CompassRose rose = Rose(screen).rose();
        EXPECT_EQ(rose.is_whole, screen.height > screen.width) << screen.width;
        EXPECT_TRUE(rose.box.contains(rose.center));
        EXPECT_GE(rose.radius, 2.5f * rose.text_px);
        EXPECT_TRUE(rose.box.shrunk(-0.01f).contains(rose.at(radians(90), rose.radius + 0.5f * rose.text_px)));
        EXPECT_EQ(rose.box.contains(rose.at(radians(180), rose.radius)), rose.is_whole);
        EXPECT_TRUE(rose.box.contains(rose.at(radians(100), rose.radius))) << screen.width;
        EXPECT_FALSE(rose.readout.overlaps(rose.card.shrunk(0.01f)));
    }
}

TEST(CompassRose, TextsBesideTheCardTouchNeitherItNorEachOther) {
    for (const Screen& screen : kAllScreens) {
        const CompassRose rose = Rose(screen).rose();
        for (const RoseSide side : {RoseSide::left, RoseSide::right})
            for (int row = 0; row < rose.rows; ++row) {
                const Rect place = rose.side_row(side, row);
                EXPECT_TRUE(rose.card.shrunk(-0.01f).contains(place)) << screen.width << " row " << row;
                EXPECT_GE(place.width, 3.3f * rose.text_px) << screen.width << " row " << row;
                for (const Point& corner : {Point{place.x, place.y}, Point{place.x, place.bottom()},
                                            Point{place.right(), place.y}, Point{place.right(), place.bottom()}})
                    EXPECT_GE(distance(corner, rose.center), static_cast<double>(rose.radius));
                if (row > 0) {
                    EXPECT_FALSE(place.shrunk(0.01f).overlaps(rose.side_row(side, row - 1)));
                }
            }
    }
}

/// Mean of the corners of what has this color, seen from the center.
double mark_angle_deg(const DrawnShapes& shapes, Point center, design::Color color) {
    double x = 0, y = 0;
    const auto add = [&](Point at) { x += static_cast<double>(at.x - center.x), y += static_cast<double>(center.y - at.y); };
    for (const test_support::DrawnTriangle& triangle : shapes.triangles)
        if (is_same_color(triangle.color, color))
            for (const Point& corner : triangle.corners) add(corner);
    return degrees(std::atan2(x, y));
}

TEST(CompassRose, P21TheBugTheBearingAndTheTrackStandAtTheirDirections) {
    for (const Screen& screen : kScreens)
        for (const double off_deg : {-80.0, -20.0, 0.0, 35.0, 90.0}) {
            Rose rose(screen, 200);
            const Point center = rose.rose().center;
            rose.input.decisions[Element::waypoint_bearing].show = ElementShow::absent;
            rose.input.shows_track = false;
            rose.input.guidance.selected_heading_rad = radians(200 + off_deg);
            EXPECT_NEAR(mark_angle_deg(rose.marks(), center, test_support::day_color(SymbolRole::selected)), off_deg, 0.6);
            rose.input.guidance.selected_heading_rad = radians(203 + off_deg);
            EXPECT_GT(apart_deg(mark_angle_deg(rose.marks(), center, test_support::day_color(SymbolRole::selected)), off_deg), 2)
                << "control: moved";

            rose.input.decisions[Element::selected_heading].show = ElementShow::absent;
            EXPECT_TRUE(rose.marks().triangles.empty()) << "control: removed";
            rose.input.decisions[Element::waypoint_bearing].show = ElementShow::normal;
            rose.input.guidance.waypoint_bearing_rad = radians(200 + off_deg);
            int through = 0;  // both halves of the pointer point along the bearing
            for (const DrawnLine& line : rose.marks().lines) {
                if (!is_same_color(line.color, test_support::day_color(SymbolRole::selected)) ||
                    distance(line.from, line.to) < 0.3 * rose.rose().radius)
                    continue;
                const double angle = angle_deg(line.from, line.to);
                EXPECT_LT(std::min(apart_deg(angle, off_deg), apart_deg(angle, off_deg + 180)), 0.5);
                through += distance(line.from, center) > 0 ? 1 : 0;
            }
            EXPECT_EQ(through, 2);

            rose.input.decisions[Element::waypoint_bearing].show = ElementShow::absent;
            rose.input.shows_track = true;
            rose.input.track_rad = radians(200 + off_deg);
            double x = 0, y = 0;
            for (const DrawnLine& line : white_lines(rose.marks()))
                x += static_cast<double>(line.from.x + line.to.x) / 2 - static_cast<double>(center.x),
                    y += static_cast<double>(center.y) - static_cast<double>(line.from.y + line.to.y) / 2;
            EXPECT_EQ(white_lines(rose.marks()).size(), 4u);
            EXPECT_NEAR(degrees(std::atan2(x, y)), off_deg, 0.5);
            rose.input.decisions[Element::heading].source = Signal::true_track;
            EXPECT_TRUE(rose.marks().lines.empty()) << "a rose that the track turns has no mark of it";
        }
}

TEST(CompassRose, P21TheTrendReachesTheHeadingIn6SecondsAndHasMarksAtTheStandardRate) {
    for (const Screen& screen : kScreens)
        for (const double rate_degps : {-6.0, -3.0, 0.5, 1.5, 4.0}) {
            Rose rose(screen);
            const Point center = rose.rose().center;
            rose.input.guidance.turn_rate_radps = radians(rate_degps);
            const std::vector<DrawnLine> lines = white_lines(rose.trend());
            ASSERT_EQ(lines.size(), 12u);
            std::vector<double> marks_deg;
            double end_deg = 0;
            for (const DrawnLine& line : lines) {
                const double from = angle_deg(center, line.from), to = angle_deg(center, line.to);
                if (apart_deg(from, to) < 0.05) marks_deg.push_back(to);
                for (const double at : {from, to})
                    if (apart_deg(from, to) >= 0.05 && std::fabs(at) > std::fabs(end_deg)) end_deg = at;
            }
            ASSERT_EQ(marks_deg.size(), 4u);
            const double expected_deg[] = {-18, -9, 9, 18};
            for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(marks_deg[i], expected_deg[i], 0.1);
            // The arc is longer by half its width.
            EXPECT_NEAR(end_deg, std::clamp(6 * rate_degps, -24.0, 24.0), 2.0) << rate_degps;
        }
    Rose still;
    still.input.decisions[Element::turn_rate].show = ElementShow::absent;
    EXPECT_TRUE(still.trend().lines.empty()) << "control: removed";
}

TEST(CompassRose, TurningTheAircraftAndAllDirectionsTogetherMovesTheCardAlone) {
    for (const double turn_deg : {17.0, 130.0, 275.0}) {
        Rose before({640, 480}, 20), after({640, 480}, 20 + turn_deg);
        const auto direct = [](Rose& rose, double by_deg) {
            rose.input.guidance.selected_heading_rad = radians(50 + by_deg);
            rose.input.guidance.waypoint_bearing_rad = radians(340 + by_deg);
            rose.input.track_rad = radians(28 + by_deg);
            rose.input.guidance.turn_rate_radps = radians(2);
        };
        direct(before, 0);
        direct(after, turn_deg);
        const auto same = [](const DrawnShapes& a, const DrawnShapes& b) {
            if (a.lines.size() != b.lines.size()) return false;
            for (std::size_t i = 0; i < a.lines.size(); ++i)
                if (distance(a.lines[i].from, b.lines[i].from) > 0.05 || distance(a.lines[i].to, b.lines[i].to) > 0.05)
                    return false;
            return true;
        };
        EXPECT_TRUE(same(before.marks(), after.marks()));
        EXPECT_TRUE(same(before.trend(), after.trend()));
        EXPECT_FALSE(same(before.card(), after.card())) << "the card turns";
        direct(after, turn_deg + 3);
        EXPECT_FALSE(same(before.marks(), after.marks())) << "control";
    }
}

TEST(CompassRose, AMagneticRoseTurnsTrueDirectionsByTheVariation) {
    flight::AircraftState state = scene_state(0, 0, 0);
    state[Signal::true_heading] = {};
    state[Signal::magnetic_heading] = {radians(100), test_support::kSceneNow};
    state[Signal::magnetic_variation] = {radians(7), test_support::kSceneNow};  // east
    Rose rose;
    rose.input = scene_input(state, 640, 480);
    EXPECT_NEAR(degrees(rose_angle_rad(rose.input, radians(130))), 23, 1e-9);
    EXPECT_EQ(rose_degrees(rose.input, radians(130)).view(), "123");
    EXPECT_NE(drawn_text(rose.whole(), test_support::day_color(SymbolRole::scale)).find("HDGMAG"), std::string::npos);
    rose.input.from_true_rad = 0;
    EXPECT_NEAR(degrees(rose_angle_rad(rose.input, radians(130))), 30, 1e-9) << "control";
}

TEST(CompassRose, WithoutVariationAnAmberTextReplacesTrueDirections) {
    Rose rose;
    EXPECT_EQ(drawn_text(rose.whole(), test_support::day_color(SymbolRole::caution)), "") << "control";
    rose.input.from_true_rad = std::nan("");
    EXPECT_TRUE(rose.marks().lines.empty());
    EXPECT_TRUE(rose.marks().triangles.empty());
    EXPECT_EQ(drawn_text(rose.whole(), test_support::day_color(SymbolRole::caution)), "VAR");
    EXPECT_EQ(drawn_text(rose.whole(), test_support::day_color(SymbolRole::selected)), "");
}

TEST(CompassRose, StaleValuesAreAmberWithTextAndFailedOnesCrossedOut) {
    const struct {
        Element element;
        const char* name;
        const char* value;
    } cases[] = {{Element::selected_heading, "SEL", "SEL270"},
                 {Element::waypoint_bearing, "BRG", "BRG310"},
                 {Element::turn_rate, "TURN", "TURN"}};
    for (const auto& c : cases) {
        Rose rose;
        rose.input.guidance.selected_heading_rad = radians(270);
        rose.input.guidance.waypoint_bearing_rad = radians(310);
        EXPECT_EQ(drawn_text(rose.whole(), test_support::day_color(SymbolRole::caution)), "");
        rose.input.decisions[c.element].show = ElementShow::flagged;
        EXPECT_EQ(drawn_text(rose.texts(), test_support::day_color(SymbolRole::caution)), std::string(c.value) + "STALE");
        rose.input.decisions[c.element].show = ElementShow::failed;
        const DrawnShapes failed = rose.texts();
        EXPECT_EQ(drawn_text(failed, test_support::day_color(SymbolRole::caution)), c.name);
        EXPECT_EQ(std::count_if(failed.lines.begin(), failed.lines.end(),
                                [](const DrawnLine& line) {
                                    return is_same_color(line.color, test_support::day_color(SymbolRole::warning));
                                }),
                  2);
        rose.input.decisions[c.element].show = ElementShow::absent;
        EXPECT_EQ(drawn_text(rose.texts(), test_support::day_color(SymbolRole::caution)), "");
        EXPECT_EQ(drawn_text(rose.texts(), test_support::day_color(SymbolRole::selected)).find(c.name), std::string::npos);
    }
}

TEST(CompassRose, ARecoveryPictureHasTheCardAlone) {
    Rose rose;
    rose.input.guidance.turn_rate_radps = 0.03;
    EXPECT_NE(drawn_text(rose.whole(), test_support::day_color(SymbolRole::selected)), "") << "control";
    rose.input.decisions.unusual_attitude = true;
    EXPECT_EQ(drawn_text(rose.whole(), test_support::day_color(SymbolRole::selected)), "");
    EXPECT_NE(drawn_text(rose.whole(), test_support::day_color(SymbolRole::scale)).find("047"), std::string::npos);
}

TEST(CompassRose, HostileDirectionsStayFinite) {
    for (const double hostile : {1e300, -1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
        Rose rose;
        rose.input.heading_rad = hostile;
        rose.input.track_rad = rose.input.guidance.selected_heading_rad = rose.input.guidance.waypoint_bearing_rad = hostile;
        rose.input.guidance.turn_rate_radps = rose.input.guidance.course_rad = rose.input.guidance.lateral_deviation = hostile;
        for (const DrawnLine& line : rose.whole().lines)
            ASSERT_TRUE(std::isfinite(line.from.x) && std::isfinite(line.from.y)) << hostile;
    }
}

}  // namespace
}  // namespace tedavis::draw::test_compass_rose
