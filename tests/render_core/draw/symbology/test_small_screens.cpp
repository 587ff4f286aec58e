// The smallest screens: every text is whole, every row is as high as its text, and values have room for all their digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/annunciations.hpp"
#include "render_core/draw/symbology/compass_rose.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/draw/symbology/vertical_tape.hpp"
#include "render_core/policy/notice_table.hpp"
#include "tests/support/draw/drawn_words.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_small_screens {
namespace {

using flight::NavigationSource;
using flight::Signal;
using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::DrawnWord;

struct SmallScreen {
    std::uint32_t width, height;
};
constexpr SmallScreen kSmallScreens[] = {{240, 320}, {320, 240}, {480, 272}};
constexpr std::size_t kVariants = 60;

template <class T, std::size_t N>
T pick(const T (&all)[N], std::size_t n) {
    return all[n % N];
}

/// Number `n` of many states, in which every element, source, receiver, phase and notice has its turn; the values are long ones.
SymbologyInput variant_input(const SmallScreen& screen, std::size_t n) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), screen.width, screen.height);
    constexpr ElementShow kShows[] = {ElementShow::normal, ElementShow::flagged, ElementShow::failed, ElementShow::substituted};
    constexpr Signal kHeadings[] = {Signal::true_heading, Signal::magnetic_heading, Signal::true_track},
                     kSpeeds[] = {Signal::indicated_airspeed, Signal::calibrated_airspeed, Signal::true_airspeed,
                                  Signal::ground_speed},
                     kAltitudes[] = {Signal::baro_altitude, Signal::true_altitude, Signal::standard_altitude},
                     kHeights[] = {Signal::radio_height, Signal::height_above_terrain};
    constexpr NavigationSource kReceivers[] = {NavigationSource::radio1, NavigationSource::radio2, NavigationSource::gnss,
                                               NavigationSource::none};
    constexpr flight::PhaseSource kSources[] = {flight::PhaseSource::switches, flight::PhaseSource::can,
                                                flight::PhaseSource::motion, flight::PhaseSource::held,
                                                flight::PhaseSource::none};
    const flight::FlightPhase phases[] = {flight::kTakeoffFirstClimb,  flight::kTakeoffSecondClimb,
                                          flight::kApproachDescent,    flight::kApproachFinal,
                                          flight::kGoAroundReplanning, flight::FlightPhase{flight::Scenario::cruise, 0}};
    for (std::size_t e = 0; e < policy::kElementCount; ++e) input.decisions[static_cast<Element>(e)].show = pick(kShows, n);
    input.decisions[Element::heading].source = pick(kHeadings, n / 4);
    input.decisions[Element::airspeed].source = pick(kSpeeds, n / 4);
    input.decisions[Element::altitude].source = pick(kAltitudes, n / 4);
    input.decisions[Element::ground_height].source = pick(kHeights, n / 4);
    input.guidance.navigation_source = pick(kReceivers, n / 4);
    input.phase = flight::stated_phase(pick(phases, n / 4), pick(kSources, n / 2));
    input.guidance.selected_altitude_m = 12'500 * base::kMetresPerFoot;
    input.guidance.selected_airspeed_mps = 128 * base::kMpsPerKnot;
    input.guidance.selected_vertical_speed_mps = -3540 * base::kMpsPerFootPerMinute;
    input.guidance.baro_minimum_m = 1343 * base::kMetresPerFoot;
    input.guidance.radio_minimum_m = 200 * base::kMetresPerFoot;
    input.ground_height_m = 986 * base::kMetresPerFoot;
    input.altitude_m = 12'340 * base::kMetresPerFoot;
    input.vertical_speed_mps = -3540 * base::kMpsPerFootPerMinute;
    input.wind_speed_mps = 112 * base::kMpsPerKnot;
    input.wind_from_rad = base::radians(241);
    input.outside_temperature_k = 250;
    input.wind_age = input.temperature_age = {45'000'000'000};
    input.decisions.notices.clear();
    const auto rows = policy::notice_rows();
    for (std::size_t k = 0; k <= n % 4; ++k) {
        const policy::NoticeRow& row = rows[(n + k * 7) % rows.size()];
        static_cast<void>(input.decisions.notices.try_push_back({row.level, row.text}));
    }
    for (const char* text : {"GENERATED FLIGHT", "NOT FOR NAVIGATION"})
        static_cast<void>(input.decisions.notices.try_push_back({policy::NoticeLevel::information, text}));
    if (n % 3 == 2) {
        input.over = SymbolGround::map;
        input.shown.map = true;
        input.map.px_per_m = 0.01;
        input.map.is_oblique = n % 2 == 0;
        input.map.is_flat = true;
        input.map.turn_rad = n % 5 == 0 ? 0 : base::radians(30);
    }
    return input;
}

