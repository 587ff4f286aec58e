#include "render_core/draw/symbology/map_symbols.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

using flight::Signal;
using policy::Element;
using policy::ElementShow;

constexpr int kRingSteps = 96;
constexpr int kDiscSteps = 24;

// In texts.
constexpr float kNorthBox = 4.4f;
constexpr float kNorthLabel = 1.1f;
constexpr float kEdge = 0.7f;  // ring to the edge of its box

struct RingLabel {
    double miles;
    std::string_view miles_text;
    double kilometres;
    std::string_view kilometres_text;
};
constexpr RingLabel kRings[] = {{0.05, "0.05 NM", 0.1, "0.1 KM"}, {0.1, "0.1 NM", 0.2, "0.2 KM"}, {0.2, "0.2 NM", 0.5, "0.5 KM"},
                                {0.5, "0.5 NM", 1, "1 KM"},       {1, "1 NM", 2, "2 KM"},         {2, "2 NM", 5, "5 KM"},
                                {5, "5 NM", 10, "10 KM"},         {10, "10 NM", 20, "20 KM"},     {20, "20 NM", 50, "50 KM"},
                                {50, "50 NM", 100, "100 KM"},     {100, "100 NM", 200, "200 KM"}, {200, "200 NM", 500, "500 KM"},
                                {500, "500 NM", 1000, "1000 KM"}};

/// Places of a level plane on the screen: as high as wide from above, lower obliquely.
class Plane {
public:
    explicit Plane(const MapInput& map) : squash_(static_cast<float>(std::sin(map.look_down_rad))) {}

    /// By a direction on the plane, clockwise from the screen's top, and a distance.
    [[nodiscard]] Point off(Point from, double angle_rad, float distance) const {
        return {from.x + distance * static_cast<float>(std::sin(angle_rad)),
                from.y - distance * squash_ * static_cast<float>(std::cos(angle_rad))};
    }
    [[nodiscard]] float squash() const { return squash_; }

private:
    float squash_;
};

template <int kSteps>
void build_circle(const Painter& painter, const Plane& plane, Point center, float radius, design::Color color, float strokes) {
    Point circle[kSteps];
    for (int i = 0; i < kSteps; ++i) circle[i] = plane.off(center, 2 * base::kPi * i / kSteps, radius);
    painter.polyline(circle, color, strokes, true);
}

ShortText times_label(std::string_view what, std::uint32_t power) {
    ShortText label(what);
    label.append(whole_number(std::ldexp(1.0, static_cast<int>(power))).view());
    return label;
}

/// With the factor, where it is the same for all.
ShortText distorted_label(const MapInput& map) {
    for (const MagnifiedSign& sign : map.magnified)
        if (sign.power != map.magnified[0].power) return ShortText("DISTORTED");
    ShortText label = times_label("DISTORTED ", map.magnified[0].power);
    label.append("x");
    return label;
}

float north_label_px(const Painter& painter) { return std::max(kNorthLabel * painter.text_px(), 1.05f * kMinText_px); }

Rect north_plate(const Painter& painter, const MapInput& map) {
    const float t = painter.text_px();
    const Rect& box = painter.layout().attitude;
    const int labels = 1 + (map.is_oblique ? 1 : 0) + (map.is_flat ? 1 : 0) + (map.magnified.empty() ? 0 : 1);
    return {box.x + 0.2f * t, box.y + 0.2f * t, painter.plate_px("NORTH -000", kNorthBox),
            kNorthBox * t + static_cast<float>(labels) * north_label_px(painter)};
}

/// Where nothing is moved: no line of a circle that lies among what is.
bool is_unmoved(const MapInput& map, const Plane& plane, Point at) {
    for (const MagnifiedSign& sign : map.magnified)
        if (std::hypot(at.x - sign.middle.x, (at.y - sign.middle.y) / plane.squash()) <= sign.reach_px) return false;
    return true;
}

void build_broken_circle(const Painter& painter, const MapInput& map, const Plane& plane, Point center, float radius) {
    Point before = plane.off(center, 0, radius);
    for (int i = 1; i <= kRingSteps; ++i) {
        const Point next = plane.off(center, 2 * base::kPi * i / kRingSteps, radius);
        if (is_unmoved(map, plane, before) && is_unmoved(map, plane, next))
            painter.line(before, next, painter.color(SymbolRole::scale), 0.7f);
        before = next;
    }
}

