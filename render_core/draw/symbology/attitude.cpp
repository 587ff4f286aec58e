#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/bank_scale.hpp"
#include "render_core/draw/symbology/compass_text.hpp"
#include "render_core/draw/symbology/ladder_frame.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using policy::ElementShow;

/// Box of the ladder: within the arc of the roll scale.
Rect ladder_box(const Layout& layout) {
    const float radius = bank_scale_radius(layout), t = layout.text_px;
    const Point center = layout.screen.center();
    const float top = center.y - radius + 1.2f * t, bottom = std::fmin(center.y + radius, layout.attitude.bottom() - 1.6f * t);
    return {center.x - 0.8f * radius, top, 1.6f * radius, bottom - top};
}

constexpr float kNumberSize = 0.75f;

/// Room that a rung takes beyond its ends and beside them, pixels: with two digits, which are no smaller than the smallest text.
struct RungMargin {
    float along, across;
};
RungMargin margin_of(const Painter& painter, bool has_numbers) {
    const float t = painter.text_px(), em = painter.em_px(kNumberSize);
    if (!has_numbers) return {0.25f * t, 0.25f * t};
    return {0.3f * t + 1.3f * em, std::max(0.5f * t, 0.6f * em)};
}

/// Whether a box holds a rung whole, rims included.
bool holds(const Rect& box, const Point& left, const Point& right, const Point& along, const RungMargin& margin) {
    const float beyond = margin.along, beside = margin.across;
    const Point corners[4] = {along_and_across(left, along, -beyond, -beside), along_and_across(left, along, -beyond, beside),
                              along_and_across(right, along, beyond, -beside), along_and_across(right, along, beyond, beside)};
    return std::all_of(std::begin(corners), std::end(corners), [&](const Point& corner) { return box.contains(corner); });
}

/// Whole, or not at all: part of a rung could be taken for another one.
void build_rung(const Painter& painter, const LadderFrame& ladder, const Rect& room, int degrees) {
    const float t = painter.text_px();
    const bool ten = degrees % 10 == 0;
    const double half = ladder.tangent_of(ten ? 2.6f * t : 1.2f * t), inner = ladder.tangent_of(0.5f * t);
    const double elevation = radians(degrees);
    const ProjectedPoint left = ladder.at(elevation, -half), right = ladder.at(elevation, half);
    const ProjectedPoint left_in = ladder.at(elevation, -inner), right_in = ladder.at(elevation, inner);
    if (!left.in_front || !right.in_front || !left_in.in_front || !right_in.in_front) return;
    const float length = std::hypot(right.at.x - left.at.x, right.at.y - left.at.y);
    if (!(length > 0)) return;
    const Point along{(right.at.x - left.at.x) / length, (right.at.y - left.at.y) / length};
    if (!holds(room, left.at, right.at, along, margin_of(painter, ten))) return;
    if (degrees > 0) {
        painter.line(left.at, right.at);
    } else {  // broken below the horizon
        painter.line(left.at, left_in.at);
        painter.line(right_in.at, right.at);
    }
    if (!ten) return;
    // Ends turn towards the horizon.
    const float hook = (degrees > 0 ? 0.4f : -0.4f) * t;
    painter.line(left.at, along_and_across(left.at, along, 0, hook));
    painter.line(right.at, along_and_across(right.at, along, 0, hook));
    const ShortText number = whole_number(std::abs(degrees));
    const float angle = std::atan2(along.y, along.x);
    painter.text(number.view(), along_and_across(left.at, along, -0.3f * t, 0), TextAnchor::right, kNumberSize,
                 painter.color(SymbolRole::scale), angle);
    painter.text(number.view(), along_and_across(right.at, along, 0.3f * t, 0), TextAnchor::left, kNumberSize,
                 painter.color(SymbolRole::scale), angle);
}

/// Red chevrons that point to the horizon at steep pitch.
void build_chevron(const Painter& painter, const LadderFrame& ladder, int degrees) {
    const float t = painter.text_px();
    const int outwards = degrees > 0 ? 1 : -1;
    const ProjectedPoint tip = ladder.at(radians(degrees - 4 * outwards), 0);
    const ProjectedPoint left = ladder.at(radians(degrees + 4 * outwards), -ladder.tangent_of(2 * t));
    const ProjectedPoint right = ladder.at(radians(degrees + 4 * outwards), ladder.tangent_of(2 * t));
    if (!tip.in_front || !left.in_front || !right.in_front) return;
    const Point corners[3] = {left.at, tip.at, right.at};
    painter.polyline(corners, painter.color(SymbolRole::warning), 3);
}