struct Drawn {
    Layout layout;
    BatchStore store;
};
std::unique_ptr<Drawn> drawn(const SmallScreen& screen, const SymbologyInput& input) {
    auto made = std::make_unique<Drawn>();
    made->layout = make_layout(screen.width, screen.height, 96, legend_need(input));
    build_symbology(made->store.batch, input, made->layout);
    EXPECT_EQ(made->store.batch.use().refused, 0u);
    return made;
}

std::string name_of(const SmallScreen& screen) { return std::to_string(screen.width) + "x" + std::to_string(screen.height); }

std::string cut_word(const QuadBatch& batch) {
    for (const DrawnWord& word : test_support::drawn_words_of(batch))
        if (word.text.find("..") != std::string::npos) return word.text;
    return "";
}

TEST(SmallScreens, NoWordIsCut) {
    for (const SmallScreen& screen : kSmallScreens)
        for (std::size_t n = 0; n < kVariants; ++n)
            EXPECT_EQ(cut_word(drawn(screen, variant_input(screen, n))->store.batch), "") << name_of(screen) << " " << n;
    const auto control = drawn(kSmallScreens[0], variant_input(kSmallScreens[0], 0));
    const Painter painter(control->store.batch, control->layout);
    painter.fitted_text("HDG TRUE", {100, 100, 40, 12}, TextAnchor::left, 1, painter.color(SymbolRole::scale));
    EXPECT_NE(cut_word(control->store.batch), "");
}

/// A text on a dark plate that is lower than an em of it, or whose capitals reach beyond the plate.
std::string low_row(const QuadBatch& batch) {
    const test_support::DrawnShapes shapes = test_support::drawn_shapes_of(batch);
    const design::Color plate = test_support::day_color(SymbolRole::readout_ground);
    for (const test_support::DrawnGlyph& glyph : shapes.glyphs)
        for (const test_support::DrawnLine& line : shapes.lines) {
            const bool is_plate = test_support::is_same_color(line.color, plate) && line.width > 6 && line.from.y == line.to.y;
            if (!is_plate || glyph.at.x < line.from.x || glyph.at.x > line.to.x) continue;
            const float off = std::fabs(glyph.at.y - line.from.y), half = line.width / 2;
            const float capital = 0.5f * font_atlas().cap_height_em * glyph.em_px;
            const bool is_in_middle = off < 1 && std::isdigit(static_cast<unsigned char>(glyph.character)) != 0;
            if (is_in_middle && (line.width < glyph.em_px - 0.01f || off + capital > half))
                return std::string(1, glyph.character) + " in a row of " + std::to_string(line.width) + " at " +
                       std::to_string(line.from.x) + ", " + std::to_string(line.from.y);
        }
    return "";
}

TEST(SmallScreens, EveryPlateIsAsHighAsItsText) {
    for (const SmallScreen& screen : kSmallScreens)
        for (std::size_t n = 0; n < kVariants; ++n)
            EXPECT_EQ(low_row(drawn(screen, variant_input(screen, n))->store.batch), "") << name_of(screen) << " " << n;
    BatchStore store;
    const Layout layout = make_layout(240, 320, 96);
    Painter(store.batch, layout).plate({100, 100, 60, 8.4f}, "12500", 1, test_support::day_color(SymbolRole::selected));
    EXPECT_NE(low_row(store.batch), "") << "control";
}

