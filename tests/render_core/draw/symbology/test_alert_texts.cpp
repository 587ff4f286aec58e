// The table of red and amber texts (render_core/policy/element_texts.hpp) against what the symbology draws, both ways: every
// element in every state that the failure policy decides, with every source, with each receiver, in 3D and on the map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "render_core/draw/symbology/short_words.hpp"
#include "render_core/policy/element_texts.hpp"
#include "render_core/policy/notice_table.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_alert_texts {
namespace {

using flight::NavigationSource;
using flight::Signal;
using policy::Element;
using policy::ElementShow;
using policy::TextColor;
using test_support::BatchShape;

/// "airspeed flagged amber IASKT".
using Found = std::set<std::string>;

/// Without spaces, and "#" for every number with its sign.
std::string canonical(std::string_view text) {
    std::string plain;
    for (const char c : text) {
        const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
        if (c == ' ' || c == '\xC2') continue;  // the font has one byte for a degree sign
        if (!is_digit && c != '#') {
            plain += c;
            continue;
        }
        const bool goes_on = plain.size() >= 2 && plain.back() == '.' && plain[plain.size() - 2] == '#';
        if (goes_on)
            plain.pop_back();
        else if (!plain.empty() && (plain.back() == '-' || plain.back() == '+'))
            plain.back() = '#';
        else if (plain.empty() || plain.back() != '#')
            plain += '#';
    }
    return plain;
}

std::string line_of(std::string_view place, ElementShow show, TextColor color, std::string_view text) {
    return std::string(place) + " " + std::string(name_of(show)) + (color == TextColor::red ? " red " : " amber ") +
           canonical(text);
}

Found lines_of(base::Span<const policy::ElementText> rows) {
    Found lines;
    for (const policy::ElementText& row : rows) {
        std::istringstream texts{std::string(row.texts)};
        for (std::string text; std::getline(texts, text, ',');) lines.insert(line_of(row.place, row.show, row.color, text));
    }
    return lines;
}

Found missing_in(const Found& present, const Found& wanted) {
    Found missing;
    std::set_difference(wanted.begin(), wanted.end(), present.begin(), present.end(), std::inserter(missing, missing.end()));
    return missing;
}

struct AlertText {
    TextColor color;
    std::string text;
};

/// Glyphs of a text follow each other in the batch, closely, in one color.
class AlertTexts {
public:
    explicit AlertTexts(const QuadBatch& batch) {
        for (const BatchShape& shape : test_support::shapes_of(batch)) add(shape);
    }
    [[nodiscard]] const std::vector<AlertText>& all() const { return texts_; }

private:
    void add(const BatchShape& shape) {
        const bool is_red = shape.has(test_support::day_color(SymbolRole::warning)),
                   is_glyph = shape.letter != 0 && !shape.is_rim;
        if (!is_glyph || !(is_red || shape.has(test_support::day_color(SymbolRole::caution)))) {
            goes_on_ = false;
            return;
        }
        const TextColor color = is_red ? TextColor::red : TextColor::amber;
        const Point at = shape.bounds.center();
        const float size = std::max(shape.bounds.width, shape.bounds.height), reach = 1.6f * std::max(size, size_);
        if (!goes_on_ || texts_.back().color != color || std::hypot(at.x - last_.x, at.y - last_.y) > reach) {
            texts_.push_back({color, ""});
            size_ = 0;
        }
        size_ = std::max(size, size_);
        texts_.back().text += shape.letter;
        last_ = at;
        goes_on_ = true;
    }

