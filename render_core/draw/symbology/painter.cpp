#include "render_core/draw/symbology/painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw {

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

void Painter::line(Point from, Point to, design::Color color, float strokes) const {
    const float width = strokes * layout_.stroke_px;
    batch_.line(from, to, width + layout_.stroke_px, kRimColor);
    batch_.line(from, to, width, color);
}

void Painter::polyline(base::Span<const Point> points, design::Color color, float strokes, bool closed) const {
    const float width = strokes * layout_.stroke_px;
    batch_.polyline(points, width + layout_.stroke_px, kRimColor, closed);
    batch_.polyline(points, width, color, closed);
}

void Painter::text(std::string_view text, Point at, TextAnchor anchor, float size, design::Color color, float angle_rad,
                   TextRim rim) const {
    TextStyle style;
    style.size_px = size * layout_.text_px;
    style.color = color;
    style.halo_px = rim == TextRim::dark ? std::min(1.5f, 0.07f * style.size_px) : 0;
    style.halo_color = kRimColor;
    batch_.text(text, at, anchor, style, angle_rad);
}

void Painter::fitted_text(std::string_view text, const Rect& box, TextAnchor anchor, float size, design::Color color,
                          TextRim rim) const {
    const float pad = 0.2f * layout_.text_px;
    const float room = box.width - 2 * pad, wanted = text_width_px(text, size * layout_.text_px);
    const float fitting = wanted > room ? size * std::max(0.0f, room) / wanted : size;
    const float x = anchor == TextAnchor::left ? box.x + pad : anchor == TextAnchor::center ? box.center().x : box.right() - pad;
    this->text(text, {x, box.center().y}, anchor, fitting, color, 0, rim);
}

void Painter::plate(const Rect& box, std::string_view text, float size, design::Color color) const {
    batch_.box(box, kReadoutGround);
    fitted_text(text, box, TextAnchor::center, size, color, TextRim::none);
}

void Painter::framed_plate(const Rect& box, std::string_view text, float size, design::Color color) const {
    batch_.box(box, kReadoutGround);
    batch_.frame(box, layout_.stroke_px, color);
    fitted_text(text, box, TextAnchor::center, size, color, TextRim::none);
}

void Painter::failed(const Rect& box, std::string_view text) const {
    const Rect inner = box.shrunk(2 * layout_.stroke_px);
    batch_.box(box, kTapeGround);
    line({inner.x, inner.y}, {inner.right(), inner.bottom()}, kWarningColor, 1.5f);
    line({inner.x, inner.bottom()}, {inner.right(), inner.y}, kWarningColor, 1.5f);
    const float height = std::min(1.4f * layout_.text_px, inner.height);
    const float width = std::min(inner.width, text_width_px(text, layout_.text_px) + 0.8f * layout_.text_px);
    framed_plate({box.center().x - width / 2, box.center().y - height / 2, width, height}, text, 0.95f, kWarningColor);
}

void Painter::crossed_out(const Rect& box, std::string_view text) const {
    const Rect cross = box.shrunk(1.5f * layout_.stroke_px);
    batch_.box(box, kReadoutGround);
    line({cross.x, cross.y}, {cross.right(), cross.bottom()}, kWarningColor);
    line({cross.x, cross.bottom()}, {cross.right(), cross.y}, kWarningColor);
    fitted_text(text, box, TextAnchor::center, 0.8f, kCautionColor);
}

void Painter::readout(const Rect& box, std::string_view text, bool flagged) const {
    framed_plate(box, text, 1.15f, flagged ? kCautionColor : kScaleColor);
}

design::Color label_color(policy::ElementShow show) noexcept {
    return show == policy::ElementShow::normal ? kScaleColor : kCautionColor;
}

}  // namespace tedavis::draw
