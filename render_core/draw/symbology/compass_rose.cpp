#include "render_core/draw/symbology/compass_rose.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/compass_text.hpp"
#include "render_core/draw/symbology/short_words.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using policy::Element;
using policy::ElementShow;

// In texts.
constexpr float kRoseReadout = 1.55f;
constexpr float kAboveScale = 2.1f;  // readout, and what stands outside the scale
constexpr float kAroundScale = 0.6f;
constexpr float kRoseRow = 1.2f;
constexpr float kRowsTop = 0.1f;
constexpr float kReadoutEms = 2.4f;  // three digits in their frame, in ems of the smallest text
constexpr float kMaxSideText = 5.2f;
constexpr float kSideTextEms = 4.7f;  // the same in the smallest text
constexpr float kCrossedText = 3.3f;
constexpr float kCardText = 0.7f;
constexpr float kMarkText = 0.8f;

constexpr float kMinWholeRadius = 4.5f;     // texts
constexpr float kMarksAcrossRadius = 5.0f;  // the unit of marks on a small rose
constexpr float kShownBelowCenter = 0.32f;  // of the radius, where the rose is cut
// In the unit of marks.
constexpr float kTenTick = 0.6f;
constexpr float kFiveTick = 0.35f;

constexpr float kMinTickGap_px = 4;
constexpr double kTrend_s = 6;
constexpr double kMaxTurnRate_degps = 4;
constexpr int kTrendSteps = 8;

/// Degrees between labels: 30, or 90 where those would touch.
int label_step(float label_radius, float label_px) {
    const auto apart = static_cast<float>(2 * label_radius * std::sin(radians(15)));
    return apart >= 1.1f * text_width_px("33", label_px) ? 30 : 90;
}

/// Amber where the value is old.
design::Color mark_color(const SymbologyInput& input, Element element, SymbolRole role) {
    return input.palette.color(input.decisions[element].show == ElementShow::flagged ? SymbolRole::caution : role);
}

/// A block outside the scale with a notch at the direction.
void build_heading_bug(const Painter& painter, const CompassRose& rose, double angle, design::Color color) {
    const float m = rose.mark_px, inner = rose.radius + 0.02f * m, outer = rose.radius + 0.5f * m;
    const Point corners[5] = {rose.at(angle, outer, -0.5f * m), rose.at(angle, outer, 0.5f * m), rose.at(angle, inner, 0.5f * m),
                              rose.at(angle, rose.radius + 0.28f * m), rose.at(angle, inner, -0.5f * m)};
    painter.batch().polyline(corners, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(corners[0], corners[3], corners[4], color);
    painter.batch().triangle(corners[0], corners[1], corners[3], color);
    painter.batch().triangle(corners[1], corners[2], corners[3], color);
}

/// A thin line through the center that ends in an open arrow.
void build_bearing_pointer(const Painter& painter, const CompassRose& rose, double angle, design::Color color) {
    const float m = rose.mark_px, tip = rose.radius - 0.1f * m, barb = tip - 0.7f * m, near = 0.45f * rose.radius;
    const Point arrow[3] = {rose.at(angle, barb, -0.35f * m), rose.at(angle, tip), rose.at(angle, barb, 0.35f * m)};
    painter.line(rose.at(angle, near), arrow[1], color, 0.8f);
    painter.polyline(arrow, color, 0.8f);
    painter.line(rose.at(angle, -near), rose.at(angle, -tip), color, 0.8f);
}

/// A diamond across the scale.
void build_track_mark(const Painter& painter, const CompassRose& rose, double angle) {
    const float half = 0.42f * rose.mark_px;
    const Point corners[4] = {rose.at(angle, rose.radius), rose.at(angle, rose.radius - half, 0.7f * half),
                              rose.at(angle, rose.radius - 2 * half), rose.at(angle, rose.radius - half, -0.7f * half)};
    painter.polyline(corners, painter.color(SymbolRole::scale), 1, true);
}

struct SideText {
    Element element;
    std::string_view name;
    Rect place, cross;  ///< of the text, and of the name when it is crossed out
    TextAnchor anchor;
};

/// The name with the value in the rose's reference, or the crossed-out name.
void build_direction_text(const Painter& painter, const SymbologyInput& input, const SideText& side, double true_rad) {
    if (input.decisions[side.element].show == ElementShow::absent) return;
    if (!shows_value(input.decisions[side.element].show)) return painter.crossed_out(side.cross, side.name);
    ShortText text(side.name);
    text.append(" ");
    text.append(rose_degrees(input, true_rad).view());
    painter.fitted_text({text.view(), text.view().substr(side.name.size() + 1), ""}, side.place, side.anchor,
                        legible_size(kMarkText, painter.text_px()), mark_color(input, side.element, SymbolRole::selected));
}

/// Names what is old: its color says which value.
void build_stale_row(const Painter& painter, const CompassRose& rose, const SymbologyInput& input) {
    for (const Element element : {Element::selected_heading, Element::waypoint_bearing, Element::turn_rate}) {
        if (input.decisions[element].show != ElementShow::flagged) continue;
        return painter.fitted_text(short_words_or_none("STALE"), rose.side_row(RoseSide::right, 2), TextAnchor::right,
                                   legible_size(kMarkText, painter.text_px()), painter.color(SymbolRole::caution));
    }
}

}  // namespace

