#include "render_core/draw/symbology/activity_mark.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

// In texts.
constexpr float kLargestMark = 1.2f, kMarkMargin = 0.4f, kEdge = 0.1f;
constexpr float kHand = 0.75f;  // of the ring's radius
constexpr std::size_t kRingCorners = 12;
constexpr double kWholeTurn_rad = base::radians(360);

Point at_angle(const Point& center, double angle_rad, float radius_px) {
    return {center.x + radius_px * static_cast<float>(std::sin(angle_rad)),
            center.y - radius_px * static_cast<float>(std::cos(angle_rad))};
}

}  // namespace

double activity_angle_rad(base::Time position_time) noexcept {
    const std::int64_t rest_ns = position_time.ns % kActivityTurn.ns;
    const std::int64_t phase_ns = rest_ns < 0 ? rest_ns + kActivityTurn.ns : rest_ns;
    return kWholeTurn_rad * (static_cast<double>(phase_ns) / static_cast<double>(kActivityTurn.ns));
}

Rect activity_mark_box(const Rect& strip, float text_px) noexcept {
    const float side = std::min(std::max(kLargestMark * text_px, kMinText_px), strip.height - 2 * kEdge * text_px);
    return {strip.right() - kMarkMargin * text_px - side, strip.y + (strip.height - side) / 2, side, side};
}

Rect beside_activity_mark(const Rect& strip, float text_px) noexcept {
    return {strip.x, strip.y, activity_mark_box(strip, text_px).x - strip.x, strip.height};
}

bool shows_activity(const SymbologyInput& input, const Rect& strip) noexcept {
    return input.shown.phase && input.position_time.has_value() && strip.width >= kNarrowestWithActivity_px;
}

void build_activity_mark(const Painter& painter, const SymbologyInput& input) {
    const Rect& strip = painter.layout().annunciations;
    if (!shows_activity(input, strip)) return;
    const Rect box = activity_mark_box(strip, painter.text_px());
    const Point center = box.center();
    const float radius_px = box.width / 2 - 1.5f * painter.stroke_px();  // with its rim within the box
    Point ring[kRingCorners];
    for (std::size_t n = 0; n < kRingCorners; ++n)
        ring[n] = at_angle(center, kWholeTurn_rad * static_cast<double>(n) / kRingCorners, radius_px);
    painter.polyline({ring, kRingCorners}, painter.color(SymbolRole::scale), 1, true);
    painter.line(center, at_angle(center, activity_angle_rad(*input.position_time), kHand * radius_px));
}

}  // namespace tedavis::draw
