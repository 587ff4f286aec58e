#include "render_core/draw/symbology/vertical_tape.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/short_words.hpp"

namespace tedavis::draw {
namespace {

using policy::ElementShow;

// In texts.
constexpr float kReadoutHeight = 2.2f;
constexpr float kReadoutEms = 1.4f;  // of the smallest text
constexpr float kStaleHeight = 1.2f;
constexpr float kPointerReach = 1.02f;  // of the readout's box, from the edge
constexpr float kPointerEnd = 0.15f;
constexpr float kPointerHalf = 0.4f;
constexpr int kMaxTicks = 64;

/// How bold the tick of so many minor steps is: 1, 2 or 3 strokes.
float tick_strokes(const VerticalTape& tape, double step) {
    if (tape.emphasis == 0 || std::fmod(step, static_cast<double>(tape.emphasis)) != 0) return 1;
    return std::fmod(step, 2.0 * tape.emphasis) == 0 ? 3 : 2;
}

/// Numbers keep clear of the readout, and of the flag below it.
bool is_number_clear(const Painter& painter, const VerticalTape& tape, const TapeLayout& parts, float y, float size) {
    const float half = font_atlas().cap_height_em * painter.em_px(size) / 2 + 0.1f * painter.text_px();
    const float bottom = tape.show == ElementShow::flagged ? parts.stale.bottom() : parts.readout.bottom();
    return y + half < parts.readout.y || y - half > bottom;
}

void build_ticks(const Painter& painter, const VerticalTape& tape, const TapeLayout& parts) {
    const TapeScale& scale = parts.scale;
    painter.line({scale.edge, scale.box.y}, {scale.edge, scale.box.bottom()});
    const double first = std::ceil((tape.value - tape.span / 2) / tape.minor_step);
    for (int i = 0; i < kMaxTicks; ++i) {
        const double step = first + i, unit = step * tape.minor_step;
        if (unit > tape.value + tape.span / 2) break;
        if (unit < tape.lowest) continue;
        const float y = scale.y_of(unit), strokes = tick_strokes(tape, step);
        const bool is_major = std::fmod(step, static_cast<double>(tape.majors)) == 0;
        painter.line({scale.edge, y}, {scale.x_of(is_major ? 0.7f : 0.4f, painter), y}, painter.color(SymbolRole::scale),
                     strokes);
        const float size = strokes > 1 ? 1.1f : kTapeTextSize;
        if (is_major && is_number_clear(painter, tape, parts, y, size))
            painter.text(whole_number(unit).view(), {scale.x_of(kNumberInset, painter), y},
                         scale.inwards > 0 ? TextAnchor::left : TextAnchor::right, size);
    }
}

/// A black box whose pointer touches the ticks.
void build_readout(const Painter& painter, const VerticalTape& tape, const TapeLayout& parts) {
    const bool is_flagged = tape.show == ElementShow::flagged;
    const design::Color color = painter.color(is_flagged ? SymbolRole::caution : SymbolRole::scale);
    const Rect& box = parts.readout;
    const float t = painter.text_px(), stroke = painter.stroke_px(), middle = box.center().y;
    const bool points_left = parts.scale.inwards > 0;
    const float near = points_left ? box.x : box.right(), far = points_left ? box.right() : box.x;
    const Point tip{parts.scale.x_of(kPointerEnd, painter), middle};
    const Point above{near, middle - kPointerHalf * t}, below{near, middle + kPointerHalf * t};
    painter.batch().box(box, painter.color(SymbolRole::readout_ground));
    painter.batch().triangle(above, tip, below, painter.color(SymbolRole::readout_ground));
    const Rect inner = box.shrunk(stroke / 2);
    const float near_line = points_left ? inner.x : inner.right(), far_line = far + (points_left ? -stroke : stroke) / 2;
    const Point corners[7] = {{near_line, inner.y}, {near_line, above.y},        tip,
                              {near_line, below.y}, {near_line, inner.bottom()}, {far_line, inner.bottom()},
                              {far_line, inner.y}};
    // Where the pointer lies over the scale; the other sides are at the tape's own edge.
    for (const Point& base : {above, below})
        painter.batch().line({near_line, base.y}, tip, 2.5f * stroke, painter.color(SymbolRole::rim));
    painter.batch().polyline(corners, stroke, color, true);
    build_rolling_digits(painter, box.shrunk(stroke), rolling_digits(tape.value, tape.readout), painter.type().value_large,
                         color);
    if (is_flagged) painter.plate(parts.stale, short_words("STALE"), kTapeTextSize, painter.color(SymbolRole::caution));
}

void build_scale(const Painter& painter, const VerticalTape& tape, const TapeLayout& parts) {
    const TapeScale& scale = parts.scale;
    painter.batch().box(scale.box, painter.color(SymbolRole::tape_ground));
    painter.batch().set_clip(scale.box);
    build_tape_bands(painter, scale, {tape.marks.bands.data(), tape.marks.bands.size()});
    build_ticks(painter, tape, parts);
    if (parts.has_flags) build_tape_flags(painter, scale, {tape.marks.flags.data(), tape.marks.flags.size()});
    build_tape_trend(painter, scale, tape.marks.trend);
    build_tape_minimum(painter, scale, tape.marks.minimum);
    build_tape_bug(painter, scale, tape.marks.bug);
    painter.batch().lift_clip();
    build_readout(painter, tape, parts);
}

}  // namespace

Rect take_top(Rect& box, float height) noexcept {
    const Rect row{box.x, box.y, box.width, height};
    box = {box.x, row.bottom(), box.width, box.height - height};
    return row;
}

TapeLayout tape_layout(const Painter& painter, const VerticalTape& tape) noexcept {
    const float t = painter.text_px(), row = legible_row_px(kTapeRowHeight, t);
    TapeLayout parts;
    Rect rest = tape.box;
    if (tape.selected.show != ElementShow::absent) parts.selected = take_top(rest, row);
    parts.label = take_top(rest, row);
    if (tape.minimum.show != ElementShow::absent) {
        parts.minimum = {rest.x, rest.bottom() - row, rest.width, row};
        rest.height -= row;
    }
    // Where the digits of the readout would have no room beside the flags there are none.
    const float digits = text_width_px("000", painter.em_px(painter.type().value_large)) + 2 * painter.stroke_px();
    const bool has_flags = !tape.marks.flags.empty() && rest.width - (kFlagWidth + kPointerReach) * t >= digits;
    const float beyond = has_flags ? kFlagWidth * t : 0;
    parts.scale.box = rest;
    parts.scale.edge = tape.ticks_right ? rest.right() - beyond : rest.x + beyond;
    parts.scale.inwards = tape.ticks_right ? -1.0f : 1.0f;
    parts.scale.middle = tape.value;
    parts.scale.px_per_unit = static_cast<double>(rest.height) / tape.span;
    const float width = rest.width - beyond - kPointerReach * t, height = std::max(kReadoutHeight * t, kReadoutEms * kMinText_px);
    parts.readout = {tape.ticks_right ? rest.x : rest.right() - width, rest.center().y - height / 2, width, height};
    parts.has_flags = has_flags;
    const bool is_narrow = width < text_width_px("STALE", kMinText_px) + 2 * painter.stroke_px();
    parts.stale = {is_narrow ? rest.x : parts.readout.x, parts.readout.bottom(), is_narrow ? rest.width : width,
                   std::max(kStaleHeight * t, 1.1f * painter.em_px(kTapeTextSize))};
    return parts;
}

void build_vertical_tape(const Painter& painter, const VerticalTape& tape) {
    if (tape.show == ElementShow::absent) return;
    const TapeLayout parts = tape_layout(painter, tape);
    build_tape_row(painter, parts.selected, tape.selected);
    build_tape_row(painter, parts.minimum, tape.minimum);
    if (tape.show == ElementShow::failed) {
        const Rect& scale = parts.scale.box;
        painter.failed({scale.x, parts.label.y, scale.width, scale.bottom() - parts.label.y}, tape.failure);
        return;
    }
    painter.plate(parts.label, label_words(tape.label), kTapeTextSize, painter.label_color(tape.show));
    build_scale(painter, tape, parts);
}

}  // namespace tedavis::draw