/// Where the picture's own horizon is seen: across the whole screen, also behind the tapes and the rose, but not behind legends
/// that stand above the attitude.
Rect horizon_box(const Layout& layout) {
    const Rect &box = layout.attitude, &legends = layout.data_legends[1], &key = layout.key.box;
    const bool has_legends_above = (!legends.empty() && legends.bottom() <= box.y) || (!key.empty() && key.bottom() <= box.y);
    const float top = has_legends_above ? box.y : layout.screen.y;
    return {layout.screen.x, top, layout.screen.width, layout.heading.bottom() - top};
}

/// Headings on the horizon line within the attitude: a tick every ten degrees, a label every thirty, in the reference of the
/// heading that is shown. There are none while heading or attitude are not valid, or a magnetic heading's variation is not known.
void build_horizon_headings(const Painter& painter, const SymbologyInput& input, const LadderFrame& ladder) {
    const ElementShow attitude = input.decisions[policy::Element::attitude].show;
    const bool is_known = input.decisions[policy::Element::heading].source != flight::Signal::count_ &&
                          input.decisions.view_heading != flight::Signal::count_ && attitude == ElementShow::normal;
    if (!is_known || !std::isfinite(input.from_true_rad)) return;
    const float t = painter.text_px();
    const Rect room = painter.layout().attitude.shrunk(0.5f * t);
    for (int degrees = 0; degrees < 360; degrees += 10) {
        const double direction = radians(degrees) - input.from_true_rad;
        const ProjectedPoint at = ladder.on_horizon(direction), next = ladder.on_horizon(direction + radians(1));
        if (!at.in_front || !next.in_front || !room.contains(at.at)) continue;
        const float length = std::hypot(next.at.x - at.at.x, next.at.y - at.at.y);
        if (!(length > 0)) continue;
        const Point along{(next.at.x - at.at.x) / length, (next.at.y - at.at.y) / length};
        painter.line(at.at, along_and_across(at.at, along, 0, -0.35f * t));
        const Point label = along_and_across(at.at, along, 0, -0.85f * t);
        if (degrees % 30 == 0 && room.contains(label))
            painter.text(compass_text(degrees).view(), label, TextAnchor::center, 0.75f, painter.color(SymbolRole::scale),
                         std::atan2(along.y, along.x));
    }
}

/// From the middle of the screen to where a line across `direction` (unit) leaves a box.
float support_within(const Rect& box, const Point& center, const Point& direction) {
    const float x = direction.x > 0 ? box.right() - center.x : box.x - center.x,
                y = direction.y > 0 ? box.bottom() - center.y : box.y - center.y;
    return x * direction.x + y * direction.y;
}

/// Where the horizon is on the screen.
struct Horizon {
    bool is_line = false;  ///< false: the view is straight up or down
    double distance = 0;   ///< of the screen's middle below it, pixels
    Point to_ground;       ///< unit direction on the screen
    bool is_seen = false;  ///< it cuts off more than a corner of where it is drawn
};

Horizon horizon_of(const Painter& painter, const SymbologyInput& input) {
    const glm::dmat3& axes = input.view.body_axes;
    // Down component of a screen point's ray: the horizon is where it vanishes.
    const double across = axes[1].z, below = axes[2].z, slope = std::hypot(across, below);
    Horizon horizon;
    if (slope < 1e-9) return horizon;
    horizon.is_line = true;
    horizon.distance = input.view.focal_px * axes[0].z / slope;
    horizon.to_ground = {static_cast<float>(across / slope), static_cast<float>(below / slope)};
    const float sign = horizon.distance > 0 ? -1.0f : 1.0f;
    const Point to_horizon{sign * horizon.to_ground.x, sign * horizon.to_ground.y};
    const Point center = painter.layout().screen.center();
    const float seen_to = support_within(horizon_box(painter.layout()), center, to_horizon) - painter.text_px();
    horizon.is_seen = std::fabs(horizon.distance) <= static_cast<double>(seen_to);
    return horizon;
}

/// A long line at elevation zero wherever it is seen.
void build_horizon(const Painter& painter, const SymbologyInput& input) {
    if (!horizon_of(painter, input).is_seen) return;
    const LadderFrame ladder(input);
    const ProjectedPoint middle = ladder.at(0, 0);
    if (!middle.in_front) return;
    const double wide = ladder.tangent_of(painter.layout().screen.width + painter.layout().screen.height);
    const ProjectedPoint left = ladder.at(0, -wide), right = ladder.at(0, wide);
    if (!left.in_front || !right.in_front) return;
    painter.batch().set_clip(horizon_box(painter.layout()));
    painter.line(left.at, right.at);
    painter.batch().lift_clip();
    if (!input.decisions.unusual_attitude) build_horizon_headings(painter, input, ladder);
}

