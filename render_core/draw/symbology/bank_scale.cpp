#include "render_core/draw/symbology/bank_scale.hpp"

#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using policy::ElementShow;

constexpr int kArcSteps = 24;
constexpr float kSlipWidth = 1.3f, kSlipHeight = 0.32f;  // texts

/// The circle of the scale.
class BankCircle {
public:
    explicit BankCircle(const Layout& layout) : center_(layout.screen.center()), radius_(bank_scale_radius(layout)) {}

    [[nodiscard]] float radius() const { return radius_; }
    /// Clockwise from the top, `out` pixels beyond the scale.
    [[nodiscard]] Point at(double angle_rad, float out = 0) const {
        return {center_.x + (radius_ + out) * static_cast<float>(std::sin(angle_rad)),
                center_.y - (radius_ + out) * static_cast<float>(std::cos(angle_rad))};
    }
    [[nodiscard]] static Point outwards(double angle_rad) {
        return {static_cast<float>(std::sin(angle_rad)), -static_cast<float>(std::cos(angle_rad))};
    }

private:
    Point center_;
    float radius_;
};

void build_ticks(const Painter& painter, const BankCircle& circle) {
    const float t = painter.text_px();
    Point arc[kArcSteps + 1];
    for (int i = 0; i <= kArcSteps; ++i) arc[i] = circle.at(radians(-60.0 + 120.0 * i / kArcSteps));
    painter.polyline(arc);
    for (int degrees : {-60, -45, -30, -20, -10, 10, 20, 30, 45, 60})
        painter.line(circle.at(radians(degrees)), circle.at(radians(degrees), (degrees % 30 == 0 ? 0.8f : 0.45f) * t));
    const Point zero = circle.at(0);
    const Point corners[3] = {zero, {zero.x - 0.4f * t, zero.y - 0.7f * t}, {zero.x + 0.4f * t, zero.y - 0.7f * t}};
    painter.batch().polyline(corners, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(corners[0], corners[1], corners[2], painter.color(SymbolRole::scale));
}

void build_slip(const Painter& painter, const SymbologyInput& input, const BankCircle& circle, double sky_rad) {
    const ElementShow show = input.decisions[policy::Element::slip].show;
    if (show == ElementShow::absent) return;
    const float t = painter.text_px();
    const Point up = BankCircle::outwards(sky_rad);
    // Below the pointer's base, which lies 1.05 texts inside the scale.
    const Point base = circle.at(sky_rad, -1.2f * t);
    if (show == ElementShow::failed) {
        const Point middle = along_and_across(base, up, -0.7f * t, 0);
        return painter.crossed_out({middle.x - 1.4f * t, middle.y - 0.6f * t, 2.8f * t, 1.2f * t}, "SLIP");
    }
    const double widths = limited(-input.guidance.slip_mps2 / kSlipWidth_mps2, -kMaxSlipWidths, kMaxSlipWidths);
    const float aside = static_cast<float>(widths) * kSlipWidth * t, half = kSlipWidth * t / 2;
    // `across` turns right of the direction that points up the picture.
    const Point corners[4] = {
        along_and_across(base, up, 0, aside - 0.8f * half), along_and_across(base, up, 0, aside + 0.8f * half),
        along_and_across(base, up, -kSlipHeight * t, aside + half), along_and_across(base, up, -kSlipHeight * t, aside - half)};
    const design::Color color = painter.color(show == ElementShow::flagged ? SymbolRole::caution : SymbolRole::reference);
    painter.batch().triangle(corners[0], corners[1], corners[2], color);
    painter.batch().triangle(corners[0], corners[2], corners[3], color);
    painter.batch().polyline(corners, painter.stroke_px(), painter.color(SymbolRole::rim), true);
    if (show == ElementShow::flagged)
        painter.text("STALE", along_and_across(base, up, -1.1f * t, 0), TextAnchor::center, 0.75f,
                     painter.color(SymbolRole::caution));
}

/// Right bank turns the sky to the left.
void build_pointer(const Painter& painter, const BankCircle& circle, double sky_rad, design::Color color) {
    const float t = painter.text_px();
    const Point tip = circle.at(sky_rad, -0.15f * t), up = BankCircle::outwards(sky_rad);
    const Point left = along_and_across(tip, up, -0.9f * t, -0.5f * t), right = along_and_across(tip, up, -0.9f * t, 0.5f * t);
    painter.batch().triangle(tip, left, right, color);
    const Point rim[3] = {tip, left, right};
    painter.batch().polyline(rim, painter.stroke_px(), painter.color(SymbolRole::rim), true);
}

}  // namespace

Point along_and_across(Point from, Point direction, float along, float across) noexcept {
    return {from.x + direction.x * along - direction.y * across, from.y + direction.y * along + direction.x * across};
}

float bank_scale_radius(const Layout& layout) noexcept {
    const Rect& box = layout.attitude;
    const Point center = layout.screen.center();
    const float up = center.y - box.y - 1.6f * layout.text_px;
    // Where the sky pointer stands in inverted flight: over the rose.
    const float down = conformal_box(layout).bottom() - center.y;
    // The arc with its marks reaches 60 degrees to either side, sin 60 = 0.87; the sky pointer goes all the way around.
    const float room = std::fmin(center.x - box.x, box.right() - center.x);
    const float aside = std::fmin((room - layout.text_px) / 0.87f, room);
    // Wind and temperature stand in the corner above the arc, which keeps a text from them.
    const float beside_air = std::hypot(layout.air.x - center.x, center.y - layout.air.bottom()) - 1.2f * layout.text_px;
    return std::fmin(std::fmin(up, down), std::fmin(aside, beside_air));
}

void build_bank_scale(const Painter& painter, const SymbologyInput& input) {
    const BankCircle circle(painter.layout());
    const double sky_rad = -input.roll_rad;
    const bool is_excessive = std::fabs(input.roll_rad) > input.excessive_bank_rad;
    build_ticks(painter, circle);
    build_pointer(painter, circle, sky_rad, painter.color(is_excessive ? SymbolRole::caution : SymbolRole::reference));
    if (!input.decisions.unusual_attitude) build_slip(painter, input, circle, sky_rad);
    if (is_excessive && !input.decisions.unusual_attitude)
        painter.text("BANK", circle.at(0, 1.2f * painter.text_px()), TextAnchor::center, 0.85f,
                     painter.color(SymbolRole::caution));
}

}  // namespace tedavis::draw