Point CompassRose::at(double angle_rad, float distance, float across) const noexcept {
    const auto sine = static_cast<float>(std::sin(angle_rad)), cosine = static_cast<float>(std::cos(angle_rad));
    return {center.x + distance * sine + across * cosine, center.y - distance * cosine + across * sine};
}

Rect CompassRose::side_row(RoseSide side, int row) const noexcept {
    const float height = legible_row_px(kRoseRow, text_px);
    const bool at_foot = is_whole && row >= kRoseRows / 2;
    const float y = at_foot ? card.bottom() - static_cast<float>(kRoseRows - row) * height
                            : card.y + kRowsTop * text_px + static_cast<float>(row) * height;
    // The nearer of its edges to the center's height says how far the card reaches.
    const float nearest = std::clamp(center.y, y, y + height) - center.y, reach = radius + kAroundScale * text_px;
    const float half_card = std::sqrt(std::max(0.0f, reach * reach - nearest * nearest));
    const float longest = std::max(kMaxSideText * text_px, kSideTextEms * kMinText_px);
    const float outer = std::min(box.width / 2, reach + longest), width = outer - half_card;
    return {side == RoseSide::left ? center.x - outer : center.x + half_card, y, width, height};
}

Rect CompassRose::side_cross(RoseSide side, int row) const noexcept {
    const Rect place = side_row(side, row);
    const float width = std::min(place.width, kCrossedText * text_px);
    return {side == RoseSide::left ? place.x : place.right() - width, place.y, width, place.height};
}

CompassRose make_compass_rose(const Layout& layout) noexcept {
    CompassRose rose;
    const float t = layout.text_px;
    rose.text_px = t;
    rose.box = layout.heading;
    const float readout = legible_row_px(kRoseReadout, t), above = kAboveScale * t + (readout - kRoseReadout * t);
    const float digits = std::max(3.2f * t, kReadoutEms * kMinText_px);
    rose.readout = {rose.box.center().x - digits / 2, rose.box.y, digits, readout};
    rose.card = {rose.box.x, rose.readout.bottom(), rose.box.width, rose.box.height - rose.readout.height};
    const float below = rose.box.height - above, aside = rose.box.width / 2 - kAroundScale * t;
    const float whole = (below - kAroundScale * t) / 2;
    rose.is_whole = whole >= kMinWholeRadius * t;
    const auto rows_in_card = static_cast<int>((rose.card.height - kRowsTop * t) / legible_row_px(kRoseRow, t));
    rose.rows = std::clamp(rows_in_card, kMinRoseRows, kRoseRows);
    rose.radius = std::min(rose.is_whole ? whole : below / (1 + kShownBelowCenter), aside);
    rose.mark_px = std::min(t, rose.radius / kMarksAcrossRadius);
    rose.center = {rose.box.center().x, rose.box.y + above + rose.radius};
    return rose;
}

double rose_angle_rad(const SymbologyInput& input, double true_rad) noexcept {
    if (std::isnan(input.from_true_rad)) return std::nan("");
    const double direction = limited(true_rad, -100, 100) + limited(input.from_true_rad, -100, 100);
    return earth::angle_difference(direction, limited(input.heading_rad, -100, 100));
}

ShortText rose_degrees(const SymbologyInput& input, double true_rad) noexcept {
    const double shown = rose_angle_rad(input, true_rad) + limited(input.heading_rad, -100, 100);
    return whole_number(static_cast<int>(std::lround(base::degrees(earth::wrap_heading(shown)))) % 360, 3);
}

void build_rose_card(const Painter& painter, const CompassRose& rose, double heading_rad) {
    const float t = rose.text_px, m = rose.mark_px, size = legible_size(kCardText, painter.text_px());
    const float label_radius = rose.radius - kTenTick * m - (0.15f + 0.5f * size) * t;
    const int labels = label_step(label_radius, size * t);
    const int ticks = rose.radius * static_cast<float>(radians(5)) >= kMinTickGap_px ? 5 : 10;
    for (int degrees = 0; degrees < 360; degrees += ticks) {
        const double angle = radians(degrees) - heading_rad;
        const bool is_ten = degrees % 10 == 0;
        const float length = (is_ten ? kTenTick : kFiveTick) * m;
        painter.line(rose.at(angle, rose.radius - length), rose.at(angle, rose.radius), painter.color(SymbolRole::scale),
                     is_ten ? 1 : 0.7f);
        if (degrees % labels == 0)
            painter.text(compass_text(degrees).view(), rose.at(angle, label_radius), TextAnchor::center, size,
                         painter.color(SymbolRole::scale), static_cast<float>(earth::angle_difference(angle, 0)));
    }
}

