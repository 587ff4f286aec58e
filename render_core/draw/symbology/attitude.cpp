#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using policy::ElementShow;

constexpr int kArcSteps = 24;

/// The view turned to look at ladder places: a direction by elevation and sideways offset from the aircraft's heading.
class Ladder {
public:
    Ladder(const SymbologyInput& input) : view_(input.view), heading_rad_(input.view_heading_rad) {}

    /// `aside`: tangent of the angle to the right of the heading's vertical plane.
    [[nodiscard]] ProjectedPoint at(double elevation_rad, double aside) const {
        const glm::dvec3 right{-std::sin(heading_rad_), std::cos(heading_rad_), 0};
        return project(view_, direction_of(heading_rad_, elevation_rad) + right * aside);
    }
    /// Sideways offset that spans so many pixels near the middle of the screen.
    [[nodiscard]] double tangent_of(float pixels) const { return static_cast<double>(pixels) / view_.focal_px; }

private:
    const ViewFrame& view_;
    double heading_rad_;
};

Point offset(Point from, Point direction, float along, float across) {
    return {from.x + direction.x * along - direction.y * across, from.y + direction.y * along + direction.x * across};
}

float roll_radius(const Layout& layout) {
    const Rect& box = layout.attitude;
    const Point center = layout.screen.center();
    const float up = center.y - box.y - 1.6f * layout.text_px;
    const float down = box.bottom() - center.y;  // where the sky pointer stands in inverted flight
    // The arc with its marks reaches 60 degrees to either side, sin 60 = 0.87; the sky pointer goes all the way around.
    const float room = std::fmin(center.x - box.x, box.right() - center.x);
    const float aside = std::fmin((room - layout.text_px) / 0.87f, room);
    return std::fmin(std::fmin(up, down), aside);
}

/// Box of the ladder: within the arc of the roll scale.
Rect ladder_box(const Layout& layout) {
    const float radius = roll_radius(layout), t = layout.text_px;
    const Point center = layout.screen.center();
    const float top = center.y - radius + 1.2f * t, bottom = std::fmin(center.y + radius, layout.attitude.bottom() - 1.6f * t);
    return {center.x - 0.8f * radius, top, 1.6f * radius, bottom - top};
}

void build_rung(const Painter& painter, const Ladder& ladder, int degrees) {
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
    if (degrees > 0) {
        painter.line(left.at, right.at);
    } else {  // broken below the horizon
        painter.line(left.at, left_in.at);
        painter.line(right_in.at, right.at);
    }
    if (!ten) return;
    // Ends turn towards the horizon.
    const float hook = (degrees > 0 ? 0.4f : -0.4f) * t;
    painter.line(left.at, offset(left.at, along, 0, hook));
    painter.line(right.at, offset(right.at, along, 0, hook));
    const ShortText number = whole_number(std::abs(degrees));
    const float angle = std::atan2(along.y, along.x);
    painter.text(number.view(), offset(left.at, along, -0.3f * t, 0), TextAnchor::right, 0.75f, kScaleColor, angle);
    painter.text(number.view(), offset(right.at, along, 0.3f * t, 0), TextAnchor::left, 0.75f, kScaleColor, angle);
}

/// Red chevrons that point to the horizon at steep pitch.
void build_chevron(const Painter& painter, const Ladder& ladder, int degrees) {
    const float t = painter.text_px();
    const int outwards = degrees > 0 ? 1 : -1;
    const ProjectedPoint tip = ladder.at(radians(degrees - 4 * outwards), 0);
    const ProjectedPoint left = ladder.at(radians(degrees + 4 * outwards), -ladder.tangent_of(2 * t));
    const ProjectedPoint right = ladder.at(radians(degrees + 4 * outwards), ladder.tangent_of(2 * t));
    if (!tip.in_front || !left.in_front || !right.in_front) return;
    const Point corners[3] = {left.at, tip.at, right.at};
    painter.polyline(corners, kWarningColor, 3);
}

/// Where the picture's own horizon is seen: above and below the ladder too, and through the heading's tape, but not behind
/// legends that stand below the attitude.
Rect horizon_box(const Layout& layout) {
    const Rect& box = layout.attitude;
    const bool has_legends_below = layout.data_legends[1].y >= box.bottom();
    return {box.x, layout.screen.y, box.width, (has_legends_below ? box : layout.heading).bottom() - layout.screen.y};
}

/// A long line at elevation zero wherever it is seen.
void build_horizon(const Painter& painter, const SymbologyInput& input) {
    const Ladder ladder(input);
    const ProjectedPoint middle = ladder.at(0, 0);
    if (!middle.in_front) return;
    const double wide = ladder.tangent_of(painter.layout().screen.width + painter.layout().screen.height);
    const ProjectedPoint left = ladder.at(0, -wide), right = ladder.at(0, wide);
    if (!left.in_front || !right.in_front) return;
    painter.batch().set_clip(horizon_box(painter.layout()));
    painter.line(left.at, right.at);
    painter.batch().lift_clip();
}

/// From the middle of the screen to the nearest side of a box, however the horizon lies.
float reach_within(const Rect& box, const Point& center) {
    return std::fmin(std::fmin(center.y - box.y, box.bottom() - center.y), box.width / 2);
}

/// From the middle of the screen to where a line across `direction` (unit) leaves a box.
float support_within(const Rect& box, const Point& center, const Point& direction) {
    const float x = direction.x > 0 ? box.right() - center.x : box.x - center.x,
                y = direction.y > 0 ? box.bottom() - center.y : box.y - center.y;
    return x * direction.x + y * direction.y;
}

