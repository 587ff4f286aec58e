#include "render_core/draw/symbology/painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw {

namespace {

constexpr float kMinRims_px = 3;  // both sides: smoothed edges take half a pixel of each, and one must stay dark

/// Moved so that it lies in the part of the display in which `box` lies.
Rect kept_in_part(const Rect& place, const Rect& box, const Layout& layout) {
    constexpr float kRounding_px = 0.01f;
    for (const Rect* part : {&layout.heading, &layout.attitude}) {
        if (!part->shrunk(-kRounding_px).contains(box) || place.width > part->width || place.height > part->height) continue;
        return {std::clamp(place.x, part->x, part->right() - place.width),
                std::clamp(place.y, part->y, part->bottom() - place.height), place.width, place.height};
    }
    return place;
}

float with_rims(float width_px, float stroke_px) { return width_px + std::max(stroke_px, kMinRims_px); }

}  // namespace

double limited(double value, double low, double high) noexcept {
    if (!(value > low)) return low;
    return value < high ? value : high;
}

ShortText whole_number(double value, int digits) noexcept {
    char text[24];
    const long rounded = std::lround(limited(value, -9'999'999, 9'999'999));
    std::snprintf(text, sizeof text, "%s%0*ld", rounded < 0 ? "-" : "", digits, rounded < 0 ? -rounded : rounded);
    return ShortText(text);
}

ShortText tenths(double value) noexcept {
    char text[24];
    const long rounded = std::lround(10 * limited(value, -999'999, 999'999)), size = rounded < 0 ? -rounded : rounded;
    std::snprintf(text, sizeof text, "%s%ld.%ld", rounded < 0 ? "-" : "", size / 10, size % 10);
    return ShortText(text);
}

float Painter::plate_px(std::string_view text, float texts) const {
    return std::max(texts * text_px(), text_width_px(text, kMinText_px) + 4 * stroke_px());
}

void Painter::line(Point from, Point to, design::Color color, float strokes) const {
    const float width = strokes * layout_.stroke_px;
    batch_.line(from, to, with_rims(width, layout_.stroke_px), this->color(SymbolRole::rim));
    batch_.line(from, to, width, color);
}

void Painter::polyline(base::Span<const Point> points, design::Color color, float strokes, bool closed) const {
    const float width = strokes * layout_.stroke_px;
    batch_.polyline(points, with_rims(width, layout_.stroke_px), this->color(SymbolRole::rim), closed);
    batch_.polyline(points, width, color, closed);
}

void Painter::text(std::string_view text, Point at, TextAnchor anchor, float size, design::Color color, float angle_rad,
                   TextRim rim) const {
    TextStyle style;
    style.size_px = em_px(size);
    style.color = color;
    style.halo_px = rim == TextRim::dark ? std::min(1.5f, 0.07f * style.size_px) : 0;
    style.halo_color = this->color(SymbolRole::rim);
    batch_.text(text, at, anchor, style, angle_rad);
}

void Painter::fitted_text(const Words& words, const Rect& box, TextAnchor anchor, float size, design::Color color,
                          TextRim rim) const {
    const float wanted_em = em_px(size);
    float pad = 0.2f * layout_.text_px;
    // The smallest text may come nearer to the sides.
    if (text_width_px(words.longest(), kMinText_px) > box.width - 2 * pad) pad = std::min(pad, layout_.stroke_px);
    const float room = std::max(0.0f, box.width - 2 * pad);
    const std::string_view text = words.within(room, kMinText_px);
    const float wanted = text_width_px(text, wanted_em);
    const float em = wanted > room ? std::max(kMinText_px, wanted_em * room / wanted) : wanted_em;
    const FittedText fitting = cut_words(text, room, em);
    const float x = anchor == TextAnchor::left ? box.x + pad : anchor == TextAnchor::center ? box.center().x : box.right() - pad;
    this->text(fitting.view(), {x, box.center().y}, anchor, em / layout_.text_px, color, 0, rim);
}

void Painter::plate(const Rect& box, const Words& words, float size, design::Color color) const {
    batch_.box(box, this->color(SymbolRole::readout_ground));
    fitted_text(words, box, TextAnchor::center, size, color, TextRim::none);
}

void Painter::framed_plate(const Rect& box, const Words& words, float size, design::Color color) const {
    batch_.box(box, this->color(SymbolRole::readout_ground));
    batch_.frame(box, layout_.stroke_px, color);
    fitted_text(words, box, TextAnchor::center, size, color, TextRim::none);
}

void Painter::failed(const Rect& box, std::string_view text) const {
    const Rect inner = box.shrunk(2 * layout_.stroke_px);
    batch_.box(box, this->color(SymbolRole::tape_ground));
    line({inner.x, inner.y}, {inner.right(), inner.bottom()}, this->color(SymbolRole::warning), 1.5f);
    line({inner.x, inner.bottom()}, {inner.right(), inner.y}, this->color(SymbolRole::warning), 1.5f);
    const float em = em_px(0.95f), pads = 0.8f * layout_.text_px;
    const std::size_t blank = text.find(' ');
    const float room = inner.width - 2 * layout_.stroke_px;
    const bool is_narrow = blank != std::string_view::npos && text_width_px(text, kMinText_px) > room;
    const bool has_two_rows = inner.height >= 2.1f * em && text_width_px(text.substr(blank + 1), kMinText_px) <= room;
    if (is_narrow && !has_two_rows) text = text.substr(0, blank);  // the cross says that it failed
    if (is_narrow && has_two_rows) {
        const float row = std::min(1.2f * em, inner.height / 2), width = inner.width;
        framed_plate({inner.x, box.center().y - row, width, row}, text.substr(0, blank), 0.95f, this->color(SymbolRole::warning));
        return framed_plate({inner.x, box.center().y, width, row}, text.substr(blank + 1), 0.95f,
                            this->color(SymbolRole::warning));
    }
    const float height = std::min(std::max(1.4f * layout_.text_px, 1.2f * em), inner.height);
    const float width = std::min(inner.width, text_width_px(text, std::max(layout_.text_px, em)) + pads);
    framed_plate({box.center().x - width / 2, box.center().y - height / 2, width, height}, text, 0.95f,
                 this->color(SymbolRole::warning));
}

void Painter::crossed_out(const Rect& box, std::string_view text) const {
    const float width = std::max(box.width, text_width_px(text, kMinText_px) + 2 * layout_.stroke_px);
    const float height = std::max(box.height, kMinText_px);
    const Rect grown{box.center().x - width / 2, box.center().y - height / 2, width, height};
    const Rect place = kept_in_part(grown, box, layout_);
    const Rect cross = place.shrunk(1.5f * layout_.stroke_px);
    batch_.box(place, this->color(SymbolRole::readout_ground));
    line({cross.x, cross.y}, {cross.right(), cross.bottom()}, this->color(SymbolRole::warning));
    line({cross.x, cross.bottom()}, {cross.right(), cross.y}, this->color(SymbolRole::warning));
    fitted_text(text, place, TextAnchor::center, type().label, this->color(SymbolRole::caution));
}

void Painter::readout(const Rect& box, std::string_view text, bool flagged) const {
    framed_plate(box, text, type().value, this->color(flagged ? SymbolRole::caution : SymbolRole::scale));
}

design::Color Painter::label_color(policy::ElementShow show) const {
    return this->color(show == policy::ElementShow::normal ? SymbolRole::scale : SymbolRole::caution);
}

}  // namespace tedavis::draw
