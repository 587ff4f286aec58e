#include "render_core/draw/symbology/course_deviation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/drawn_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_course_deviation {
namespace {

using base::degrees;
using base::radians;
using flight::NavigationSource;
using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::drawn_shapes_of;
using test_support::drawn_text;
using test_support::DrawnLine;
using test_support::DrawnShapes;
using test_support::is_same_color;
using test_support::kSceneNow;
using test_support::scene_state;

constexpr double kMile_m = base::kMetresPerNauticalMile;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1280, 720}, {480, 640}};
constexpr NavigationSource kSources[] = {NavigationSource::radio1, NavigationSource::radio2, NavigationSource::gnss};

bool is_radio(NavigationSource source) { return source != NavigationSource::gnss; }
design::Color color_of(NavigationSource source) {
    return is_radio(source) ? test_support::day_color(SymbolRole::engaged) : test_support::day_color(SymbolRole::gnss_course);
}

struct Course {
    explicit Course(NavigationSource source, Screen size = {640, 480}, double heading_deg = 100, double course_deg = 100)
        : screen(size), state(scene_state(heading_deg, 0, 0)) {
        set(Signal::navigation_source, static_cast<double>(source));
        for (const Signal course : {Signal::selected_course, Signal::desired_track}) set(course, radians(course_deg));
        conditions.phase = flight::stated_phase(flight::kApproachFinal, flight::PhaseSource::switches);
    }
    void set(Signal signal, double value) { state[signal] = {value, kSceneNow}; }
    /// Own ship so many dots right of the course, and above the path.
    void deviate(double right, double above) {
        for (const Signal signal : {Signal::ils1_localizer_deviation, Signal::ils2_localizer_deviation})
            set(signal, right * radians(2.5) / 2);
        for (const Signal signal : {Signal::ils1_glideslope_deviation, Signal::ils2_glideslope_deviation})
            set(signal, above * radians(0.7) / 2);
        set(Signal::cross_track_deviation, right * 0.3 * kMile_m / 2);
        set(Signal::gnss_vertical_deviation, above * 250 * base::kMetresPerFoot / 2);
    }
    [[nodiscard]] Layout layout() const { return make_layout(screen.width, screen.height, 96); }
    [[nodiscard]] CompassRose rose() const { return make_compass_rose(layout()); }
    [[nodiscard]] SymbologyInput input() const {
        SymbologyInput made = test_support::scene_input(state, screen.width, screen.height, conditions);
        if (change) change(made);
        return made;
    }
    [[nodiscard]] DrawnShapes course() const {
        BatchStore store;
        const Layout made = layout();
        build_course(Painter(store.batch, made), rose(), input());
        EXPECT_EQ(store.batch.use().refused, 0u);
        return drawn_shapes_of(store.batch);
    }
    [[nodiscard]] DrawnShapes texts() const {
        BatchStore store;
        const Layout made = layout();
        build_course_texts(Painter(store.batch, made), rose(), input());
        return drawn_shapes_of(store.batch);
    }
    [[nodiscard]] DrawnShapes path() const {
        BatchStore store;
        const Layout made = layout();
        build_vertical_deviation(Painter(store.batch, made), input());
        EXPECT_EQ(store.batch.use().refused, 0u);
        for (const QuadVertex& vertex : store.batch.vertices())
            EXPECT_TRUE(made.vertical_deviation.shrunk(-3.5f).contains(Point{vertex.x, vertex.y}));
        return drawn_shapes_of(store.batch);
    }

    Screen screen;
    flight::AircraftState state;
    policy::DisplayConditions conditions = test_support::scene_conditions();
    void (*change)(SymbologyInput&) = nullptr;
};

struct Place {
    double right = 0, ahead = 0;  ///< of the center, along the course's direction; in shares of the radius
};
Place place_of(const CompassRose& rose, Point at, double angle_rad) {
    const double x = static_cast<double>(at.x - rose.center.x), y = static_cast<double>(rose.center.y - at.y);
    return {(x * std::cos(angle_rad) - y * std::sin(angle_rad)) / static_cast<double>(rose.radius),
            (x * std::sin(angle_rad) + y * std::cos(angle_rad)) / static_cast<double>(rose.radius)};
}

