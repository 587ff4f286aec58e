#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/short_words.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/draw/symbology/vertical_tape.hpp"

namespace tedavis::draw {
namespace {

using flight::Signal;
using policy::Element;
using policy::ElementShow;

constexpr double kTrend_s = 6;
constexpr float kNumberRow = 1.8f;  // texts

/// What a tape shows in its unit.
struct TapeUnits {
    double lowest, highest;  ///< of the scale and of the numbers
    double span, minor_step;
    int majors, emphasis;  ///< as of a VerticalTape
    RollingFormat readout;
    double slowest_trend;  ///< over kTrend_s
};
constexpr TapeUnits kKnots{0, 999, 100, 10, 2, 0, {}, 1}, kKilometresAnHour{0, 1850, 200, 10, 5, 0, {}, 2};
constexpr TapeUnits kFeet{-2000, 99'999, 1000, 50, 2, 10, {20, 2}, 20}, kMetres{-600, 99'999, 300, 20, 5, 25, {10, 2}, 6};

/// A fixed scale of vertical speeds: a tick at each quarter of its end, and a number at every second of them.
struct VerticalSpeedUnits {
    double end, numbers_in;          ///< of the scale; what its numbers count
    double highest, step;            ///< of the readout
    ShortText (*text)(double step);  ///< of the readout and of the selected value
};

ShortText whole_text(double value) { return whole_number(value); }
constexpr VerticalSpeedUnits kFeetAMinute{2000, 1000, 9990, 10, whole_text};
constexpr VerticalSpeedUnits kMetresASecond{10, 1, 99.9, 0.1, tenths};

bool is_metric(const SymbologyInput& input) { return input.shown.units == base::DisplayUnits::metric; }
const VerticalSpeedUnits& vertical_speed_units(const SymbologyInput& input) {
    return is_metric(input) ? kMetresASecond : kFeetAMinute;
}

/// "IAS KT".
ShortText label_in(std::string_view source, const base::DisplayUnit& unit) {
    ShortText label(source);
    label.append(" ");
    label.append(unit.text);
    return label;
}

std::string_view airspeed_name(Signal source) {
    switch (source) {
        case Signal::calibrated_airspeed: return "CAS";
        case Signal::true_airspeed: return "TAS";
        case Signal::ground_speed: return "GS";
        default: return "IAS";
    }
}

std::string_view altitude_name(Signal source) {
    switch (source) {
        case Signal::true_altitude:
        case Signal::ellipsoid_height: return "GPS MSL";
        case Signal::standard_altitude: return "STD";
        default: return "BARO";
    }
}

/// `value` in its unit.
VerticalTape tape_of(const TapeUnits& units, double value, const policy::ElementDecision& decision) {
    VerticalTape tape;
    tape.value = limited(value, units.lowest, units.highest);
    tape.lowest = units.lowest;
    tape.span = units.span;
    tape.minor_step = units.minor_step;
    tape.majors = units.majors;
    tape.emphasis = units.emphasis;
    tape.readout = units.readout;
    tape.show = decision.show;
    return tape;
}

/// A selected value is said above its scale, and has a bug on a scale of the same reference: on that of a substitute its place
/// would be wrong. `value` in display units.
void put_selected(const Painter& painter, VerticalTape& tape, ElementShow show, double value, const ShortText& text,
                  std::string_view name) {
    tape.selected = {show, text.view(), name, painter.color(SymbolRole::selected)};
    if (tape.show != ElementShow::substituted) tape.marks.bug = {show, value};
}

SymbolRole band_role(policy::SpeedBandRole role) {
    switch (role) {
        case policy::SpeedBandRole::low_caution: return SymbolRole::caution;
        case policy::SpeedBandRole::normal: return SymbolRole::engaged;
        case policy::SpeedBandRole::caution: return SymbolRole::reference;
        case policy::SpeedBandRole::flaps_range: return SymbolRole::scale;
        case policy::SpeedBandRole::low_warning:
        case policy::SpeedBandRole::above_limit: break;
    }
    return SymbolRole::warning;
}

TapeBandLook band_look(const policy::SpeedBands& bands, policy::SpeedBandRole role) {
    if (role == policy::SpeedBandRole::flaps_range) return TapeBandLook::half;
    return role == policy::SpeedBandRole::above_limit && bands.has_pole ? TapeBandLook::pole : TapeBandLook::whole;
}

static_assert(policy::kSpeedBandRoles <= kMaxTapeBands && design::kMaxSpeedFlags <= kMaxTapeFlags);
void put_bands(const Painter& painter, const policy::SpeedBands& bands, const base::DisplayUnit& unit, TapeMarks& marks) {
    for (const policy::SpeedBand& band : bands.bands) {
        const bool added = marks.bands.try_push_back(
            {unit.of(band.low_mps), unit.of(band.high_mps), painter.color(band_role(band.role)), band_look(bands, band.role)});
        TEDAVIS_CHECK(added);
    }
    for (const design::SpeedFlag& flag : bands.flags) {
        const bool added = marks.flags.try_push_back({unit.of(flag.speed_mps), flag.name, painter.color(SymbolRole::scale)});
        TEDAVIS_CHECK(added);
    }
}

bool is_current(ElementShow show) { return show == ElementShow::normal || show == ElementShow::substituted; }

SymbolRole baro_minimum_role(const policy::DisplayDecisions& decisions) {
    switch (decisions.baro_minimum) {
        case policy::MinimumsState::near: return SymbolRole::scale;
        case policy::MinimumsState::at_or_below: return SymbolRole::caution;
        case policy::MinimumsState::none:
        case policy::MinimumsState::above: break;
    }
    return SymbolRole::selected;
}

/// Numbers keep clear of the needle at `value`.
void build_vertical_speed_ticks(const Painter& painter, const TapeScale& scale, const VerticalSpeedUnits& units, double value) {
    for (int quarter = -4; quarter <= 4; ++quarter) {
        const double at = 0.25 * quarter * units.end;
        const float y = scale.y_of(at);
        const bool is_major = quarter % 2 == 0;
        painter.line({scale.edge, y}, {scale.x_of(is_major ? 0.7f : 0.4f, painter), y});
        if (is_major && quarter != 0 && std::fabs(y - scale.y_of(value)) > 0.6f * painter.text_px())
            painter.text(whole_number(std::fabs(at / units.numbers_in)).view(), {scale.x_of(kNumberInset, painter), y},
                         TextAnchor::left, kTapeTextSize);
    }
}

void build_needle(const Painter& painter, const TapeScale& scale, double value) {
    const float y = scale.y_of(value), half = 0.35f * painter.text_px(), base = scale.x_of(0.95f, painter);
    painter.line({scale.x_of(0.7f, painter), y}, {scale.box.right(), y}, painter.color(SymbolRole::scale), 2);
    const Point corners[3] = {{scale.x_of(0.15f, painter), y}, {base, y - half}, {base, y + half}};
    painter.batch().polyline(corners, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(corners[0], corners[1], corners[2], painter.color(SymbolRole::scale));
}

/// Box and units of the fixed scale of vertical speeds.
TapeScale vertical_speed_scale(const Painter& painter, const Rect& box, const VerticalSpeedUnits& units) {
    TapeScale scale;
    scale.box = box;
    scale.edge = box.x;
    scale.px_per_unit = static_cast<double>(box.height / 2 - 0.8f * painter.text_px()) / units.end;
    return scale;
}

void build_vertical_speed_scale(const Painter& painter, const Rect& box, const VerticalSpeedUnits& units, double value,
                                const TapeBug& bug) {
    const TapeScale scale = vertical_speed_scale(painter, box, units);
    const double on_scale = limited(value, -units.end, units.end);
    painter.batch().box(box, painter.color(SymbolRole::tape_ground));
    painter.batch().set_clip(box);
    build_vertical_speed_ticks(painter, scale, units, on_scale);
    build_tape_bug(painter, scale, bug);
    build_needle(painter, scale, on_scale);
    painter.batch().lift_clip();
}

/// At the top of `rest`; where the number has no room the bug alone says it.
void build_selected_vertical_speed(const Painter& painter, ElementShow show, const VerticalSpeedUnits& units, double value,
                                   Rect& rest) {
    const ShortText text = units.text(limited(value, -units.highest, units.highest));
    const bool has_room = text_width_px(text.view(), kMinText_px) <= rest.width - 2 * painter.stroke_px();
    if (show == ElementShow::absent || (shows_value(show) && !has_room)) return;
    build_tape_row(painter, take_top(rest, legible_row_px(kTapeRowHeight, painter.text_px())),
                   {show, text.view(), "VS SEL", painter.color(SymbolRole::selected)});
}

/// The foot of `rest`, which becomes lower by it; or, where that is too narrow, the place of its own with its name.
Rect vertical_speed_number_place(const Painter& painter, bool is_flagged, Rect& rest) {
    Rect own = painter.layout().vertical_speed_number;
    if (!own.empty()) {
        const ElementShow show = is_flagged ? ElementShow::flagged : ElementShow::normal;
        painter.plate(take_top(own, own.height / 2), "VS", painter.type().label, painter.label_color(show));
        return own;
    }
    const float row = legible_row_px(kNumberRow, painter.text_px());
    rest.height -= row;
    return {rest.x, rest.bottom(), rest.width, row};
}

}  // namespace

void build_airspeed(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[Element::airspeed];
    const base::DisplayUnit unit = base::speed_unit(input.shown.units);
    const TapeUnits& units = is_metric(input) ? kKilometresAnHour : kKnots;
    const double selected = unit.of(input.guidance.selected_airspeed_mps);
    const ShortText selected_text = whole_number(limited(selected, units.lowest, units.highest));
    const ShortText label = label_in(airspeed_name(decision.source), unit);
    VerticalTape tape = tape_of(units, unit.of(input.airspeed_mps), decision);
    tape.box = painter.layout().airspeed;
    tape.ticks_right = true;
    tape.label = label.view();
    tape.failure = "SPD FAIL";
    put_bands(painter, input.bands, unit, tape.marks);
    put_selected(painter, tape, input.decisions[Element::selected_airspeed].show, selected, selected_text, "SPD SEL");
    tape.marks.trend = {input.decisions[Element::airspeed_trend].show == ElementShow::normal,
                        tape.value + kTrend_s * unit.of(input.guidance.airspeed_rate_mps2), units.slowest_trend};
    build_vertical_tape(painter, tape);
}

void build_altitude(const Painter& painter, const SymbologyInput& input) {
    const policy::DisplayDecisions& decisions = input.decisions;
    const base::DisplayUnit unit = base::height_unit(input.shown.units);
    const TapeUnits& units = is_metric(input) ? kMetres : kFeet;
    const auto text_of = [&](double value) { return whole_number(limited(value, units.lowest, units.highest)); };
    const double selected = unit.of(input.guidance.selected_altitude_m), least = unit.of(input.guidance.baro_minimum_m);
    const ShortText selected_text = text_of(selected), label = label_in(altitude_name(decisions[Element::altitude].source), unit);
    ShortText minimum("MIN ");
    minimum.append(text_of(least).view());
    VerticalTape tape = tape_of(units, unit.of(input.altitude_m), decisions[Element::altitude]);
    tape.box = painter.layout().altitude;
    tape.label = label.view();
    tape.failure = "ALT FAIL";
    put_selected(painter, tape, decisions[Element::selected_altitude].show, selected, selected_text, "ALT SEL");
    tape.minimum = {decisions[Element::baro_minimum].show, minimum.view(), "MIN", painter.color(baro_minimum_role(decisions)),
                    minimum.view().substr(4)};
    if (tape.show != ElementShow::substituted) tape.marks.minimum = {tape.minimum.show, least, tape.minimum.color};
    tape.marks.trend = {is_current(tape.show) && is_current(decisions[Element::vertical_speed].show),
                        tape.value + unit.of(kTrend_s * input.vertical_speed_mps), units.slowest_trend};
    build_vertical_tape(painter, tape);
}

void build_vertical_speed(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::vertical_speed].show;
    const ElementShow selected_show = input.decisions[Element::selected_vertical_speed].show;
    if (show == ElementShow::absent) return;
    const base::DisplayUnit unit = base::vertical_speed_unit(input.shown.units);
    const VerticalSpeedUnits& units = vertical_speed_units(input);
    const double selected = unit.of(input.guidance.selected_vertical_speed_mps);
    Rect rest = painter.layout().vertical_speed;
    build_selected_vertical_speed(painter, selected_show, units, selected, rest);
    if (show == ElementShow::failed) return painter.failed(rest, "VS FAIL");
    const bool is_flagged = show == ElementShow::flagged;
    painter.plate(take_top(rest, legible_row_px(kTapeRowHeight, painter.text_px())),
                  short_words(is_flagged ? "STALE" : unit.text), kTapeTextSize, painter.label_color(show));
    const Rect number = vertical_speed_number_place(painter, is_flagged, rest);
    const double value = limited(unit.of(input.vertical_speed_mps), -units.highest, units.highest);
    build_vertical_speed_scale(painter, rest, units, value, {selected_show, selected});
    painter.readout(number, units.text(std::round(value / units.step) * units.step).view(), is_flagged);
}

}  // namespace tedavis::draw
