#include "render_core/draw/symbology/symbology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <set>
#include <string>
#include <tuple>

#include "render_core/draw/symbology/annunciations.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_symbology {
namespace {

using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::kSceneNow;
using test_support::Picture;
using test_support::scene_input;
using test_support::scene_state;
using test_support::text_of;

using Builder = void (*)(const Painter&, const SymbologyInput&);
struct Piece {
    const char* name;
    Builder build;
    Rect Layout::*box;
    Element element;
    double SymbologyInput::*value;
};
constexpr Piece kPieces[] = {
    {"attitude", build_attitude, &Layout::attitude, Element::attitude, &SymbologyInput::roll_rad},
    {"flight_path", build_flight_path, &Layout::attitude, Element::flight_path, &SymbologyInput::velocity_east_mps},
    {"airspeed", build_airspeed, &Layout::airspeed, Element::airspeed, &SymbologyInput::airspeed_mps},
    {"altitude", build_altitude, &Layout::altitude, Element::altitude, &SymbologyInput::altitude_m},
    {"vertical_speed", build_vertical_speed, &Layout::vertical_speed, Element::vertical_speed,
     &SymbologyInput::vertical_speed_mps},
    {"heading", build_heading, &Layout::heading, Element::heading, &SymbologyInput::heading_rad},
    {"baro_setting", build_baro_setting, &Layout::baro_setting, Element::baro_setting, &SymbologyInput::baro_setting_pa},
    {"ground_height", build_ground_height, &Layout::ground_height, Element::ground_height, &SymbologyInput::ground_height_m},
};
constexpr ElementShow kShows[] = {ElementShow::normal, ElementShow::substituted, ElementShow::flagged, ElementShow::failed,
                                  ElementShow::absent};

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1920, 1080}, {768, 1024}, {320, 240}, {240, 320}};

/// Every vertex whose quad can colour anything lies in the box or in the other one, but for the pixel in which edges fade out.
void expect_inside(const QuadBatch& batch, const Rect& box, const Rect& other, const std::string& what) {
    const Rect room = box.shrunk(-2.5f), other_room = other.empty() ? other : other.shrunk(-2.5f);
    for (const QuadVertex& vertex : batch.vertices())
        ASSERT_TRUE(room.contains(Point{vertex.x, vertex.y}) || other_room.contains(Point{vertex.x, vertex.y}))
            << what << " at " << vertex.x << ", " << vertex.y;
}

bool has_color(const QuadBatch& batch, design::Color color) {
    return std::any_of(batch.vertices().begin(), batch.vertices().end(), [&](const QuadVertex& v) {
        return v.rgba[0] == color.red && v.rgba[1] == color.green && v.rgba[2] == color.blue;
    });
}

std::vector<QuadVertex> drawn(const Piece& piece, const SymbologyInput& input, const Layout& layout) {
    BatchStore store;
    piece.build(Painter(store.batch, layout), input);
    EXPECT_EQ(store.batch.use().refused, 0u);
    return {store.batch.vertices().begin(), store.batch.vertices().end()};
}
bool same(const std::vector<QuadVertex>& a, const std::vector<QuadVertex>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const QuadVertex& x, const QuadVertex& y) {
               return x.x == y.x && x.y == y.y && x.u == y.u && x.v == y.v && std::equal(x.rgba, x.rgba + 4, y.rgba);
           });
}

TEST(Symbology, EveryPieceStaysInItsBoxInEveryPicture) {
    for (const Screen& screen : kScreens)
        for (double pitch : {-85.0, -25.0, 0.0, 12.0, 60.0, 90.0})
            for (double roll : {-180.0, -90.0, -65.0, 0.0, 30.0, 90.0})
                for (ElementShow show : kShows) {
                    SymbologyInput input = scene_input(scene_state(3, pitch, roll), screen.width, screen.height);
                    input.shown.units = pitch < 0 ? base::DisplayUnits::metric : base::DisplayUnits::feet_and_knots;
                    const Layout layout = make_layout(screen.width, screen.height, 96);
                    for (const Piece& piece : kPieces) {
                        input.decisions[piece.element].show = show;
                        BatchStore store;
                        piece.build(Painter(store.batch, layout), input);
                        // What is conformal is drawn wherever it is seen: through the rose, the horizon's line above, too.
                        const Rect& box = layout.*piece.box;
                        const Rect seen{0, 0, layout.screen.width, layout.heading.bottom()};
                        const bool is_conformal = piece.box == &Layout::attitude;
                        const Rect number = piece.box == &Layout::vertical_speed ? layout.vertical_speed_number : Rect{};
                        expect_inside(store.batch, is_conformal ? seen : box, number, piece.name);
                        EXPECT_EQ(store.batch.use().refused, 0u);
                    }
                }
}