/// The middles of the dots, from the circles' lines of 8 sides.
std::vector<Point> dots_of(const DrawnShapes& shapes, float max_side) {
    std::vector<DrawnLine> sides;
    for (const DrawnLine& line : shapes.lines)
        if (is_same_color(line.color, test_support::day_color(SymbolRole::scale)) &&
            std::hypot(line.to.x - line.from.x, line.to.y - line.from.y) < max_side)
            sides.push_back(line);
    std::vector<Point> dots;
    for (std::size_t first = 0; first + 7 < sides.size(); first += 8) {
        Point sum;
        for (std::size_t i = first; i < first + 8; ++i)
            sum.x += (sides[i].from.x + sides[i].to.x) / 16, sum.y += (sides[i].from.y + sides[i].to.y) / 16;
        dots.push_back(sum);
    }
    return dots;
}

/// The bar: the lines of this color that pass the center's height and are not the needle's.
std::vector<DrawnLine> bar_of(const DrawnShapes& shapes, const CompassRose& rose, design::Color color, double angle_rad) {
    std::vector<DrawnLine> bar;
    for (const DrawnLine& line : shapes.lines) {
        const Place a = place_of(rose, line.from, angle_rad), b = place_of(rose, line.to, angle_rad);
        if (is_same_color(line.color, color) && a.ahead * b.ahead < 0) bar.push_back(line);
    }
    return bar;
}

TEST(CourseDeviation, P22TheBarMovesToTheCourseAlongTwoDotsToEitherSide) {
    for (const Screen& screen : kScreens)
        for (const NavigationSource source : kSources)
            for (const double turn_deg : {0.0, 40.0, -75.0, 160.0})
                for (const double right : {-2.0, -1.0, 0.0, 0.5, 1.5}) {
                    Course course(source, screen, 100, 100 + turn_deg);
                    course.deviate(right, 0);
                    const CompassRose rose = course.rose();
                    const double angle = radians(turn_deg);
                    const DrawnShapes shapes = course.course();
                    const std::vector<Point> dots = dots_of(shapes, 0.2f * rose.mark_px + course.layout().stroke_px);
                    ASSERT_EQ(dots.size(), 4u);
                    const double spacing = place_of(rose, dots[2], angle).right;
                    EXPECT_GT(spacing * static_cast<double>(rose.radius), 5) << "pixels";
                    for (std::size_t i = 0; i < 4; ++i) {
                        const double expected[] = {-2, -1, 1, 2};
                        EXPECT_NEAR(place_of(rose, dots[i], angle).right, expected[i] * spacing, 0.01);
                        EXPECT_NEAR(place_of(rose, dots[i], angle).ahead, 0, 0.01);
                        EXPECT_TRUE(rose.card.contains(dots[i])) << "all dots are in sight";
                    }
                    const auto bar_right = [&](const DrawnShapes& drawn) {
                        const std::vector<DrawnLine> bar = bar_of(drawn, rose, color_of(source), angle);
                        EXPECT_EQ(bar.size(), 1u);
                        return bar.empty() ? 99 : place_of(rose, bar[0].from, angle).right / spacing;
                    };
                    EXPECT_NEAR(bar_right(shapes), -right, 0.02) << "own ship right of the course: bar to the left";
                    course.deviate(right + (right < 0 ? 0.4 : -0.4), 0);
                    EXPECT_GT(std::fabs(bar_right(course.course()) + right), 0.3) << "control: moved";
                }
}

TEST(CourseDeviation, P22TheNeedlePointsAlongTheCourse) {
    for (const Screen& screen : kScreens)
        for (const double course_deg : {100.0, 140.0, 25.0, 280.0}) {
            const Course course(NavigationSource::radio1, screen, 100, course_deg);
            const CompassRose rose = course.rose();
            const DrawnShapes shapes = course.course();
            ASSERT_EQ(shapes.triangles.size(), 1u) << "the head";
            Point tip = shapes.triangles[0].corners[0];
            const Place place = place_of(rose, tip, radians(course_deg - 100));
            EXPECT_NEAR(place.right, 0, 0.01);
            EXPECT_GT(place.ahead, 0.9);
            EXPECT_GT(std::fabs(place_of(rose, tip, radians(course_deg - 97)).right), 0.03) << "control: turned";
        }
    Course none(NavigationSource::radio1);
    none.state[Signal::selected_course] = {};
    EXPECT_TRUE(none.course().triangles.empty()) << "control: removed";
    EXPECT_EQ(bar_of(none.course(), none.rose(), test_support::day_color(SymbolRole::engaged), 0).size(), 1u)
        << "the deviation stays, upright";
}

