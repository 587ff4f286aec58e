#include "render_core/draw/symbology/map_symbols.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

using display::Element;
using display::ElementShow;
using flight::Signal;

constexpr int kRingSteps = 96;
constexpr int kDiscSteps = 24;

// In texts.
constexpr float kNorthBox = 4.4f;
constexpr float kNorthLabel = 1.1f;
constexpr float kEdge = 0.7f;  // ring to the edge of its box

struct MilesLabel {
    double miles;
    std::string_view text;
};
constexpr MilesLabel kRings[] = {{0.05, "0.05 NM"}, {0.1, "0.1 NM"}, {0.2, "0.2 NM"}, {0.5, "0.5 NM"}, {1, "1 NM"},
                                 {2, "2 NM"},       {5, "5 NM"},     {10, "10 NM"},   {20, "20 NM"},   {50, "50 NM"},
                                 {100, "100 NM"},   {200, "200 NM"}, {500, "500 NM"}};

/// A place by a direction on the screen, clockwise from up, and a distance.
Point off(Point from, double angle_rad, float distance) {
    return {from.x + distance * static_cast<float>(std::sin(angle_rad)),
            from.y - distance * static_cast<float>(std::cos(angle_rad))};
}

template <int kSteps>
void build_circle(const Painter& painter, Point center, float radius, design::Color color, float strokes) {
    Point circle[kSteps];
    for (int i = 0; i < kSteps; ++i) circle[i] = off(center, 2 * base::kPi * i / kSteps, radius);
    painter.polyline(circle, color, strokes, true);
}

void build_ring(const Painter& painter, const MapInput& map) {
    const Rect& box = painter.layout().attitude;
    const Point center = painter.layout().screen.center();
    const float t = painter.text_px();
    const float room = std::min({center.x - box.x, box.right() - center.x, center.y - box.y, box.bottom() - center.y});
    const RangeRing ring = range_ring(static_cast<double>(room - kEdge * t), map.px_per_m);
    if (!(ring.radius_m > 0)) return;
    const auto radius = static_cast<float>(ring.radius_m * map.px_per_m);
    build_circle<kRingSteps>(painter, center, radius, kScaleColor, 0.7f);
    const Point at = off(center, base::radians(135), radius);
    const Rect plate{at.x - 2 * t, at.y - 0.6f * t, 4 * t, 1.2f * t};
    painter.batch().box(plate, kTapeGround);
    painter.fitted_text(ring.label, plate, TextAnchor::center, 0.8f, kScaleColor);
}

std::string_view up_label(Signal source) {
    if (source == Signal::count_) return "NORTH UP";
    return source == Signal::true_track ? "TRK UP" : "HDG UP";
}

/// In the upper left corner, with what is up below it.
void build_north(const Painter& painter, const SymbologyInput& input) {
    const float t = painter.text_px();
    const Rect& box = painter.layout().attitude;
    const Rect plate{box.x + 0.2f * t, box.y + 0.2f * t, kNorthBox * t, (kNorthBox + kNorthLabel) * t};
    painter.batch().box(plate, kTapeGround);
    const Point center{plate.center().x, plate.y + 0.5f * kNorthBox * t};
    const double north = -input.map.up_rad, quarter = 0.5 * base::kPi;
    const Point head = off(center, north, 1.1f * t), foot = off(center, north, -1.5f * t);
    const Point neck = off(center, north, 0.1f * t);
    painter.line(foot, neck);
    painter.batch().triangle(head, off(neck, north + quarter, 0.5f * t), off(neck, north - quarter, 0.5f * t), kScaleColor);
    painter.text("N", off(center, north, 1.65f * t), TextAnchor::center, 0.8f);
    const display::ElementDecision& up = input.decisions[Element::map_up];
    const Rect label{plate.x, plate.y + kNorthBox * t, plate.width, kNorthLabel * t};
    painter.fitted_text(up_label(up.source), label, TextAnchor::center, 0.8f, label_color(up.show));
}

/// Fuselage, wings and tail from above.
void build_own_ship(const Painter& painter, const SymbologyInput& input) {
    const Point center = painter.layout().screen.center();
    const float t = painter.text_px();
    const bool trusted = input.decisions[Element::position].show == ElementShow::normal;
    const Signal heading = input.decisions.view_heading;
    // A track in the heading's place is not where the nose points.
    const design::Color color = trusted && heading != Signal::true_track ? kReferenceColor : kCautionColor;
    if (heading == Signal::count_) return build_circle<kDiscSteps>(painter, center, 0.6f * t, color, 2);
    const double ahead = input.view_heading_rad - input.map.up_rad, quarter = 0.5 * base::kPi;
    const auto across = [&](float along, float half) {
        const Point middle = off(center, ahead, along);
        painter.line(off(middle, ahead - quarter, half), off(middle, ahead + quarter, half), color, 2);
    };
    painter.line(off(center, ahead, 1.1f * t), off(center, ahead, -1.1f * t), color, 2);
    across(0.2f * t, 1.1f * t);
    across(-0.9f * t, 0.45f * t);
}

}  // namespace

RangeRing range_ring(double room_px, double px_per_m) noexcept {
    RangeRing ring;
    for (const MilesLabel& miles : kRings)
        if (miles.miles * base::kMetresPerNauticalMile * px_per_m <= room_px)
            ring = {miles.miles * base::kMetresPerNauticalMile, miles.text};
    return ring;
}

void build_map_symbols(const Painter& painter, const SymbologyInput& input) {
    const ElementShow position = input.decisions[Element::position].show;
    const Rect& box = painter.layout().attitude;
    if (position == ElementShow::absent) return;
    if (position == ElementShow::failed) return painter.failed(box, "NO POSITION");
    build_ring(painter, input.map);
    build_north(painter, input);
    build_own_ship(painter, input);
    if (position != ElementShow::flagged) return;
    const float t = painter.text_px();
    const Rect plate{box.center().x - 4.5f * t, box.bottom() - 1.4f * t, 9 * t, 1.4f * t};
    painter.framed_plate(plate, "POSITION STALE", 0.85f, kCautionColor);
}

}  // namespace tedavis::draw