    std::vector<AlertText> texts_;
    bool goes_on_ = false;
    Point last_;
    float size_ = 0;  ///< of the text's largest glyph
};

/// One element in one state, drawn in one of the contexts.
struct Case {
    Element element;
    ElementShow show;
    Signal source;
};
struct Context {
    NavigationSource receiver;
    bool is_receiver_lost;
    flight::FlightPhase phase;
    SymbolGround over;
    bool is_alone;  ///< what other elements do not need is absent; calm wind, and a turned map
};

std::vector<Context> contexts() {
    std::vector<Context> all;
    for (const SymbolGround over : {SymbolGround::perspective, SymbolGround::map})
        for (const bool is_alone : {false, true}) {
            const auto add = [&](NavigationSource receiver, bool is_lost, const flight::FlightPhase& phase) {
                all.push_back({receiver, is_lost, phase, over, is_alone});
            };
            add(NavigationSource::radio1, false, flight::kApproachFinal);
            add(NavigationSource::radio2, false, flight::kApproachFinal);
            add(NavigationSource::radio1, true, flight::kApproachFinal);
            add(NavigationSource::gnss, false, flight::kApproachFinal);
            add(NavigationSource::gnss, false, flight::kTakeoffFirstClimb);
            add(NavigationSource::gnss, false, flight::FlightPhase{flight::Scenario::cruise, 0});
        }
    return all;
}

/// The group whose sources the element shows; not_shown for those of two signals or of none.
policy::SignalGroup group_of(Element element) {
    using policy::SignalGroup;
    switch (element) {
        case Element::heading: return SignalGroup::view_heading;
        case Element::airspeed: return SignalGroup::airspeed;
        case Element::altitude: return SignalGroup::altitude;
        case Element::flaps: return SignalGroup::flaps;
        default: return SignalGroup::not_shown;
    }
}

void add_chain_cases(Element element, std::vector<Case>& cases) {
    const policy::SourceChain& chain = policy::source_chain(group_of(element));
    for (std::size_t n = 0; n < chain.count; ++n) {
        cases.push_back({element, n < chain.equals ? ElementShow::normal : ElementShow::substituted, chain.sources[n]});
        cases.push_back({element, ElementShow::flagged, chain.sources[n]});
    }
}

/// The states that failure_policy.cpp decides.
std::vector<Case> cases_of(Element element) {
    std::vector<Case> cases;
    const auto add = [&](ElementShow show, Signal source) { cases.push_back({element, show, source}); };
    if (element == Element::map_up) {  // it is absent only where the map has no symbols
        add(ElementShow::normal, Signal::count_);
        add(ElementShow::normal, Signal::true_track);
        add(ElementShow::substituted, Signal::true_heading);
        add(ElementShow::flagged, Signal::count_);
        return cases;
    }
    add(ElementShow::absent, Signal::count_);
    if (element != Element::airspeed_trend) add(ElementShow::failed, Signal::count_);
    if (group_of(element) != policy::SignalGroup::not_shown) {
        add_chain_cases(element, cases);
        return cases;
    }
    add(ElementShow::normal, Signal::height_above_terrain);
    if (element == Element::flight_path || element == Element::airspeed_trend) return cases;
    add(ElementShow::flagged, Signal::radio_height);
    if (element != Element::ground_height) return cases;
    add(ElementShow::flagged, Signal::height_above_terrain);
    add(ElementShow::substituted, Signal::height_above_terrain);
    return cases;
}

/// Those without which others are not drawn.
bool is_host(Element element) {
    for (const Element host : {Element::attitude, Element::heading, Element::airspeed, Element::altitude, Element::vertical_speed,
                               Element::position, Element::map_up})
        if (element == host) return true;
    return false;
}

struct AlertScreen {
    std::uint32_t width, height;
    base::DisplayUnits units = base::DisplayUnits::feet_and_knots;
};
constexpr AlertScreen kMetricScreen{1280, 720, base::DisplayUnits::metric};
constexpr AlertScreen kLargeScreen{1280, 720}, kSmallestScreens[] = {{240, 320}, {320, 240}};

SymbologyInput good_input(const AlertScreen& screen = kLargeScreen) {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(47, 0, 0), screen.width, screen.height);
    for (policy::ElementDecision& decision : input.decisions.elements) decision.show = ElementShow::normal;
    input.decisions.notices.clear();
    input.decisions.radio_minimum = input.decisions.baro_minimum = policy::MinimumsState::above;
    input.shown.legend = false;
    input.shown.map = true;
    input.shown.units = screen.units;
    input.map.px_per_m = 0.01;
    input.wind_speed_mps = 6;
    return input;
}