TEST(Symbology, AFailedOrAbsentElementNeverDependsOnItsValue) {
    for (const Piece& piece : kPieces)
        for (ElementShow show : {ElementShow::failed, ElementShow::absent}) {
            SymbologyInput input = scene_input(scene_state(3, 5, 5), 640, 480);
            input.decisions[Element::radio_minimum].show = ElementShow::absent;  // a value of its own in that box
            input.decisions[piece.element].show = show;
            const Layout layout = make_layout(640, 480, 96);
            const auto before = drawn(piece, input, layout);
            input.*piece.value += 0.7;
            EXPECT_TRUE(same(before, drawn(piece, input, layout))) << piece.name;
            EXPECT_EQ(before.empty(), show == ElementShow::absent) << piece.name;
            // Negative control: shown, it does depend on it.
            input.decisions[piece.element].show = ElementShow::normal;
            const auto shown = drawn(piece, input, layout);
            input.*piece.value += 50;
            EXPECT_FALSE(same(shown, drawn(piece, input, layout))) << piece.name;
        }
}

TEST(Symbology, FailuresAreRedWithTextAndStaleValuesAmberWithText) {
    for (const Piece& piece : kPieces) {
        SymbologyInput input = scene_input(scene_state(3, 5, 5), 640, 480);
        const Layout layout = make_layout(640, 480, 96);
        BatchStore normal, failed, stale;
        piece.build(Painter(normal.batch, layout), input);
        EXPECT_FALSE(has_color(normal.batch, test_support::day_color(SymbolRole::warning))) << piece.name;
        EXPECT_FALSE(has_color(normal.batch, test_support::day_color(SymbolRole::caution))) << piece.name;
        input.decisions[piece.element].show = ElementShow::failed;
        piece.build(Painter(failed.batch, layout), input);
        EXPECT_TRUE(has_color(failed.batch, test_support::day_color(SymbolRole::warning))) << piece.name;
        EXPECT_FALSE(text_of(failed.batch).empty()) << piece.name;
        if (piece.element == Element::flight_path) continue;  // has no last value worth showing
        input.decisions[piece.element].show = ElementShow::flagged;
        input.decisions[Element::radio_minimum].show = ElementShow::absent;  // it takes room from the label of the height
        piece.build(Painter(stale.batch, layout), input);
        EXPECT_TRUE(has_color(stale.batch, test_support::day_color(SymbolRole::caution))) << piece.name;
        EXPECT_NE(text_of(stale.batch).find("STALE"), std::string::npos) << piece.name;
    }
}

/// Amber says that it is stale; radio height and height above the terrain database must not be confused.
TEST(Symbology, AStaleHeightBesideTheDecisionHeightKeepsItsSource) {
    SymbologyInput input = scene_input(scene_state(3, 5, 5), 640, 480);
    const Layout layout = make_layout(640, 480, 96);
    for (const auto& [source, label] :
         {std::pair{flight::Signal::radio_height, "RA"}, {flight::Signal::height_above_terrain, "AGL"}}) {
        input.decisions[Element::ground_height] = {ElementShow::flagged, source};
        input.decisions[Element::radio_minimum].show = ElementShow::normal;
        BatchStore store;
        build_ground_height(Painter(store.batch, layout), input);
        EXPECT_NE(text_of(store.batch).find(label), std::string::npos) << text_of(store.batch);
        EXPECT_TRUE(has_color(store.batch, test_support::day_color(SymbolRole::caution))) << label;
    }
}

TEST(Symbology, NumbersAreInTheCockpitsUnitsWithTheirSource) {
    const SymbologyInput input = scene_input(scene_state(47.2, 0, 0), 640, 480);
    const Layout layout = make_layout(640, 480, 96);
    const std::pair<Builder, std::vector<std::string>> expected[] = {{build_airspeed, {"IASKT", "128"}},
                                                                     {build_altitude, {"BAROFT", "4520"}},
                                                                     {build_vertical_speed, {"FT/MIN", "-500"}},
                                                                     {build_heading, {"HDGTRUE", "047"}},
                                                                     {build_baro_setting, {"QNHHPA", "1009"}},
                                                                     {build_ground_height, {"RAFT", "1240"}},
                                                                     {build_annunciations, {"APPROACHFINAL", "PHASEBYSWITCH"}}};
    for (const auto& [build, texts] : expected) {
        BatchStore store;
        build(Painter(store.batch, layout), input);
        for (const std::string& text : texts)
            EXPECT_NE(text_of(store.batch).find(text), std::string::npos) << text << " in " << text_of(store.batch);
    }
}

