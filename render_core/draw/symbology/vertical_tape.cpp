#include "render_core/draw/symbology/vertical_tape.hpp"

#include <cmath>

namespace tedavis::draw {
namespace {

constexpr float kLabelHeight = 1.3f;  // texts
constexpr int kMaxTicks = 64;

void build_ticks(const Painter& painter, const VerticalTape& tape, const Rect& scale) {
    const float t = painter.text_px(), center = scale.center().y;
    const double pixels_per_unit = static_cast<double>(scale.height) / tape.span;
    const double first = std::ceil((tape.value - tape.span / 2) / tape.minor_step);
    const float edge = tape.ticks_right ? scale.right() : scale.x, inwards = tape.ticks_right ? -1.0f : 1.0f;
    painter.line({edge, scale.y}, {edge, scale.bottom()});
    for (int i = 0; i < kMaxTicks; ++i) {
        const double step = first + i, unit = step * tape.minor_step;
        if (unit > tape.value + tape.span / 2) break;
        if (unit < tape.lowest) continue;
        const float y = center - static_cast<float>((unit - tape.value) * pixels_per_unit);
        const bool major = std::fmod(step, static_cast<double>(tape.majors)) == 0;
        painter.line({edge, y}, {edge + inwards * (major ? 0.7f : 0.4f) * t, y});
        if (major)
            painter.text(whole_number(unit).view(), {edge + inwards * 0.95f * t, y},
                         tape.ticks_right ? TextAnchor::right : TextAnchor::left, 0.85f);
    }
}

}  // namespace

void build_vertical_tape(const Painter& painter, const VerticalTape& tape) {
    const float t = painter.text_px();
    const Rect label{tape.box.x, tape.box.y, tape.box.width, kLabelHeight * t};
    const Rect scale{tape.box.x, label.bottom(), tape.box.width, tape.box.height - label.height};
    painter.plate(label, tape.label, 0.8f, label_color(tape.show));
    painter.batch().box(scale, kTapeGround);
    painter.batch().set_clip(scale);
    build_ticks(painter, tape, scale);
    painter.batch().lift_clip();
    const Rect readout{scale.x, scale.center().y - 0.9f * t, scale.width, 1.8f * t};
    const double rounded = std::round(tape.value / tape.readout_step) * tape.readout_step;
    const bool flagged = tape.show == policy::ElementShow::flagged;
    painter.readout(readout, whole_number(rounded).view(), flagged);
    if (!flagged) return;
    const Rect old{readout.x, readout.bottom(), readout.width, 1.2f * t};
    painter.plate(old, "STALE", 0.85f, kCautionColor);
}

}  // namespace tedavis::draw