SymbologyInput input_of(const Case& drawn, const Context& context, const AlertScreen& screen) {
    SymbologyInput input = good_input(screen);
    policy::DisplayDecisions& decisions = input.decisions;
    for (std::size_t n = 0; n < policy::kElementCount; ++n)
        if (context.is_alone && !is_host(static_cast<Element>(n))) decisions.elements[n] = {ElementShow::absent, Signal::count_};
    if (context.is_alone) {
        input.wind_speed_mps = 0;
        input.map.is_oblique = true;
        input.map.turn_rad = base::radians(30);
    }
    if (context.is_receiver_lost) {
        for (const Element guidance : {Element::course, Element::lateral_deviation, Element::vertical_deviation})
            decisions[guidance] = {ElementShow::absent, Signal::count_};
        decisions[Element::navigation_source] = {ElementShow::failed, Signal::count_};
    }
    input.guidance.navigation_source = context.receiver;
    input.phase.presented = context.phase;
    input.over = context.over;
    decisions[drawn.element] = {drawn.show, drawn.source};
    return input;
}

/// A receiver that is lost takes its course and deviations with it.
bool is_decided(const Case& drawn, const Context& context) {
    const bool is_guidance = drawn.element == Element::course || drawn.element == Element::lateral_deviation ||
                             drawn.element == Element::vertical_deviation;
    if (!context.is_receiver_lost || !(is_guidance || drawn.element == Element::navigation_source)) return true;
    return drawn.show == ElementShow::failed || (is_guidance && drawn.show == ElementShow::absent);
}

std::vector<AlertText> drawn_texts(const SymbologyInput& input, const AlertScreen& screen = kLargeScreen) {
    test_support::BatchStore store;
    build_symbology(store.batch, input, make_layout(screen.width, screen.height, 96));
    EXPECT_EQ(store.batch.use().refused, 0u);
    return AlertTexts(store.batch).all();
}

void add_found(const SymbologyInput& input, std::string_view place, ElementShow show, Found& found,
               const AlertScreen& screen = kLargeScreen) {
    for (const AlertText& text : drawn_texts(input, screen)) found.insert(line_of(place, show, text.color, text.text));
}

void add_elements(Found& found, const AlertScreen& screen = kLargeScreen) {
    const std::vector<Context> all = contexts();
    for (std::size_t n = 0; n < policy::kElementCount; ++n)
        for (const Case& drawn : cases_of(static_cast<Element>(n)))
            for (const Context& context : all)
                if (is_decided(drawn, context))
                    add_found(input_of(drawn, context, screen), name_of(drawn.element), drawn.show, found, screen);
}

void add_normal_states(Found& found) {
    SymbologyInput bank = good_input();
    bank.roll_rad = base::radians(50);
    add_found(bank, "attitude", ElementShow::normal, found);
    SymbologyInput variation = good_input();
    variation.decisions[Element::heading].source = Signal::magnetic_heading;
    variation.from_true_rad = std::numeric_limits<double>::quiet_NaN();
    add_found(variation, "heading", ElementShow::normal, found);
    SymbologyInput minimum = good_input();
    minimum.decisions[Element::radio_minimum].show = ElementShow::absent;
    minimum.decisions.baro_minimum = policy::MinimumsState::at_or_below;
    add_found(minimum, "baro_minimum", ElementShow::normal, found);
    minimum.decisions.baro_minimum = policy::MinimumsState::above;
    minimum.decisions[Element::radio_minimum].show = ElementShow::normal;
    minimum.decisions.radio_minimum = policy::MinimumsState::at_or_below;
    add_found(minimum, "radio_minimum", ElementShow::normal, found);
}

std::string upper_name(const flight::FlightPhase& phase) {
    std::string name = std::string(scenario_name(phase)) + sub_phase_name(phase);
    name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}