/// Of one instant in both systems: each names its own units only.
TEST(Symbology, AllIsWrittenInTheUnitsOfTheDesign) {
    const std::vector<std::string> feet{"IASKT", "BAROFT", "FT/MIN", "RAFT"}, metres{"IASKM/H", "BAROM1", "M/S", "RAM3"};
    for (const base::DisplayUnits units : {base::DisplayUnits::feet_and_knots, base::DisplayUnits::metric}) {
        SymbologyInput input = scene_input(scene_state(47.2, 0, 0), 1024, 768);
        input.shown.units = units;
        BatchStore store;
        build_symbology(store.batch, input, make_layout(1024, 768, 96));
        const std::string text = text_of(store.batch);
        const bool is_metric = units == base::DisplayUnits::metric;
        for (const std::string& label : is_metric ? metres : feet)
            EXPECT_NE(text.find(label), std::string::npos) << label << " in " << text;
        for (const std::string& label : is_metric ? feet : metres)
            EXPECT_EQ(text.find(label), std::string::npos) << label << " in " << text;
    }
}

TEST(Symbology, FastJetsHaveTheirSpeedInEitherUnit) {
    SymbologyInput input = scene_input(scene_state(47, 0, 0), 640, 480);
    input.airspeed_mps = 300;
    input.wind_speed_mps = 60;
    input.wind_from_rad = base::radians(265);
    for (const auto& [units, speed, wind] : {std::tuple{base::DisplayUnits::feet_and_knots, "583", "265/117KT"},
                                             {base::DisplayUnits::metric, "1080", "265/216KM/H"}}) {
        input.shown.units = units;
        BatchStore store;
        build_airspeed(Painter(store.batch, make_layout(640, 480, 96)), input);
        EXPECT_NE(text_of(store.batch).find(speed), std::string::npos) << text_of(store.batch);
        BatchStore air;
        build_air(Painter(air.batch, make_layout(1024, 768, 96)), input);
        EXPECT_NE(text_of(air.batch).find(wind), std::string::npos) << text_of(air.batch);
    }
}

/// 128 kt, 4520 ft, -500 ft/min, 1240 ft above the ground.
TEST(Symbology, MetricNumbersAreThoseOfTheSameValues) {
    SymbologyInput input = scene_input(scene_state(47.2, 0, 0), 640, 480);
    input.shown.units = base::DisplayUnits::metric;
    const Layout layout = make_layout(640, 480, 96);
    const std::pair<Builder, std::vector<std::string>> expected[] = {{build_airspeed, {"IASKM/H", "237"}},
                                                                     {build_altitude, {"BAROM", "1380"}},
                                                                     {build_vertical_speed, {"M/S", "-2.5"}},
                                                                     {build_ground_height, {"RAM", "378"}}};
    for (const auto& [build, texts] : expected) {
        BatchStore store;
        build(Painter(store.batch, layout), input);
        for (const std::string& text : texts)
            EXPECT_NE(text_of(store.batch).find(text), std::string::npos) << text << " in " << text_of(store.batch);
    }
}

TEST(Symbology, SubstitutesNameTheirSource) {
    flight::AircraftState state = scene_state(47, 0, 0);
    for (Signal lost : {Signal::true_heading, Signal::magnetic_heading, Signal::baro_altitude, Signal::true_altitude,
                        Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed})
        state[lost] = {};
    state[Signal::ground_speed] = {100 * base::kMpsPerKnot, kSceneNow};
    const SymbologyInput input = scene_input(state, 640, 480);
    BatchStore store;
    build_symbology(store.batch, input, make_layout(640, 480, 96));
    const std::string text = text_of(store.batch);
    for (const char* label : {"TRKTRUE", "HDG", "GPSMSLFT", "GSKT", "4520"})  // 1380 m, to the twenty
        EXPECT_NE(text.find(label), std::string::npos) << label << " in " << text;
}