TEST(CourseDeviation, P22BeyondTheLastDotTheBarStaysAndIsHollow) {
    for (const NavigationSource source : kSources) {
        Course course(source);
        const CompassRose rose = course.rose();
        const auto drawn = [&](double right) {
            course.deviate(right, right);
            return bar_of(course.course(), rose, color_of(source), 0);
        };
        EXPECT_EQ(drawn(1.9).size(), 1u);
        const std::vector<DrawnLine> far = drawn(7), farther = drawn(70);
        ASSERT_EQ(far.size(), 2u) << "the two long sides of an outline";
        EXPECT_EQ(far[0].from.x, farther[0].from.x);
        EXPECT_LT(far[0].from.x, rose.center.x);
        EXPECT_EQ(drawn(-7).size(), 2u);
        EXPECT_GT(drawn(-7)[0].from.x, rose.center.x);
        course.deviate(0, 7);
        EXPECT_TRUE(course.path().triangles.empty()) << "the pointer is hollow, too";
        course.deviate(0, 1.9);
        EXPECT_EQ(course.path().triangles.size(), 2u);
    }
}

double pointer_y(const DrawnShapes& shapes, design::Color color) {
    double sum = 0, count = 0;
    for (const test_support::DrawnTriangle& triangle : shapes.triangles)
        if (is_same_color(triangle.color, color))
            for (const Point& corner : triangle.corners) sum += static_cast<double>(corner.y), ++count;
    return sum / count;
}

TEST(CourseDeviation, P22TheVerticalPointerMovesToThePathAlongTwoDots) {
    for (const Screen& screen : kScreens)
        for (const NavigationSource source : kSources)
            for (const double above : {-2.0, -0.5, 0.0, 1.0, 2.0}) {
                Course course(source, screen);
                course.deviate(0, above);
                const Rect box = course.layout().vertical_deviation;
                const DrawnShapes shapes = course.path();
                const std::vector<Point> dots = dots_of(shapes, 0.35f * course.layout().text_px);
                ASSERT_EQ(dots.size(), 4u);
                const auto middle = static_cast<double>(box.center().y);
                const double spacing = static_cast<double>(dots[2].y) - middle;
                EXPECT_NEAR(static_cast<double>(dots[0].y), middle - 2 * spacing, 0.1);
                EXPECT_NEAR(static_cast<double>(dots[3].y), middle + 2 * spacing, 0.1);
                EXPECT_NEAR(pointer_y(shapes, color_of(source)), middle + above * spacing, 0.6)
                    << "own ship above the path: pointer below the middle";
                EXPECT_FALSE(pointer_y(shapes, test_support::day_color(SymbolRole::scale)) > 0) << "control: recolored";
            }
}

TEST(CourseDeviation, P22RadioHasADiamondAndGnssAChevron) {
    const auto is_symmetric = [](const DrawnShapes& shapes) {
        double left = 1e9, right = -1e9, sum = 0;
        for (const test_support::DrawnTriangle& triangle : shapes.triangles)
            for (const Point& corner : triangle.corners) {
                left = std::min(left, static_cast<double>(corner.x)), right = std::max(right, static_cast<double>(corner.x));
                sum += static_cast<double>(corner.x) / (3 * static_cast<double>(shapes.triangles.size()));
            }
        return std::fabs(sum - (left + right) / 2) < 0.1;
    };
    EXPECT_TRUE(is_symmetric(Course(NavigationSource::radio1).path()));
    EXPECT_FALSE(is_symmetric(Course(NavigationSource::gnss).path()));
}

