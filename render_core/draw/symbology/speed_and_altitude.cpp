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

constexpr double kVerticalSpeedEnd_fpm = 2000;
constexpr double kMaxVerticalSpeed_fpm = 9990;  // of the numbers
constexpr double kLowestAltitude_ft = -2000, kHighestAltitude_ft = 99'999;
constexpr double kTrend_s = 6;
constexpr float kNumberRow = 1.8f;                                          // texts
constexpr double kSlowestSpeedTrend_kt = 1, kSlowestAltitudeTrend_ft = 20;  // over kTrend_s

std::string_view airspeed_label(Signal source) {
    switch (source) {
        case Signal::calibrated_airspeed: return "CAS KT";
        case Signal::true_airspeed: return "TAS KT";
        case Signal::ground_speed: return "GS KT";
        default: return "IAS KT";
    }
}

std::string_view altitude_label(Signal source) {
    switch (source) {
        case Signal::true_altitude:
        case Signal::ellipsoid_height: return "GPS MSL FT";
        case Signal::standard_altitude: return "STD FT";
        default: return "BARO FT";
    }
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
void put_bands(const Painter& painter, const policy::SpeedBands& bands, TapeMarks& marks) {
    for (const policy::SpeedBand& band : bands.bands) {
        const bool added = marks.bands.try_push_back({band.low_mps / base::kMpsPerKnot, band.high_mps / base::kMpsPerKnot,
                                                      painter.color(band_role(band.role)), band_look(bands, band.role)});
        TEDAVIS_CHECK(added);
    }
    for (const design::SpeedFlag& flag : bands.flags) {
        const bool added =
            marks.flags.try_push_back({flag.speed_mps / base::kMpsPerKnot, flag.name, painter.color(SymbolRole::scale)});
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

/// Numbers keep clear of the needle at `fpm`.
void build_vertical_speed_ticks(const Painter& painter, const TapeScale& scale, double fpm) {
    for (int hundreds = -20; hundreds <= 20; hundreds += 5) {
        const float y = scale.y_of(hundreds * 100.0);
        const bool is_thousand = hundreds % 10 == 0;
        painter.line({scale.edge, y}, {scale.x_of(is_thousand ? 0.7f : 0.4f, painter), y});
        if (is_thousand && hundreds != 0 && std::fabs(y - scale.y_of(fpm)) > 0.6f * painter.text_px())
            painter.text(whole_number(std::fabs(0.1 * hundreds)).view(), {scale.x_of(kNumberInset, painter), y}, TextAnchor::left,
                         kTapeTextSize);
    }
}

void build_needle(const Painter& painter, const TapeScale& scale, double fpm) {
    const float y = scale.y_of(fpm), half = 0.35f * painter.text_px(), base = scale.x_of(0.95f, painter);
    painter.line({scale.x_of(0.7f, painter), y}, {scale.box.right(), y}, painter.color(SymbolRole::scale), 2);
    const Point corners[3] = {{scale.x_of(0.15f, painter), y}, {base, y - half}, {base, y + half}};
    painter.batch().polyline(corners, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(corners[0], corners[1], corners[2], painter.color(SymbolRole::scale));
}

/// Box and units of the fixed scale of vertical speeds.
TapeScale vertical_speed_scale(const Painter& painter, const Rect& box) {
    TapeScale scale;
    scale.box = box;
    scale.edge = box.x;
    scale.px_per_unit = static_cast<double>(box.height / 2 - 0.8f * painter.text_px()) / kVerticalSpeedEnd_fpm;
    return scale;
}

void build_vertical_speed_scale(const Painter& painter, const Rect& box, double fpm, const TapeBug& bug) {
    const TapeScale scale = vertical_speed_scale(painter, box);
    const double on_scale_fpm = limited(fpm, -kVerticalSpeedEnd_fpm, kVerticalSpeedEnd_fpm);
    painter.batch().box(box, painter.color(SymbolRole::tape_ground));
    painter.batch().set_clip(box);
    build_vertical_speed_ticks(painter, scale, on_scale_fpm);
    build_tape_bug(painter, scale, bug);
    build_needle(painter, scale, on_scale_fpm);
    painter.batch().lift_clip();
}

/// At the top of `rest`; where the number has no room the bug alone says it.
void build_selected_vertical_speed(const Painter& painter, ElementShow show, double fpm, Rect& rest) {
    const ShortText text = whole_number(limited(fpm, -kMaxVerticalSpeed_fpm, kMaxVerticalSpeed_fpm));
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

/// Scale and readout of an altitude in feet.
VerticalTape altitude_tape(const policy::ElementDecision& decision) {
    VerticalTape tape;
    tape.lowest = kLowestAltitude_ft;
    tape.span = 1000;
    tape.minor_step = 50;
    tape.majors = 2;
    tape.emphasis = 10;
    tape.readout = {20, 2};
    tape.label = altitude_label(decision.source);
    tape.failure = "ALT FAIL";
    tape.show = decision.show;
    return tape;
}

}  // namespace

void build_airspeed(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[Element::airspeed];
    const double selected_kt = input.guidance.selected_airspeed_mps / base::kMpsPerKnot;
    const ShortText selected = whole_number(limited(selected_kt, 0, 999));
    VerticalTape tape;
    tape.box = painter.layout().airspeed;
    tape.value = limited(input.airspeed_mps / base::kMpsPerKnot, 0, 999);
    tape.ticks_right = true;
    tape.label = airspeed_label(decision.source);
    tape.failure = "SPD FAIL";
    tape.show = decision.show;
    put_bands(painter, input.bands, tape.marks);
    put_selected(painter, tape, input.decisions[Element::selected_airspeed].show, selected_kt, selected, "SPD SEL");
    const double rate_kt_per_s = input.guidance.airspeed_rate_mps2 / base::kMpsPerKnot;
    tape.marks.trend = {input.decisions[Element::airspeed_trend].show == ElementShow::normal,
                        tape.value + kTrend_s * rate_kt_per_s, kSlowestSpeedTrend_kt};
    build_vertical_tape(painter, tape);
}

void build_altitude(const Painter& painter, const SymbologyInput& input) {
    const policy::DisplayDecisions& decisions = input.decisions;
    const double selected_ft = input.guidance.selected_altitude_m / base::kMetresPerFoot;
    const double minimum_ft = input.guidance.baro_minimum_m / base::kMetresPerFoot;
    const ShortText selected = whole_number(limited(selected_ft, kLowestAltitude_ft, kHighestAltitude_ft));
    ShortText minimum("MIN ");
    minimum.append(whole_number(limited(minimum_ft, kLowestAltitude_ft, kHighestAltitude_ft)).view());
    VerticalTape tape = altitude_tape(decisions[Element::altitude]);
    tape.box = painter.layout().altitude;
    tape.value = limited(input.altitude_m / base::kMetresPerFoot, kLowestAltitude_ft, kHighestAltitude_ft);
    put_selected(painter, tape, decisions[Element::selected_altitude].show, selected_ft, selected, "ALT SEL");
    tape.minimum = {decisions[Element::baro_minimum].show, minimum.view(), "MIN", painter.color(baro_minimum_role(decisions)),
                    minimum.view().substr(4)};
    if (tape.show != ElementShow::substituted) tape.marks.minimum = {tape.minimum.show, minimum_ft, tape.minimum.color};
    tape.marks.trend = {is_current(tape.show) && is_current(decisions[Element::vertical_speed].show),
                        tape.value + kTrend_s * input.vertical_speed_mps / base::kMetresPerFoot, kSlowestAltitudeTrend_ft};
    build_vertical_tape(painter, tape);
}

void build_vertical_speed(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::vertical_speed].show;
    const ElementShow selected_show = input.decisions[Element::selected_vertical_speed].show;
    if (show == ElementShow::absent) return;
    const double selected_fpm = input.guidance.selected_vertical_speed_mps / base::kMpsPerFootPerMinute;
    Rect rest = painter.layout().vertical_speed;
    build_selected_vertical_speed(painter, selected_show, selected_fpm, rest);
    if (show == ElementShow::failed) return painter.failed(rest, "VS FAIL");
    const bool is_flagged = show == ElementShow::flagged;
    painter.plate(take_top(rest, legible_row_px(kTapeRowHeight, painter.text_px())), short_words(is_flagged ? "STALE" : "FT/MIN"),
                  kTapeTextSize, painter.label_color(show));
    const Rect number = vertical_speed_number_place(painter, is_flagged, rest);
    const double fpm =
        limited(input.vertical_speed_mps / base::kMpsPerFootPerMinute, -kMaxVerticalSpeed_fpm, kMaxVerticalSpeed_fpm);
    build_vertical_speed_scale(painter, rest, fpm, {selected_show, selected_fpm});
    painter.readout(number, whole_number(std::round(fpm / 10) * 10).view(), is_flagged);
}

}  // namespace tedavis::draw