TEST(Symbology, HeadingRoundsToTheCircle) {
    const Layout layout = make_layout(640, 480, 96);
    const std::pair<double, const char*> cases[] = {{359.6, "000"}, {359.4, "359"}, {0.4, "000"}, {0.6, "001"}, {180, "180"}};
    for (const auto& [degrees, text] : cases) {
        BatchStore store;
        build_heading(Painter(store.batch, layout), scene_input(scene_state(degrees, 0, 0), 640, 480));
        EXPECT_NE(text_of(store.batch).find(text), std::string::npos) << degrees;
    }
}

TEST(Symbology, TheHorizonLineLiesOnTheHorizontal) {
    for (double pitch : {-10.0, 0.0, 12.0})
        for (double roll : {-60.0, -25.0, 0.0, 45.0, 60.0}) {
            const flight::AircraftState state = scene_state(77, pitch, roll);
            SymbologyInput input = scene_input(state, 640, 480);
            const Layout layout = make_layout(640, 480, 96);
            BatchStore store;
            build_attitude(Painter(store.batch, layout), input);
            Picture picture(640, 480, {0, 0, 0});
            rasterize(store.batch, picture);
            // Directions on the horizontal, through the Earth module's frames.
            const glm::dmat3 to_body =
                glm::transpose(earth::body_axes(0, 0, base::radians(77), base::radians(pitch), base::radians(roll)));
            const glm::dmat3 ned = earth::north_east_down(0, 0);
            const double focal = 320 / std::tan(base::radians(30));
            int checked = 0;
            for (double azimuth = 40; azimuth < 114; azimuth += 0.5) {
                const glm::dvec3 body =
                    to_body * (ned[0] * std::cos(base::radians(azimuth)) + ned[1] * std::sin(base::radians(azimuth)));
                const double x = 320 + focal * body.y / body.x, y = 240 + focal * body.z / body.x;
                if (!conformal_box(layout).shrunk(3).contains(Point{static_cast<float>(x), static_cast<float>(y)})) continue;
                int brightest = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        brightest = std::max<int>(brightest, picture.at(static_cast<int>(x) + dx, static_cast<int>(y) + dy)
                                                                 .red);  // white, or the yellow symbol over it
                EXPECT_GT(brightest, 100) << pitch << " " << roll << " azimuth " << azimuth;
                ++checked;
            }
            EXPECT_GT(checked, 20) << pitch << " " << roll;
        }
}

TEST(Symbology, TheFlightPathLiesOnTheDirectionOfMotion) {
    flight::AircraftState state = scene_state(30, 4, 20);
    state.own_ship.velocity_north_mps = 60 * std::cos(base::radians(25));
    state.own_ship.velocity_east_mps = 60 * std::sin(base::radians(25));
    state.own_ship.velocity_up_mps = -3;
    const SymbologyInput input = scene_input(state, 1024, 768);
    BatchStore store;
    build_flight_path(Painter(store.batch, make_layout(1024, 768, 96)), input);
    double sum_x = 0, sum_y = 0, count = 0;  // the circle's and wings' middle; the fin pulls up a little
    for (const QuadVertex& vertex : store.batch.vertices())
        sum_x += static_cast<double>(vertex.x), sum_y += static_cast<double>(vertex.y), ++count;
    const glm::dmat3 to_body = glm::transpose(earth::body_axes(0, 0, base::radians(30), base::radians(4), base::radians(20)));
    const glm::dmat3 ned = earth::north_east_down(0, 0);
    const glm::dvec3 body =
        to_body * (ned[0] * state.own_ship.velocity_north_mps + ned[1] * state.own_ship.velocity_east_mps + ned[2] * 3.0);
    const double focal = 512 / std::tan(base::radians(30));
    EXPECT_NEAR(sum_x / count, 512 + focal * body.y / body.x, 0.5);
    EXPECT_NEAR(sum_y / count, 384 + focal * body.z / body.x, 2.5);
}

