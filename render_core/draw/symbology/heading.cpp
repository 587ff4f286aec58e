#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/compass_rose.hpp"
#include "render_core/draw/symbology/course_deviation.hpp"
#include "render_core/draw/symbology/short_words.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::draw {
namespace {

using flight::Signal;
using policy::ElementShow;

std::string_view heading_label(Signal source) {
    if (source == Signal::magnetic_heading) return "HDG MAG";
    return source == Signal::true_track ? "TRK TRUE" : "HDG TRUE";
}

/// The digits in an open frame, between the source's name and what is wrong with it.
void build_heading_readout(const Painter& painter, const CompassRose& rose, const policy::ElementDecision& decision,
                           double heading_rad) {
    const float t = rose.text_px, size = legible_size(painter.type().label, painter.text_px());
    const Rect& number = rose.readout;
    const bool flagged = decision.show == ElementShow::flagged;
    const design::Color color = painter.color(flagged ? SymbolRole::caution : SymbolRole::scale);
    const Rect frame = number.shrunk(painter.stroke_px());
    const Point corners[4] = {
        {frame.x, frame.y}, {frame.right(), frame.y}, {frame.right(), frame.bottom()}, {frame.x, frame.bottom()}};
    painter.polyline(corners, color, 1, true);
    const ShortText digits = whole_number(static_cast<int>(std::lround(base::degrees(heading_rad))) % 360, 3);
    painter.fitted_text(digits.view(), number, TextAnchor::center, painter.type().value, color);
    const Rect label{rose.box.x, number.y, number.x - rose.box.x, number.height};
    painter.fitted_text(short_words(heading_label(decision.source)), label, TextAnchor::right, size,
                        painter.label_color(decision.show));
    const Rect right{number.right() + 0.2f * t, number.y, 2.6f * t, number.height};
    if (decision.show == ElementShow::substituted) painter.crossed_out(right, "HDG");
    const float stale = std::max(right.width, text_width_px("STALE", painter.em_px(size)) + 0.4f * t);
    if (flagged)
        painter.fitted_text("STALE", {right.x, right.y, stale, right.height}, TextAnchor::left, size,
                            painter.color(SymbolRole::caution));
}

}  // namespace

void build_heading(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[policy::Element::heading];
    if (decision.show == ElementShow::absent) return;
    const CompassRose rose = make_compass_rose(painter.layout());
    const bool recovers = input.decisions.unusual_attitude;
    if (decision.show == ElementShow::failed) {
        painter.failed(painter.layout().heading, "HDG FAIL");
        if (recovers) return;
        // A deviation needs no heading; its course has no direction then.
        build_course(painter, rose, input);
        return build_course_texts(painter, rose, input);
    }
    const double heading_rad = earth::wrap_heading(limited(input.heading_rad, -100, 100));
    painter.batch().set_clip(rose.card);
    build_rose_card(painter, rose, heading_rad);
    if (!recovers) {
        build_rose_marks(painter, rose, input);
        build_course(painter, rose, input);
        build_turn_trend(painter, rose, input);
    }
    build_lubber_line(painter, rose);
    painter.batch().lift_clip();
    build_heading_readout(painter, rose, decision, heading_rad);
    if (recovers) return;
    build_course_texts(painter, rose, input);
    build_rose_texts(painter, rose, input);
}

}  // namespace tedavis::draw