void build_lubber_line(const Painter& painter, const CompassRose& rose) {
    const float m = rose.mark_px;
    const Point tip = rose.at(0, rose.radius), left = rose.at(0, rose.radius + 0.45f * m, -0.35f * m),
                right = rose.at(0, rose.radius + 0.45f * m, 0.35f * m);
    const Point rim[3] = {tip, left, right};
    painter.batch().polyline(rim, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(tip, left, right, painter.color(SymbolRole::scale));
    painter.line(tip, rose.at(0, rose.radius - kTenTick * m));
}

void build_turn_trend(const Painter& painter, const CompassRose& rose, const SymbologyInput& input) {
    if (!shows_value(input.decisions[Element::turn_rate].show)) return;
    const float m = rose.mark_px;
    for (const double rates : {-1.0, -0.5, 0.5, 1.0}) {
        const double angle = rates * input.standard_turn_radps * kTrend_s;
        painter.line(rose.at(angle, rose.radius + 0.1f * m), rose.at(angle, rose.radius + 0.5f * m));
    }
    const double limit = radians(kMaxTurnRate_degps);
    const double end = limited(input.guidance.turn_rate_radps, -limit, limit) * kTrend_s;
    Point arc[kTrendSteps + 1];
    for (int i = 0; i <= kTrendSteps; ++i) arc[i] = rose.at(end * i / kTrendSteps, rose.radius + 0.22f * m);
    painter.polyline(arc, mark_color(input, Element::turn_rate, SymbolRole::scale), 2);
}

void build_rose_marks(const Painter& painter, const CompassRose& rose, const SymbologyInput& input) {
    if (std::isnan(input.from_true_rad)) return;
    const auto angle = [&](double true_rad) { return rose_angle_rad(input, true_rad); };
    const auto color = [&](Element element) { return mark_color(input, element, SymbolRole::selected); };
    // On a rose that the track itself turns, its mark would say nothing.
    if (input.shows_track && input.decisions[Element::heading].source != flight::Signal::true_track)
        build_track_mark(painter, rose, angle(input.track_rad));
    if (shows_value(input.decisions[Element::waypoint_bearing].show))
        build_bearing_pointer(painter, rose, angle(input.guidance.waypoint_bearing_rad), color(Element::waypoint_bearing));
    if (shows_value(input.decisions[Element::selected_heading].show))
        build_heading_bug(painter, rose, angle(input.guidance.selected_heading_rad), color(Element::selected_heading));
}

void build_rose_texts(const Painter& painter, const CompassRose& rose, const SymbologyInput& input) {
    const float t = rose.text_px, left = rose.readout.right() + 2.8f * t;
    const Rect selected{left, rose.box.y, rose.box.right() - left, rose.readout.height};
    const ElementShow heading = input.decisions[Element::heading].show;
    if (heading == ElementShow::flagged) {
        // STALE stands there already, and nothing has a place on an old card.
    } else if (std::isnan(input.from_true_rad)) {
        painter.fitted_text("VAR", selected, TextAnchor::left, legible_size(kMarkText, painter.text_px()),
                            painter.color(SymbolRole::caution));
    } else {
        const Rect cross{selected.x, selected.y, std::min(selected.width, kCrossedText * t), kRoseRow * t};
        build_direction_text(painter, input, {Element::selected_heading, "SEL", selected, cross, TextAnchor::left},
                             input.guidance.selected_heading_rad);
        build_direction_text(painter, input,
                             {Element::waypoint_bearing, "BRG", rose.side_row(RoseSide::right, 0),
                              rose.side_cross(RoseSide::right, 0), TextAnchor::right},
                             input.guidance.waypoint_bearing_rad);
    }
    const ElementShow show = input.decisions[Element::turn_rate].show;
    if (show == ElementShow::failed) painter.crossed_out(rose.side_cross(RoseSide::right, 1), "TURN");
    if (show == ElementShow::flagged)
        painter.fitted_text({"TURN", ""}, rose.side_row(RoseSide::right, 1), TextAnchor::right,
                            legible_size(kMarkText, painter.text_px()), painter.color(SymbolRole::caution));
    build_stale_row(painter, rose, input);
}

}  // namespace tedavis::draw
