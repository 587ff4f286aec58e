#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/draw/symbology/vertical_tape.hpp"

namespace tedavis::draw {
namespace {

using flight::Signal;
using policy::Element;
using policy::ElementShow;

constexpr double kVerticalSpeedEnd_fpm = 2000;

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

/// Pointer and ticks of the vertical speed on its fixed scale.
void build_vertical_speed_scale(const Painter& painter, const Rect& scale, double fpm) {
    const float t = painter.text_px(), center = scale.center().y, reach = scale.height / 2 - 0.8f * t;
    const auto y_of = [&](double value) { return center - static_cast<float>(value / kVerticalSpeedEnd_fpm) * reach; };
    for (int hundreds = -20; hundreds <= 20; hundreds += 5) {
        const float y = y_of(hundreds * 100.0);
        const bool thousand = hundreds % 10 == 0;
        painter.line({scale.x, y}, {scale.x + (thousand ? 0.7f : 0.4f) * t, y});
        if (thousand && hundreds != 0)
            painter.text(whole_number(std::abs(hundreds) / 10).view(), {scale.x + 0.95f * t, y}, TextAnchor::left, 0.85f);
    }
    const float y = y_of(limited(fpm, -kVerticalSpeedEnd_fpm, kVerticalSpeedEnd_fpm));
    painter.line({scale.x + 0.3f * t, center}, {scale.x + 0.3f * t, y}, kEngagedColor, 2);
    painter.line({scale.x + 0.3f * t, y}, {scale.x + 2.2f * t, y}, kEngagedColor, 2);
}

}  // namespace

void build_airspeed(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[Element::airspeed];
    const Rect& box = painter.layout().airspeed;
    if (decision.show == ElementShow::absent) return;
    if (decision.show == ElementShow::failed) return painter.failed(box, "SPD FAIL");
    VerticalTape tape;
    tape.box = box;
    tape.value = limited(input.airspeed_mps / base::kMpsPerKnot, 0, 999);
    tape.ticks_right = true;
    tape.label = airspeed_label(decision.source);
    tape.show = decision.show;
    build_vertical_tape(painter, tape);
}

void build_altitude(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[Element::altitude];
    const Rect& box = painter.layout().altitude;
    if (decision.show == ElementShow::absent) return;
    if (decision.show == ElementShow::failed) return painter.failed(box, "ALT FAIL");
    VerticalTape tape;
    tape.box = box;
    tape.value = limited(input.altitude_m / base::kMetresPerFoot, -2000, 99'999);
    tape.lowest = -2000;
    tape.span = 1000;
    tape.minor_step = 50;
    tape.majors = 4;
    tape.readout_step = 10;
    tape.label = altitude_label(decision.source);
    tape.show = decision.show;
    build_vertical_tape(painter, tape);
}

void build_vertical_speed(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::vertical_speed].show;
    const Rect& box = painter.layout().vertical_speed;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.failed(box, "VS FAIL");
    const float t = painter.text_px();
    const Rect label{box.x, box.y, box.width, 1.3f * t}, number{box.x, box.bottom() - 1.8f * t, box.width, 1.8f * t};
    const Rect scale{box.x, label.bottom(), box.width, number.y - label.bottom()};
    const double fpm = limited(input.vertical_speed_mps / base::kMpsPerFootPerMinute, -9990, 9990);
    const bool flagged = show == ElementShow::flagged;
    painter.plate(label, flagged ? "STALE" : "FT/MIN", 0.8f, label_color(show));
    painter.batch().box(scale, kTapeGround);
    build_vertical_speed_scale(painter, scale, fpm);
    painter.readout(number, whole_number(std::round(fpm / 10) * 10).view(), flagged);
}

}  // namespace tedavis::draw