TEST(CourseDeviation, P23TheSourceIsNamedAndColored) {
    const struct {
        NavigationSource source;
        const char *lateral, *vertical;
    } cases[] = {{NavigationSource::radio1, "CRS100LOC1", "GS"},
                 {NavigationSource::radio2, "CRS100LOC2", "GS"},
                 {NavigationSource::gnss, "CRS100GPSAPR", "GP"}};
    for (const Screen& screen : kScreens)
        for (const auto& c : cases) {
            const Course course(c.source, screen);
            const design::Color other = is_radio(c.source) ? test_support::day_color(SymbolRole::gnss_course)
                                                           : test_support::day_color(SymbolRole::engaged);
            EXPECT_EQ(drawn_text(course.texts(), color_of(c.source)), c.lateral) << screen.width;
            EXPECT_EQ(drawn_text(course.path(), color_of(c.source)), c.vertical);
            EXPECT_EQ(drawn_text(course.texts(), other) + drawn_text(course.path(), other), "") << "control: recolored";
            for (const DrawnShapes& shapes : {course.course(), course.path()}) {
                EXPECT_TRUE(std::any_of(shapes.triangles.begin(), shapes.triangles.end(),
                                        [&](const auto& t) { return is_same_color(t.color, color_of(c.source)); }));
                EXPECT_FALSE(std::any_of(shapes.triangles.begin(), shapes.triangles.end(),
                                         [&](const auto& t) { return is_same_color(t.color, other); }));
            }
        }
    const Course none(NavigationSource::none);
    EXPECT_TRUE(none.texts().glyphs.empty()) << "control: removed";
    EXPECT_TRUE(none.path().lines.empty());
}

TEST(CourseDeviation, TextsAreAtLeast11PixelsHighFrom480PixelsOn) {
    for (const Screen& screen : kScreens)
        for (const NavigationSource source : kSources)
            for (const ElementShow show : {ElementShow::normal, ElementShow::flagged}) {
                Course course(source, screen);
                if (show == ElementShow::flagged)
                    course.change = [](SymbologyInput& input) {
                        for (const Element element : {Element::lateral_deviation, Element::vertical_deviation, Element::course})
                            input.decisions[element].show = ElementShow::flagged;
                    };
                for (const DrawnShapes& shapes : {course.texts(), course.path()})
                    for (const test_support::DrawnGlyph& glyph : shapes.glyphs)
                        EXPECT_GE(glyph.em_px, 10.99f) << glyph.character << " " << screen.width;
            }
}

TEST(CourseDeviation, ScalesFollowTheSourceAndThePhase) {
    constexpr double kFoot_m = base::kMetresPerFoot;
    for (const NavigationSource source : {NavigationSource::radio1, NavigationSource::radio2}) {
        EXPECT_NEAR(degrees(deviation_scale(source, flight::kApproachFinal).lateral), 2.5, 1e-12);
        EXPECT_NEAR(degrees(deviation_scale(source, {flight::Scenario::cruise, 0}).vertical), 0.7, 1e-12);
    }
    const struct {
        flight::FlightPhase phase;
        double lateral_nm, vertical_ft;
        const char* name;
    } cases[] = {{{flight::Scenario::cruise, 0}, 2, 500, "ENR"},    {{flight::Scenario::unknown, 0}, 2, 500, "ENR"},
                 {{flight::Scenario::ground, 0}, 1, 500, "TERM"},   {flight::kTakeoffSecondClimb, 1, 500, "TERM"},
                 {flight::kApproachDescent, 1, 500, "TERM"},        {flight::kGoAroundAbort, 1, 500, "TERM"},
                 {flight::kApproachInitial, 0.3, 250, "APR"},       {flight::kApproachFinal, 0.3, 250, "APR"},
                 {{flight::Scenario::approach, 0}, 0.3, 250, "APR"}};
    for (const auto& c : cases) {
        const DeviationScale scale = deviation_scale(NavigationSource::gnss, c.phase);
        EXPECT_NEAR(scale.lateral / kMile_m, c.lateral_nm, 1e-12);
        EXPECT_NEAR(scale.vertical / kFoot_m, c.vertical_ft, 1e-9);
        EXPECT_EQ(scale.name, c.name);
    }
    EXPECT_EQ(deviation_scale(NavigationSource::none, flight::kApproachFinal).lateral, 0);
}

