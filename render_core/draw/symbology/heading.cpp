#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::draw {
namespace {

using flight::Signal;
using policy::ElementShow;

constexpr double kTapeSpan_deg = 60;
constexpr int kTickStep_deg = 5;

std::string_view heading_label(Signal source) {
    if (source == Signal::magnetic_heading) return "HDG MAG";
    return source == Signal::true_track ? "TRK TRUE" : "HDG TRUE";
}

/// "N", "03", "E": tens of degrees and the four winds, as on a compass card.
ShortText tick_text(int degrees) {
    switch (degrees) {
        case 0: return "N";
        case 90: return "E";
        case 180: return "S";
        case 270: return "W";
        default: return whole_number(degrees / 10, 2);
    }
}

void build_card(const Painter& painter, const Rect& card, double heading_deg) {
    const float t = painter.text_px();
    const double pixels_per_degree = static_cast<double>(card.width) / kTapeSpan_deg;
    const int first = static_cast<int>(std::ceil((heading_deg - kTapeSpan_deg / 2) / kTickStep_deg)) * kTickStep_deg;
    const int last = static_cast<int>(heading_deg + kTapeSpan_deg / 2);
    for (int degrees = first; degrees <= last; degrees += kTickStep_deg) {
        const float x = card.center().x + static_cast<float>((degrees - heading_deg) * pixels_per_degree);
        const bool ten = degrees % 10 == 0;
        painter.line({x, card.y}, {x, card.y + (ten ? 0.45f : 0.25f) * t});
        if (ten) painter.text(tick_text((degrees + 360) % 360).view(), {x, card.y + 0.9f * t}, TextAnchor::center, 0.8f);
    }
}

}  // namespace

void build_heading(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[policy::Element::heading];
    const Rect& box = painter.layout().heading;
    if (decision.show == ElementShow::absent) return;
    if (decision.show == ElementShow::failed) return painter.failed(box, "HDG FAIL");
    const float t = painter.text_px();
    const double heading_deg = base::degrees(earth::wrap_heading(limited(input.heading_rad, -100, 100)));
    const Rect card{box.x, box.y + 1.6f * t, box.width, box.height - 1.6f * t};
    painter.batch().box(card, kTapeGround);
    painter.batch().set_clip(card);
    build_card(painter, card, heading_deg);
    painter.batch().lift_clip();
    const Rect number{box.center().x - 1.6f * t, box.y, 3.2f * t, 1.55f * t};
    painter.readout(number, whole_number(static_cast<int>(std::lround(heading_deg)) % 360, 3).view(),
                    decision.show == ElementShow::flagged);
    const Rect label{box.x, box.y, number.x - box.x, 1.5f * t};
    painter.fitted_text(heading_label(decision.source), label, TextAnchor::right, 0.8f, label_color(decision.show));
    const Rect right{number.right() + 0.2f * t, box.y, 2.4f * t, 1.5f * t};
    if (decision.show == ElementShow::substituted) painter.crossed_out(right, "HDG");
    if (decision.show == ElementShow::flagged) painter.fitted_text("STALE", right, TextAnchor::left, 0.8f, kCautionColor);
}

}  // namespace tedavis::draw