/// From the middle of the screen to the nearest side of a box, however the horizon lies.
float reach_within(const Rect& box, const Point& center) {
    return std::fmin(std::fmin(center.y - box.y, box.bottom() - center.y), box.width / 2);
}

/// A strip of the other side with the horizon's line, when the horizon itself is out of sight: it is never lost, and never twice.
void build_permanent_horizon(const Painter& painter, const SymbologyInput& input) {
    const Horizon horizon = horizon_of(painter, input);
    if (!horizon.is_line || horizon.is_seen) return;
    const Rect box = ladder_box(painter.layout());
    const Point center = painter.layout().screen.center();
    const bool in_ground = horizon.distance > 0;
    const Point& to_ground = horizon.to_ground;
    const float limit = reach_within(box, center) - painter.text_px();
    const Point along{to_ground.y, -to_ground.x};
    const float shift = in_ground ? -limit : limit, half = 0.45f * box.width, thick = 0.9f * painter.text_px();
    const Point middle{center.x + to_ground.x * shift, center.y + to_ground.y * shift};
    const float strip = in_ground ? -thick / 2 : thick / 2;  // beyond the line, on the horizon's side
    const Point strip_middle{middle.x + to_ground.x * strip, middle.y + to_ground.y * strip};
    painter.batch().set_clip(painter.layout().attitude);
    painter.batch().line({strip_middle.x - along.x * half, strip_middle.y - along.y * half},
                         {strip_middle.x + along.x * half, strip_middle.y + along.y * half}, thick,
                         in_ground ? input.sky : input.ground);
    painter.line({middle.x - along.x * half, middle.y - along.y * half}, {middle.x + along.x * half, middle.y + along.y * half});
    painter.batch().lift_clip();
}

void build_ladder(const Painter& painter, const SymbologyInput& input) {
    const LadderFrame ladder(input);
    const Rect room = ladder_box(painter.layout());
    const int nearest = 5 * static_cast<int>(std::lround(base::degrees(limited(input.pitch_rad, -2, 2)) / 5));
    for (int degrees = nearest - 40; degrees <= nearest + 40; degrees += 5)
        if (degrees != 0 && degrees >= -90 && degrees <= 90) build_rung(painter, ladder, room, degrees);
    if (!input.decisions.unusual_attitude) return;
    painter.batch().set_clip(room);
    for (int degrees : {-75, -55, -35, 35, 55, 75}) build_chevron(painter, ladder, degrees);
    painter.batch().lift_clip();
}

/// Fixed wings and nose: what the ladder is read against.
void build_aircraft_symbol(const Painter& painter) {
    const float t = painter.text_px();
    const Point c = painter.layout().screen.center();
    const Point left[3] = {{c.x - 4.6f * t, c.y}, {c.x - 3.1f * t, c.y}, {c.x - 3.1f * t, c.y + 0.5f * t}};
    const Point right[3] = {{c.x + 4.6f * t, c.y}, {c.x + 3.1f * t, c.y}, {c.x + 3.1f * t, c.y + 0.5f * t}};
    painter.polyline(left, painter.color(SymbolRole::reference), 2);
    painter.polyline(right, painter.color(SymbolRole::reference), 2);
    const Rect nose{c.x - 0.2f * t, c.y - 0.2f * t, 0.4f * t, 0.4f * t};
    painter.batch().box({nose.x - painter.stroke_px(), nose.y - painter.stroke_px(), nose.width + 2 * painter.stroke_px(),
                         nose.height + 2 * painter.stroke_px()},
                        painter.color(SymbolRole::rim));
    painter.batch().box(nose, painter.color(SymbolRole::reference));
}

}  // namespace

void build_attitude(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[policy::Element::attitude].show;
    const Rect& box = painter.layout().attitude;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.failed(box, "ATTITUDE FAIL");
    build_horizon(painter, input);
    build_ladder(painter, input);
    build_permanent_horizon(painter, input);
    build_bank_scale(painter, input);
    build_aircraft_symbol(painter);
    if (show != ElementShow::flagged) return;
    const float t = painter.text_px();
    const float width = painter.plate_px("ATTITUDE STALE", 9), height = std::max(1.4f * t, 1.2f * kMinText_px);
    painter.framed_plate({box.center().x - width / 2, box.bottom() - height, width, height}, "ATTITUDE STALE", 0.85f,
                         painter.color(SymbolRole::caution));
}

}  // namespace tedavis::draw