/// A strip of the other side with the horizon's line, when the horizon itself is out of sight: it is never lost, and never twice.
void build_permanent_horizon(const Painter& painter, const SymbologyInput& input) {
    const glm::dmat3& axes = input.view.body_axes;
    // Down component of a screen point's ray: the horizon is where it vanishes.
    const double across = axes[1].z, below = axes[2].z, slope = std::hypot(across, below);
    if (slope < 1e-9) return;
    const double distance = input.view.focal_px * axes[0].z / slope;  // of the screen's middle below the horizon
    const Rect box = ladder_box(painter.layout());
    const Point center = painter.layout().screen.center();
    const bool in_ground = distance > 0;
    const Point to_ground{static_cast<float>(across / slope), static_cast<float>(below / slope)};
    const Point to_horizon{in_ground ? -to_ground.x : to_ground.x, in_ground ? -to_ground.y : to_ground.y};
    // Where it cuts off less than a corner it is hardly seen.
    const float seen_to = support_within(horizon_box(painter.layout()), center, to_horizon) - painter.text_px();
    if (std::fabs(distance) <= static_cast<double>(seen_to)) return;
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
    const Ladder ladder(input);
    painter.batch().set_clip(ladder_box(painter.layout()));
    const int nearest = 5 * static_cast<int>(std::lround(base::degrees(limited(input.pitch_rad, -2, 2)) / 5));
    for (int degrees = nearest - 40; degrees <= nearest + 40; degrees += 5)
        if (degrees != 0 && degrees >= -90 && degrees <= 90) build_rung(painter, ladder, degrees);
    if (input.decisions.unusual_attitude)
        for (int degrees : {-75, -55, -35, 35, 55, 75}) build_chevron(painter, ladder, degrees);
    painter.batch().lift_clip();
}

/// Fixed scale of bank with the sky pointer that turns against it.
void build_roll_scale(const Painter& painter, const SymbologyInput& input) {
    const float t = painter.text_px(), radius = roll_radius(painter.layout());
    const Point center = painter.layout().screen.center();
    const auto on_circle = [&](double angle_rad, float r) {
        return Point{center.x + r * static_cast<float>(std::sin(angle_rad)),
                     center.y - r * static_cast<float>(std::cos(angle_rad))};
    };
    Point arc[kArcSteps + 1];
    for (int i = 0; i <= kArcSteps; ++i) arc[i] = on_circle(radians(-60.0 + 120.0 * i / kArcSteps), radius);
    painter.polyline(arc);
    for (int degrees : {-60, -45, -30, -20, -10, 10, 20, 30, 45, 60})
        painter.line(on_circle(radians(degrees), radius),
                     on_circle(radians(degrees), radius + (degrees % 30 == 0 ? 0.8f : 0.45f) * t));
    const Point mark[3] = {on_circle(0, radius),
                           {center.x - 0.4f * t, center.y - radius - 0.7f * t},
                           {center.x + 0.4f * t, center.y - radius - 0.7f * t}};
    painter.batch().triangle(mark[0], mark[1], mark[2], kScaleColor);
    // Right bank turns the sky to the left.
    const double sky = -input.roll_rad;
    const bool beyond = std::fabs(input.roll_rad) > input.unusual.roll_rad;
    const design::Color color = beyond ? kCautionColor : kReferenceColor;
    const Point tip = on_circle(sky, radius - 0.15f * t);
    const Point up{static_cast<float>(std::sin(sky)), -static_cast<float>(std::cos(sky))};
    const Point left = offset(tip, up, -0.9f * t, -0.5f * t), right = offset(tip, up, -0.9f * t, 0.5f * t);
    painter.batch().triangle(tip, left, right, color);
    const Point rim[3] = {tip, left, right};
    painter.batch().polyline(rim, painter.stroke_px(), kRimColor, true);
}

/// Fixed wings and nose: what the ladder is read against.
void build_aircraft_symbol(const Painter& painter) {
    const float t = painter.text_px();
    const Point c = painter.layout().screen.center();
    const Point left[3] = {{c.x - 4.6f * t, c.y}, {c.x - 3.1f * t, c.y}, {c.x - 3.1f * t, c.y + 0.5f * t}};
    const Point right[3] = {{c.x + 4.6f * t, c.y}, {c.x + 3.1f * t, c.y}, {c.x + 3.1f * t, c.y + 0.5f * t}};
    painter.polyline(left, kReferenceColor, 2);
    painter.polyline(right, kReferenceColor, 2);
    const Rect nose{c.x - 0.2f * t, c.y - 0.2f * t, 0.4f * t, 0.4f * t};
    painter.batch().box({nose.x - painter.stroke_px(), nose.y - painter.stroke_px(), nose.width + 2 * painter.stroke_px(),
                         nose.height + 2 * painter.stroke_px()},
                        kRimColor);
    painter.batch().box(nose, kReferenceColor);
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
    build_roll_scale(painter, input);
    build_aircraft_symbol(painter);
    if (show != ElementShow::flagged) return;
    const float t = painter.text_px();
    const Rect plate{box.center().x - 4.5f * t, box.bottom() - 1.4f * t, 9 * t, 1.4f * t};
    painter.framed_plate(plate, "ATTITUDE STALE", 0.85f, kCautionColor);
}

}  // namespace tedavis::draw