/// Beside the focus: over, under, left or right of it, or in its middle; empty where none of these is clear in the picture.
Rect place_of_sign(const Painter& painter, const MapInput& map, const MagnifiedSign& sign) {
    const Rect& box = painter.layout().attitude;
    const float t = painter.text_px(), wide = painter.plate_px("FOCUS 16x", 4.8f), high = std::max(2.2f * t, 2.1f * kMinText_px);
    const float across = sign.radius_px + 0.5f * wide + 0.2f * t;
    const float down = sign.radius_px * Plane(map).squash() + 0.5f * high + 0.2f * t;
    const Point away[] = {{0, -down}, {0, down}, {-across, 0}, {across, 0}, {0, 0}};
    for (const Point& by : away) {
        const Rect plate{sign.middle.x + by.x - 0.5f * wide, sign.middle.y + by.y - 0.5f * high, wide, high};
        if (box.contains(plate) && !plate.overlaps(north_plate(painter, map))) return plate;
    }
    return {};
}

void build_magnified_signs(const Painter& painter, const MapInput& map) {
    for (const MagnifiedSign& sign : map.magnified) {
        const Rect plate = place_of_sign(painter, map, sign);
        if (!(plate.width > 0)) continue;
        ShortText larger = times_label("FOCUS ", sign.power);
        larger.append("x");
        painter.batch().box(plate, painter.color(SymbolRole::tape_ground));
        Rect row{plate.x, plate.y, plate.width, 0.5f * plate.height};
        painter.fitted_text(larger.view(), row, TextAnchor::center, painter.type().label, painter.color(SymbolRole::scale));
        row.y += row.height;
        painter.fitted_text(times_label("RIM 1/", sign.compression).view(), row, TextAnchor::center, painter.type().label,
                            painter.color(SymbolRole::scale));
    }
}

/// Where the own ship is over the ground, straight below it on the screen; its own place where nothing says how far.
Point foot_of(const Painter& painter, const MapInput& map) {
    Point foot = painter.layout().screen.center();
    const double down_px = map.above_ground_m * std::cos(map.look_down_rad) * map.px_per_m;
    if (map.is_oblique && down_px > 0) foot.y += static_cast<float>(down_px);
    return foot;
}

/// Round the own ship's place on the ground.
void build_ring(const Painter& painter, const MapInput& map, base::DisplayUnits units) {
    const Rect box = conformal_box(painter.layout());
    const Plane plane(map);
    const Point center = foot_of(painter, map);
    const float t = painter.text_px();
    const float room = std::min({center.x - box.x, box.right() - center.x, (center.y - box.y) / plane.squash(),
                                 (box.bottom() - center.y) / plane.squash()});
    const RangeRing ring = range_ring(static_cast<double>(room - kEdge * t), map.px_per_m, units);
    if (!(ring.radius_m > 0)) return;
    const auto radius = static_cast<float>(ring.radius_m * map.px_per_m);
    if (map.magnified.empty())
        build_circle<kRingSteps>(painter, plane, center, radius, painter.color(SymbolRole::scale), 0.7f);
    else
        build_broken_circle(painter, map, plane, center, radius);
    const Point at = plane.off(center, base::radians(135), radius);
    const float wide = painter.plate_px(ring.label, 4), high = std::max(1.2f * t, 1.1f * kMinText_px);
    const Rect plate{at.x - wide / 2, at.y - high / 2, wide, high};
    painter.batch().box(plate, painter.color(SymbolRole::tape_ground));
    painter.fitted_text(ring.label, plate, TextAnchor::center, painter.type().label, painter.color(SymbolRole::scale));
}

/// From the own ship down to its place on the ground.
void build_drop(const Painter& painter, const MapInput& map) {
    const Rect box = conformal_box(painter.layout());
    const Point center = painter.layout().screen.center(), foot = foot_of(painter, map);
    if (!(foot.y > center.y)) return;
    const bool is_shown = foot.y < box.bottom();
    painter.line(center, {foot.x, std::min(foot.y, box.bottom())}, painter.color(SymbolRole::reference));
    if (is_shown)
        build_circle<kDiscSteps>(painter, Plane(map), foot, 0.35f * painter.text_px(), painter.color(SymbolRole::reference), 1);
}

std::string_view up_label(Signal source) {
    if (source == Signal::count_) return "NORTH UP";
    return source == Signal::true_track ? "TRK UP" : "HDG UP";
}

/// What the top is turned to: "TRK UP", and by how much it is turned from there: "TRK+030".
ShortText top_label(const SymbologyInput& input) {
    const std::string_view up = up_label(input.decisions[Element::map_up].source);
    const double turn_deg = std::round(base::degrees(input.map.turn_rad));
    if (turn_deg == 0) return ShortText(up);
    ShortText label(up.substr(0, up.find(' ')));
    label.append(turn_deg < 0 ? "-" : "+");
    label.append(whole_number(std::fabs(turn_deg), 3).view());
    return label;
}