TEST(Symbology, TheHorizonIsNeverLostFromSight) {
    for (const Screen& screen : kScreens)
        for (double pitch = -88; pitch <= 88; pitch += 8)
            for (double roll = -180; roll <= 180; roll += 30) {
                const SymbologyInput input = scene_input(scene_state(10, pitch, roll), screen.width, screen.height);
                const Layout layout = make_layout(screen.width, screen.height, 96);
                BatchStore store;
                build_attitude(Painter(store.batch, layout), input);
                // Either the line at zero elevation is seen, behind the rose too, or a strip of the other side is.
                const Rect seen{0, 0, layout.screen.width, layout.heading.bottom()};
                int line_inside = 0;
                for (double azimuth = -90; azimuth <= 90; azimuth += 0.5) {
                    const ProjectedPoint at = project(input.view, direction_of(base::radians(10 + azimuth), 0));
                    line_inside += at.in_front && seen.contains(at.at) ? 1 : 0;
                }
                const bool strip = has_color(store.batch, input.sky) || has_color(store.batch, input.ground);
                EXPECT_TRUE(line_inside > 0 || strip) << screen.width << " " << pitch << " " << roll;
                EXPECT_FALSE(line_inside > 20 && strip) << "two horizons: " << screen.width << " " << pitch << " " << roll;
            }
    // Nose far up: the strip is ground; nose far down: sky.
    BatchStore up, down;
    const SymbologyInput high = scene_input(scene_state(10, 70, 0), 640, 480),
                         low = scene_input(scene_state(10, -70, 0), 640, 480);
    build_attitude(Painter(up.batch, make_layout(640, 480, 96)), high);
    build_attitude(Painter(down.batch, make_layout(640, 480, 96)), low);
    EXPECT_TRUE(has_color(up.batch, high.ground));
    EXPECT_FALSE(has_color(up.batch, high.sky));
    EXPECT_TRUE(has_color(down.batch, low.sky));
    EXPECT_FALSE(has_color(down.batch, low.ground));
}

TEST(Symbology, TheStripStandsInOnlyForAHorizonThatIsOutOfSight) {
    const Layout layout = make_layout(1024, 768, 96);
    const double focal = 512 / std::tan(base::radians(30));
    // Past the ladder, behind the rose, and above the attitude: still in the picture.
    for (const double pitch : {14.0, 16.5, 18.5, -19.5}) {
        const SymbologyInput input = scene_input(scene_state(10, pitch, 0), 1024, 768);
        BatchStore store;
        build_attitude(Painter(store.batch, layout), input);
        EXPECT_FALSE(has_color(store.batch, input.ground) || has_color(store.batch, input.sky)) << pitch;
        const double y = 384 + focal * std::tan(base::radians(pitch));
        int across = 0;  // corners of the horizon's line over the whole width
        for (const QuadVertex& vertex : store.batch.vertices())
            if (std::abs(static_cast<double>(vertex.y) - y) < 3 && std::abs(vertex.x - 512) > 220) ++across;
        EXPECT_GE(across, 4) << pitch;
    }
    for (const double pitch : {23.0, -26.0}) {
        const SymbologyInput input = scene_input(scene_state(10, pitch, 0), 1024, 768);
        BatchStore store;
        build_attitude(Painter(store.batch, layout), input);
        EXPECT_EQ(has_color(store.batch, input.ground), pitch > 0) << pitch;
        EXPECT_EQ(has_color(store.batch, input.sky), pitch < 0) << pitch;
    }
}

// A rung that is cut where the ladder ends would be thinner than the others, and its number lower.
TEST(Symbology, RungsOfThePitchLadderAreWholeOrAbsent) {
    const Layout layout = make_layout(640, 480, 96);
    const design::Color scale = test_support::day_color(SymbolRole::scale);
    std::set<std::size_t> counts;
    for (double pitch = -20; pitch <= 20; pitch += 0.1) {
        BatchStore store;
        build_attitude(Painter(store.batch, layout), scene_input(scene_state(10, pitch, 0), 640, 480));
        float low_rung = 1e9f, high_rung = 0, low_digit = 1e9f, high_digit = 0;
        std::size_t rungs = 0;
        for (const test_support::BatchShape& shape : test_support::shapes_of(store.batch)) {
            if (!shape.has(scale) || shape.is_rim) continue;
            const float height = shape.bounds.height;
            if (shape.letter == '0') low_digit = std::min(low_digit, height), high_digit = std::max(high_digit, height);
            if (shape.letter != 0 || shape.bounds.width < 2 * layout.text_px || shape.bounds.width > 8 * layout.text_px) continue;
            low_rung = std::min(low_rung, height), high_rung = std::max(high_rung, height);
            ++rungs;
        }
        EXPECT_LT(high_rung, low_rung + 0.02f) << pitch;
        EXPECT_LT(high_digit, low_digit + 0.02f) << pitch;
        counts.insert(rungs);
    }
    EXPECT_GE(*counts.begin(), 1u);
    EXPECT_GE(counts.size(), 2u) << "control: rungs come and go";
}