void add_phases(Found& found) {
    using flight::PhaseSource;
    for (const flight::FlightPhase& phase : {flight::kApproachFinal, flight::kTakeoffFirstClimb, flight::kGoAroundReplanning,
                                             flight::FlightPhase{flight::Scenario::cruise, 0}, flight::FlightPhase{}})
        for (const PhaseSource source :
             {PhaseSource::switches, PhaseSource::can, PhaseSource::motion, PhaseSource::held, PhaseSource::none}) {
            SymbologyInput input = good_input();
            input.phase.phase = phase;
            input.phase.source = source;
            for (const AlertText& drawn : drawn_texts(input))
                found.insert(line_of("phase", ElementShow::normal, drawn.color,
                                     drawn.text == upper_name(phase) ? std::string("(phase)") : drawn.text));
        }
}

void add_distortion(Found& found) {
    for (const std::uint32_t second_power : {1u, 2u}) {
        SymbologyInput input = good_input();
        input.over = SymbolGround::map;
        EXPECT_TRUE(input.map.magnified.try_push_back({{400, 300}, 40, 60, 1, 1}));
        EXPECT_TRUE(input.map.magnified.try_push_back({{800, 300}, 40, 60, second_power, 1}));
        add_found(input, "distortion", ElementShow::normal, found);
    }
}

/// Entries with data of many ages, alone and where not all of them have room.
void add_legends(Found& found) {
    using test_support::kMinute_ns;
    const auto add = [&](const DataLegend& entry, std::size_t count, float height_texts) {
        DataLegends legends;
        for (std::size_t n = 0; n < count; ++n) EXPECT_TRUE(legends.try_push_back(entry));
        test_support::BatchStore store;
        const Layout layout = test_support::area_of(height_texts);
        build_data_legends(Painter(store.batch, layout), legends);
        const AlertTexts texts(store.batch);
        for (const AlertText& drawn : texts.all())
            found.insert(line_of("legend", entry.is_stale ? ElementShow::flagged : ElementShow::normal, drawn.color,
                                 drawn.text == "WINDM/S" ? std::string("(title)") : drawn.text));
    };
    for (const std::int64_t minutes : {12, 62, 5 * 60, 3 * 24 * 60}) {
        DataLegend entry = test_support::wind();
        entry.age = {minutes * kMinute_ns};
        for (const bool is_stale : {false, true}) {
            entry.is_stale = is_stale;
            for (const float height_texts : {6.0f, 10.0f, 30.0f}) add(entry, 1, height_texts);
        }
    }
    DataLegend ageless = test_support::wind();
    ageless.has_age = false;
    add(ageless, 1, 30);
    add(test_support::wind(), 4, 6);
}

/// Their own texts are in a table of their own.
void add_notices(Found& found) {
    SymbologyInput input = good_input();
    for (const policy::NoticeRow& row : policy::notice_rows())
        if (row.level != policy::NoticeLevel::information)
            static_cast<void>(input.decisions.notices.try_push_back({row.level, row.text}));
    for (const AlertText& drawn : drawn_texts(input)) {
        const auto rows = policy::notice_rows();
        const bool is_notice = std::any_of(
            rows.begin(), rows.end(), [&](const policy::NoticeRow& row) { return canonical(row.text) == canonical(drawn.text); });
        if (!is_notice) found.insert(line_of("notices", ElementShow::normal, drawn.color, drawn.text));
    }
}

const Found& drawn_lines() {
    static const Found lines = [] {
        Found found;
        add_elements(found);
        add_normal_states(found);
        add_phases(found);
        add_distortion(found);
        add_legends(found);
        add_notices(found);
        return found;
    }();
    return lines;
}

TEST(AlertTexts, EveryTextThatIsDrawnIsInTheTable) {
    EXPECT_EQ(missing_in(lines_of(policy::element_texts()), drawn_lines()), Found());
}

TEST(AlertTexts, EveryTextOfTheTableIsDrawn) { EXPECT_EQ(missing_in(drawn_lines(), lines_of(policy::element_texts())), Found()); }

/// The text, its short wording, and its words from any one to any other: "STALE RA FT", "STALE RA" and "RA".
std::vector<std::string> wordings_of(const std::string& text) {
    std::vector<std::string> words, wordings{std::string(short_wording(text))};
    std::istringstream parts(text);
    for (std::string word; parts >> word;) words.push_back(word);
    for (std::size_t from = 0; from < words.size(); ++from) {
        std::string wording;
        for (std::size_t n = from; n < words.size(); ++n) wordings.push_back(wording += words[n]);
    }
    if (text.find("/#KT") != std::string::npos) wordings.insert(wordings.end(), {"#/# #S", "WIND STALE"});
    return wordings;
}