/// In the upper left corner, with what is up and what the picture is below it.
void build_north(const Painter& painter, const SymbologyInput& input) {
    const float t = painter.text_px();
    const MapInput& map = input.map;
    const Rect plate = north_plate(painter, map);
    painter.batch().box(plate, painter.color(SymbolRole::tape_ground));
    const Plane plane(map);
    const Point center{plate.center().x, plate.y + 0.5f * kNorthBox * t};
    const double north = -map.top_rad(), quarter = 0.5 * base::kPi;
    const Point head = plane.off(center, north, 1.1f * t), foot = plane.off(center, north, -1.5f * t);
    const Point neck = plane.off(center, north, 0.1f * t);
    painter.line(foot, neck);
    painter.batch().triangle(head, plane.off(neck, north + quarter, 0.5f * t), plane.off(neck, north - quarter, 0.5f * t),
                             painter.color(SymbolRole::scale));
    painter.text("N", plane.off(center, north, 1.65f * t), TextAnchor::center, 0.8f);
    Rect label{plate.x, plate.y + kNorthBox * t, plate.width, north_label_px(painter)};
    const auto add = [&](std::string_view text, design::Color color) {
        painter.fitted_text({text, text.substr(0, text.find(' '))}, label, TextAnchor::center, 0.8f, color);
        label.y += label.height;
    };
    add(top_label(input).view(), painter.label_color(input.decisions[Element::map_up].show));
    if (map.is_oblique) add("ORTHO", painter.color(SymbolRole::scale));
    if (map.is_flat) add("FLAT", painter.color(SymbolRole::scale));
    if (!map.magnified.empty()) add(distorted_label(map).view(), painter.color(SymbolRole::caution));
}

/// Fuselage, wings and tail from above.
void build_own_ship(const Painter& painter, const SymbologyInput& input) {
    const Point center = painter.layout().screen.center();
    const float t = painter.text_px();
    const bool trusted = input.decisions[Element::position].show == ElementShow::normal;
    const Signal heading = input.decisions.view_heading;
    // A track in the heading's place is not where the nose points.
    const design::Color color =
        painter.color(trusted && heading != Signal::true_track ? SymbolRole::reference : SymbolRole::caution);
    const Plane plane(input.map);
    if (heading == Signal::count_) return build_circle<kDiscSteps>(painter, plane, center, 0.6f * t, color, 2);
    const double ahead = input.view_heading_rad - input.map.top_rad(), quarter = 0.5 * base::kPi;
    const auto across = [&](float along, float half) {
        const Point middle = plane.off(center, ahead, along);
        painter.line(plane.off(middle, ahead - quarter, half), plane.off(middle, ahead + quarter, half), color, 2);
    };
    painter.line(plane.off(center, ahead, 1.1f * t), plane.off(center, ahead, -1.1f * t), color, 2);
    across(0.2f * t, 1.1f * t);
    across(-0.9f * t, 0.45f * t);
}

}  // namespace

RangeRing range_ring(double room_px, double px_per_m, base::DisplayUnits units) noexcept {
    const bool is_metric = units == base::DisplayUnits::metric;
    const base::DisplayUnit unit = base::distance_unit(units);
    RangeRing ring;
    for (const RingLabel& label : kRings) {
        const double radius_m = (is_metric ? label.kilometres : label.miles) * unit.si;
        if (radius_m * px_per_m <= room_px) ring = {radius_m, is_metric ? label.kilometres_text : label.miles_text};
    }
    return ring;
}

void build_map_symbols(const Painter& painter, const SymbologyInput& input) {
    const ElementShow position = input.decisions[Element::position].show;
    const Rect& box = painter.layout().attitude;
    if (position == ElementShow::absent) return;
    if (position == ElementShow::failed) return painter.failed(box, "NO POSITION");
    build_ring(painter, input.map, input.shown.units);
    build_drop(painter, input.map);
    build_magnified_signs(painter, input.map);
    build_north(painter, input);
    build_own_ship(painter, input);
    if (position != ElementShow::flagged) return;
    const float t = painter.text_px();
    const float width = painter.plate_px("POSITION STALE", 9), height = std::max(1.4f * t, 1.2f * kMinText_px);
    painter.framed_plate({box.center().x - width / 2, box.bottom() - height, width, height}, "POSITION STALE", 0.85f,
                         painter.color(SymbolRole::caution));
}

}  // namespace tedavis::draw