TEST(Symbology, ChevronsAppearOnlyInUnusualAttitudes) {
    const Layout layout = make_layout(640, 480, 96);
    BatchStore steep, calm;
    build_attitude(Painter(steep.batch, layout), scene_input(scene_state(10, 40, 0), 640, 480));
    build_attitude(Painter(calm.batch, layout), scene_input(scene_state(10, 20, 0), 640, 480));
    EXPECT_TRUE(has_color(steep.batch, test_support::day_color(SymbolRole::warning)));
    EXPECT_FALSE(has_color(calm.batch, test_support::day_color(SymbolRole::warning)));
}

TEST(Symbology, RightBankTurnsTheSkyPointerLeft) {
    const Layout layout = make_layout(640, 480, 96);
    for (double roll : {-30.0, 30.0}) {
        BatchStore store;
        build_attitude(Painter(store.batch, layout), scene_input(scene_state(10, 0, roll), 640, 480));
        double lowest_y = 1e9, x_of_lowest = 0;
        for (const QuadVertex& v : store.batch.vertices())
            if (v.rgba[0] == test_support::day_color(SymbolRole::reference).red &&
                v.rgba[1] == test_support::day_color(SymbolRole::reference).green &&
                v.rgba[2] == test_support::day_color(SymbolRole::reference).blue && static_cast<double>(v.y) < lowest_y)
                lowest_y = static_cast<double>(v.y), x_of_lowest = static_cast<double>(v.x);
        EXPECT_EQ(x_of_lowest<320, roll> 0);
    }
}

TEST(Symbology, NothingIsRefusedOverManyStatesAndHostileValues) {
    std::uint32_t random = 7;
    const auto next = [&](std::uint32_t below) { return (random = random * 1664525u + 1013904223u, (random >> 12) % below); };
    const double hostile[] = {0, 1e300, -1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                              3, -3,    7};
    std::uint64_t most = 0;
    for (int round = 0; round < 3000; ++round) {
        flight::AircraftState state = scene_state(next(360), next(180) - 90.0, next(360) - 180.0);
        for (std::size_t i = 0; i < flight::kSignalCount; ++i) {
            if (next(6) == 0) state.signals[i] = {};
            if (next(6) == 0) state.signals[i] = {state.signals[i].value_or(0), kSceneNow - base::Duration::milliseconds(700)};
            if (round % 3 == 0 && next(8) == 0) state.signals[i] = {hostile[next(8)], kSceneNow};
        }
        if (round % 3 == 1) state.own_ship.velocity_up_mps = hostile[next(8)];
        const Screen screen = kScreens[next(4)];
        BatchStore store;
        build_symbology(store.batch, scene_input(state, screen.width, screen.height),
                        make_layout(screen.width, screen.height, 96));
        EXPECT_EQ(store.batch.use().refused, 0u);
        most = std::max(most, store.batch.use().high_water);
        for (const QuadVertex& v : store.batch.vertices()) ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y));
    }
    EXPECT_LT(most, kSymbologyVertices * 3 / 4);
}

TEST(Symbology, ADesignSwitchesPiecesOffButNeverTheNotices) {
    SymbologyInput input = scene_input(scene_state(10, 0, 0), 640, 480);
    input.shown = {
        false, false, false, false, false, false, false, false, false, false, false, false, base::DisplayUnits::feet_and_knots};
    BatchStore store;
    build_symbology(store.batch, input, make_layout(640, 480, 96));
    EXPECT_EQ(text_of(store.batch), "GENERATEDFLIGHT\xB7NOTFORNAVIGATION");
}

TEST(Symbology, PicturesAreTheSameForTheSameInput) {
    const SymbologyInput input = scene_input(scene_state(10, 3, -20), 640, 480);
    const Layout layout = make_layout(640, 480, 96);
    BatchStore once, twice;
    build_symbology(once.batch, input, layout);
    build_symbology(twice.batch, input, layout);
    build_symbology(twice.batch, input, layout);
    EXPECT_TRUE(same({once.batch.vertices().begin(), once.batch.vertices().end()},
                     {twice.batch.vertices().begin(), twice.batch.vertices().end()}));
}

}  // namespace
}  // namespace tedavis::draw::test_symbology