TEST(SmallScreens, RowsWithoutAPlateAreAsHighAsTheirText) {
    for (const SmallScreen& screen : kSmallScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        const CompassRose rose = make_compass_rose(layout);
        for (const RoseSide side : {RoseSide::left, RoseSide::right})
            for (int row = 0; row < rose.rows; ++row) EXPECT_GE(rose.side_row(side, row).height, kMinText_px) << name_of(screen);
        for (const float height :
             {rose.readout.height, layout.information.height, layout.air.height / 2, layout.ground_height.height / 2,
              layout.baro_setting.height / 2, field_of_view_box(layout).height})
            EXPECT_GE(height, kMinText_px) << name_of(screen);
        const flight::PhaseStatus phase = flight::stated_phase(flight::kApproachFinal, flight::PhaseSource::motion);
        const policy::Notice notice{policy::NoticeLevel::warning, "TERRAIN AHEAD"};
        const AnnunciationPlan plan = plan_annunciations(layout.annunciations, layout.text_px, &phase, {&notice, 1});
        ASSERT_EQ(plan.fields.size(), 3u);
        for (const Annunciation& field : plan.fields) EXPECT_GE(field.box.height, kMinText_px) << name_of(screen);
        // The frame of a notice does not touch its capitals.
        EXPECT_GT(plan.fields.back().box.height - 3.5f * layout.stroke_px, font_atlas().cap_height_em * kMinText_px);
    }
    EXPECT_LT(1.2f * make_layout(240, 320, 96).text_px, kMinText_px) << "control: rows that only grow with the text are lower";
}

TEST(SmallScreens, ValuesHaveRoomForAllTheirDigits) {
    for (const SmallScreen& screen : kSmallScreens) {
        SymbologyInput input = variant_input(screen, 0);
        const auto made = drawn(screen, input);
        const std::string text = test_support::text_of(made->store.batch);
        EXPECT_NE(text.find("-3540"), std::string::npos) << name_of(screen);
        const Painter painter(made->store.batch, made->layout);
        VerticalTape altitude;
        altitude.box = made->layout.altitude;
        altitude.span = 1000;
        const TapeLayout parts = tape_layout(painter, altitude);
        EXPECT_GE(parts.readout.width - 2 * painter.stroke_px(), text_width_px("12340", kMinText_px)) << name_of(screen);
        const Rect& number =
            made->layout.vertical_speed_number.empty() ? made->layout.vertical_speed : made->layout.vertical_speed_number;
        EXPECT_GE(number.width - 2 * painter.stroke_px(), text_width_px("-3540", kMinText_px)) << name_of(screen);
        EXPECT_TRUE(made->layout.screen.contains(number));
        EXPECT_FALSE(made->layout.vertical_speed_number.overlaps(made->layout.baro_setting)) << name_of(screen);
        EXPECT_FALSE(made->layout.vertical_speed_number.overlaps(made->layout.heading)) << name_of(screen);
    }
    EXPECT_LT(6 * make_layout(240, 320, 96).text_px, text_width_px("12340", kMinText_px) + 6)
        << "control: the column by its text alone";
}

std::string information_of(const SmallScreen& screen, const std::vector<const char*>& notices) {
    SymbologyInput input = variant_input(screen, 0);
    input.decisions.notices.clear();
    for (const char* text : notices)
        static_cast<void>(input.decisions.notices.try_push_back({policy::NoticeLevel::information, text}));
    BatchStore store;
    const Layout layout = make_layout(screen.width, screen.height, 96);
    build_information(Painter(store.batch, layout), input);
    std::string text = test_support::text_of(store.batch);
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == ' '; }), text.end());
    return text;
}

TEST(SmallScreens, TheLastRowSaysThatTheDisplayIsNotForNavigationInWholeWords) {
    for (const SmallScreen& screen : kSmallScreens) {
        EXPECT_EQ(information_of(screen, {"NOT FOR NAVIGATION"}), "NOTFORNAVIGATION");
        for (const std::vector<const char*>& notices : {std::vector<const char*>{"GENERATED FLIGHT", "NOT FOR NAVIGATION"},
                                                        {"ORTHOGRAPHIC VIEW", "GENERATED FLIGHT", "NOT FOR NAVIGATION"},
                                                        {"NO TERRAIN IMAGE", "ORTHOGRAPHIC VIEW", "FLAT - NO RELIEF",
                                                         "GRAPHICS REDUCED", "GENERATED FLIGHT", "NOT FOR NAVIGATION"}}) {
            const std::string text = information_of(screen, notices);
            EXPECT_NE(text.find("NOTFORNAVIGATION"), std::string::npos) << name_of(screen) << " " << text;
            EXPECT_NE(text.find("GENERATED"), std::string::npos) << name_of(screen) << " " << text;
            EXPECT_EQ(text.find(".."), std::string::npos) << name_of(screen) << " " << text;
        }
    }
    EXPECT_EQ(information_of({240, 320}, {"NO TERRAIN IMAGE", "ORTHOGRAPHIC VIEW", "GENERATED FLIGHT", "NOT FOR NAVIGATION"})
                  .substr(0, 2),
              "+2");
}

}  // namespace
}  // namespace tedavis::draw::test_small_screens