Found lines_with_shorter_wordings() {
    Found lines;
    for (const policy::ElementText& row : policy::element_texts()) {
        std::istringstream texts{std::string(row.texts)};
        for (std::string text; std::getline(texts >> std::ws, text, ',');)
            for (const std::string& wording : wordings_of(text)) lines.insert(line_of(row.place, row.show, row.color, wording));
    }
    // The name of the number, where its place is not below its scale.
    lines.insert(line_of("vertical_speed", ElementShow::flagged, TextColor::amber, "VS"));
    return lines;
}

TEST(AlertTexts, OnTheSmallestScreensEveryTextIsOneOfTheTableOrAShorterWordingOfIt) {
    for (const AlertScreen& screen : kSmallestScreens) {
        Found found;
        add_elements(found, screen);
        EXPECT_GT(found.size(), 60u);
        EXPECT_EQ(missing_in(lines_with_shorter_wordings(), found), Found()) << screen.width << "x" << screen.height;
    }
    const Found cut{"heading flagged amber HDGT..", "course flagged amber L.."};
    EXPECT_EQ(missing_in(lines_with_shorter_wordings(), cut), cut) << "control";
}

/// The table has the texts of a display in feet and knots.
TEST(AlertTexts, AMetricDisplayHasTheSameOnesInItsUnits) {
    const auto lines = [](const AlertScreen& screen) {
        Found found;
        add_elements(found, screen);
        return found;
    };
    Found in_feet;
    for (std::string line : lines(kMetricScreen)) {
        for (const auto& [metric, feet] : {std::pair{"KM/H", "KT"},
                                           {"MSLM", "MSLFT"},
                                           {"STDM", "STDFT"},
                                           {"BAROM", "BAROFT"},
                                           {"AGLM", "AGLFT"},
                                           {"RAM", "RAFT"}})
            if (const std::size_t at = line.find(metric); at != std::string::npos)
                line.replace(at, std::string(metric).size(), feet);
        in_feet.insert(line);
    }
    EXPECT_EQ(in_feet, lines(kLargeScreen));
    EXPECT_NE(lines(kMetricScreen), in_feet) << "control";
}

TEST(AlertTexts, AChangedRowIsFoundBothWays) {
    const auto rows = policy::element_texts();
    std::vector<policy::ElementText> changed(rows.begin(), rows.end());
    for (policy::ElementText& row : changed)
        if (row.texts == "SPD FAIL") row.texts = "IAS FAIL";
    const Found lines = lines_of({changed.data(), changed.size()});
    EXPECT_EQ(missing_in(lines, drawn_lines()), Found{"airspeed failed red SPDFAIL"});
    EXPECT_EQ(missing_in(drawn_lines(), lines), Found{"airspeed failed red IASFAIL"});
}

TEST(AlertTexts, AnotherColorIsAnotherText) {
    const auto rows = policy::element_texts();
    std::vector<policy::ElementText> changed(rows.begin(), rows.end());
    for (policy::ElementText& row : changed)
        if (row.texts == "FD") row.color = TextColor::red;
    EXPECT_EQ(missing_in(drawn_lines(), lines_of({changed.data(), changed.size()})), Found{"flight_director failed red FD"});
}

TEST(AlertTexts, NumbersAreToldFromWords) {
    EXPECT_EQ(canonical("OAT -5\xC2\xB0"
                        "C 12S"),
              canonical("OAT #\xC2\xB0"
                        "C #S"));
    EXPECT_EQ(canonical("3.0\xB0"), canonical("#\xC2\xB0"));
    EXPECT_EQ(canonical("265/12KT"), canonical("#/#KT"));
    EXPECT_EQ(canonical("+3 MORE"), canonical("+# MORE"));
    EXPECT_NE(canonical("TAS KT"), canonical("GS KT"));
}

}  // namespace
}  // namespace tedavis::draw::test_alert_texts