TEST(CourseDeviation, StaleDeviationsAreAmberWithTextAndFailedOnesCrossedOut) {
    for (const NavigationSource source : kSources) {
        Course course(source);
        EXPECT_EQ(drawn_text(course.texts(), test_support::day_color(SymbolRole::caution)) +
                      drawn_text(course.path(), test_support::day_color(SymbolRole::caution)),
                  "")
            << "control";
        course.change = [](SymbologyInput& input) {
            for (const Element element : {Element::lateral_deviation, Element::vertical_deviation, Element::course})
                input.decisions[element].show = ElementShow::flagged;
        };
        EXPECT_NE(drawn_text(course.texts(), test_support::day_color(SymbolRole::caution)).find("STALE"), std::string::npos);
        EXPECT_NE(drawn_text(course.path(), test_support::day_color(SymbolRole::caution)).find("STALE"), std::string::npos);
        EXPECT_EQ(bar_of(course.course(), course.rose(), test_support::day_color(SymbolRole::caution), 0).size(), 1u);
        course.change = [](SymbologyInput& input) {
            for (const Element element : {Element::lateral_deviation, Element::vertical_deviation, Element::course})
                input.decisions[element].show = ElementShow::failed;
        };
        EXPECT_EQ(drawn_text(course.texts(), test_support::day_color(SymbolRole::caution)), "CRS");
        EXPECT_EQ(drawn_text(course.course(), test_support::day_color(SymbolRole::caution)), is_radio(source) ? "LOC" : "GPS");
        EXPECT_EQ(drawn_text(course.path(), test_support::day_color(SymbolRole::caution)), is_radio(source) ? "GS" : "GP");
        EXPECT_TRUE(bar_of(course.course(), course.rose(), color_of(source), 0).empty());
        for (const DrawnShapes& shapes : {course.course(), course.path(), course.texts()})
            EXPECT_EQ(std::count_if(shapes.lines.begin(), shapes.lines.end(),
                                    [](const DrawnLine& line) {
                                        return is_same_color(line.color, test_support::day_color(SymbolRole::warning));
                                    }),
                      2);
    }
}

TEST(CourseDeviation, ALostStatementOfTheSourceCrossesOutWhatCameFromIt) {
    Course course(NavigationSource::gnss);
    course.state[Signal::navigation_source] = {3, kSceneNow - base::Duration::seconds(3600)};
    EXPECT_EQ(drawn_text(course.course(), test_support::day_color(SymbolRole::caution)), "NAV");
    EXPECT_EQ(drawn_text(course.path(), test_support::day_color(SymbolRole::caution)), "NAV");
    EXPECT_EQ(drawn_text(course.texts(), test_support::day_color(SymbolRole::gnss_course)), "");
}

TEST(CourseDeviation, WithoutVariationTheBarIsUprightAndHasNoArrow) {
    Course course(NavigationSource::radio1, {640, 480}, 100, 160);
    course.deviate(1, 0);
    course.change = [](SymbologyInput& input) { input.from_true_rad = std::nan(""); };
    EXPECT_TRUE(course.course().triangles.empty());
    const std::vector<DrawnLine> bar = bar_of(course.course(), course.rose(), test_support::day_color(SymbolRole::engaged), 0);
    ASSERT_EQ(bar.size(), 1u);
    EXPECT_NEAR(bar[0].from.x, bar[0].to.x, 0.01f);
    EXPECT_LT(bar[0].from.x, course.rose().center.x);
    EXPECT_EQ(drawn_text(course.texts(), test_support::day_color(SymbolRole::engaged)), "LOC1") << "no course";
}

TEST(CourseDeviation, TurningTheAircraftAndTheCourseTogetherMovesNothing) {
    for (const double turn_deg : {33.0, 180.0, 301.0}) {
        Course before(NavigationSource::gnss, {640, 480}, 20, 65),
            after(NavigationSource::gnss, {640, 480}, 20 + turn_deg, 65 + turn_deg);
        const auto largest_move = [&] {
            const DrawnShapes a = before.course(), b = after.course();
            EXPECT_EQ(a.lines.size(), b.lines.size());
            float largest = 0;
            for (std::size_t i = 0; i < std::min(a.lines.size(), b.lines.size()); ++i)
                largest =
                    std::max(largest, std::hypot(a.lines[i].from.x - b.lines[i].from.x, a.lines[i].from.y - b.lines[i].from.y));
            return largest;
        };
        EXPECT_LT(largest_move(), 0.05f);
        after.set(Signal::desired_track, radians(70 + turn_deg));
        EXPECT_GT(largest_move(), 1.0f) << "control";
    }
}

}  // namespace
}  // namespace tedavis::draw::test_course_deviation
