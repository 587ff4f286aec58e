#include "render_core/draw/symbology/course_deviation.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/short_words.hpp"

namespace tedavis::draw {
namespace {

using base::radians;
using flight::NavigationSource;
using policy::Element;
using policy::ElementShow;

constexpr float kDot = 0.14f;      // spacing of the lateral dots, of the rose's radius
constexpr float kBarHalf = 0.46f;  // half the bar's length, of the rose's radius
constexpr int kDotSides = 8;
constexpr double kMaxDots = 2;

// In the unit of marks.
constexpr float kDotRadius = 0.15f;
constexpr float kBarWidth = 0.26f;

// In texts.
constexpr float kCourseText = 0.8f;

bool is_radio(NavigationSource source) { return source == NavigationSource::radio1 || source == NavigationSource::radio2; }

design::Color source_color(const SymbologyInput& input, Element element) {
    if (input.decisions[element].show == ElementShow::flagged) return input.palette.color(SymbolRole::caution);
    return input.palette.color(is_radio(input.guidance.navigation_source) ? SymbolRole::engaged : SymbolRole::gnss_course);
}

/// Without a statement of the source nothing says whose deviation is lost.
bool has_lost_source(const SymbologyInput& input) {
    return input.decisions[Element::navigation_source].show == ElementShow::failed ||
           input.guidance.navigation_source == NavigationSource::none;
}

std::string_view lateral_name(const SymbologyInput& input) {
    switch (input.guidance.navigation_source) {
        case NavigationSource::none: break;
        case NavigationSource::radio1: return "LOC1";
        case NavigationSource::radio2: return "LOC2";
        case NavigationSource::gnss: return "GPS";
    }
    return "NAV";
}

/// A deviation as dots, and whether it is beyond the last.
struct DotsOff {
    double dots = 0;
    bool is_beyond = false;
};
DotsOff dots_off(double deviation, double two_dots) {
    const double dots = two_dots > 0 ? kMaxDots * deviation / two_dots : 0;
    return {limited(dots, -kMaxDots, kMaxDots), !(std::fabs(dots) <= kMaxDots)};
}

void build_dot(const Painter& painter, Point center, float radius) {
    Point circle[kDotSides];
    for (int i = 0; i < kDotSides; ++i) {
        const double angle = 2 * base::kPi * i / kDotSides;
        circle[i] = {center.x + radius * static_cast<float>(std::cos(angle)),
                     center.y + radius * static_cast<float>(std::sin(angle))};
    }
    painter.polyline(circle, painter.color(SymbolRole::scale), 1, true);
}

/// Filled, or its outline where the deviation is beyond the scale.
void build_shape(const Painter& painter, const Point (&corners)[4], design::Color color, bool is_hollow) {
    if (is_hollow) return painter.polyline(corners, color, 0.9f, true);
    painter.batch().polyline(corners, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(corners[0], corners[1], corners[2], color);
    painter.batch().triangle(corners[0], corners[2], corners[3], color);
}

/// The arrow through the card, without its middle, where the bar moves.
void build_needle(const Painter& painter, const CompassRose& rose, double angle, design::Color color) {
    const float m = rose.mark_px, tip = rose.radius - 0.1f * m, neck = tip - 0.9f * m, inner = (kBarHalf + 0.04f) * rose.radius;
    painter.line(rose.at(angle, inner), rose.at(angle, neck), color, 1.6f);
    painter.line(rose.at(angle, -inner), rose.at(angle, -tip), color, 1.6f);
    const Point head[3] = {rose.at(angle, tip), rose.at(angle, neck, 0.42f * m), rose.at(angle, neck, -0.42f * m)};
    painter.batch().polyline(head, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    painter.batch().triangle(head[0], head[1], head[2], color);
}

void build_bar(const Painter& painter, const CompassRose& rose, double angle, const SymbologyInput& input) {
    const float spacing = kDot * rose.radius;
    for (const float dots : {-2.0f, -1.0f, 1.0f, 2.0f})
        build_dot(painter, rose.at(angle, 0, dots * spacing), kDotRadius * rose.mark_px);
    const DeviationScale scale = deviation_scale(input.guidance.navigation_source, input.phase.presented);
    // The bar shows where the course is: on the other side.
    const DotsOff off = dots_off(-input.guidance.lateral_deviation, scale.lateral);
    const float middle = static_cast<float>(off.dots) * spacing, half = 0.5f * kBarWidth * rose.mark_px,
                end = kBarHalf * rose.radius;
    const Point corners[4] = {rose.at(angle, end, middle - half), rose.at(angle, end, middle + half),
                              rose.at(angle, -end, middle + half), rose.at(angle, -end, middle - half)};
    const design::Color color = source_color(input, Element::lateral_deviation);
    if (off.is_beyond) return painter.polyline(corners, color, 0.9f, true);
    painter.line(rose.at(angle, end, middle), rose.at(angle, -end, middle), color,
                 kBarWidth * rose.mark_px / painter.stroke_px());
}

/// Seen from above, at the card's center.
void build_own_ship_mark(const Painter& painter, const CompassRose& rose) {
    const float m = rose.mark_px;
    painter.line(rose.at(0, 0.45f * m), rose.at(0, -0.4f * m));
    painter.line(rose.at(0, 0.1f * m, -0.45f * m), rose.at(0, 0.1f * m, 0.45f * m));
    painter.line(rose.at(0, -0.4f * m, -0.2f * m), rose.at(0, -0.4f * m, 0.2f * m));
}

void build_path_scale(const Painter& painter, Point center, float spacing, float half_width) {
    const float radius = kDotRadius * painter.text_px();
    for (const float dots : {-2.0f, -1.0f, 1.0f, 2.0f}) build_dot(painter, {center.x, center.y + dots * spacing}, radius);
    painter.line({center.x - half_width, center.y}, {center.x + half_width, center.y});
}

/// A diamond for radio; for GNSS a chevron, which points at the scale.
void build_path_pointer(const Painter& painter, Point at, const SymbologyInput& input, bool is_hollow) {
    const float t = painter.text_px(), half = 0.5f * t;
    const design::Color color = source_color(input, Element::vertical_deviation);
    if (is_radio(input.guidance.navigation_source)) {
        const Point diamond[4] = {{at.x, at.y - half}, {at.x + half, at.y}, {at.x, at.y + half}, {at.x - half, at.y}};
        return build_shape(painter, diamond, color, is_hollow);
    }
    const Point chevron[4] = {
        {at.x - half, at.y}, {at.x + half, at.y - half}, {at.x + 0.15f * t, at.y}, {at.x + half, at.y + half}};
    build_shape(painter, chevron, color, is_hollow);
}

}  // namespace

DeviationScale deviation_scale(NavigationSource source, flight::FlightPhase phase) noexcept {
    constexpr double kMile_m = base::kMetresPerNauticalMile, kWide_m = 500 * base::kMetresPerFoot;
    if (source == NavigationSource::none) return {};
    if (is_radio(source)) return {radians(2.5), radians(0.7), {}};
    switch (phase.scenario) {
        case flight::Scenario::ground:
        case flight::Scenario::takeoff:
        case flight::Scenario::go_around: return {kMile_m, kWide_m, "TERM"};
        case flight::Scenario::approach:
            if (phase == flight::kApproachDescent) return {kMile_m, kWide_m, "TERM"};
            return {0.3 * kMile_m, 0.5 * kWide_m, "APR"};
        case flight::Scenario::cruise:
        case flight::Scenario::unknown: break;
    }
    return {2 * kMile_m, kWide_m, "ENR"};
}

void build_course(const Painter& painter, const CompassRose& rose, const SymbologyInput& input) {
    const bool has_direction = shows_value(input.decisions[Element::course].show) && !std::isnan(input.from_true_rad);
    const double angle = has_direction ? rose_angle_rad(input, input.guidance.course_rad) : 0;
    build_own_ship_mark(painter, rose);
    if (has_direction) build_needle(painter, rose, angle, source_color(input, Element::course));
    if (shows_value(input.decisions[Element::lateral_deviation].show)) return build_bar(painter, rose, angle, input);
    if (input.decisions[Element::lateral_deviation].show == ElementShow::absent) return;
    const float t = rose.text_px;
    painter.crossed_out({rose.center.x - 1.4f * t, rose.center.y - 0.6f * t, 2.8f * t, 1.2f * t},
                        has_lost_source(input)                       ? "NAV"
                        : is_radio(input.guidance.navigation_source) ? "LOC"
                                                                     : "GPS");
}

void build_course_texts(const Painter& painter, const CompassRose& rose, const SymbologyInput& input) {
    const auto row = [&](int number) { return rose.side_row(RoseSide::left, number); };
    const float size = legible_size(kCourseText, painter.text_px());
    const auto write = [&](int number, const Words& text, design::Color color) {
        painter.fitted_text(text, row(number), TextAnchor::left, size, color);
    };
    if (input.decisions[Element::course].show == ElementShow::failed)
        painter.crossed_out(rose.side_cross(RoseSide::left, 0), "CRS");
    if (shows_value(input.decisions[Element::course].show) && !std::isnan(input.from_true_rad)) {
        ShortText course("CRS ");
        course.append(rose_degrees(input, input.guidance.course_rad).view());
        write(0, {course.view(), course.view().substr(4), ""}, source_color(input, Element::course));
    }
    const bool has_course = shows_value(input.decisions[Element::course].show),
               has_deviation = shows_value(input.decisions[Element::lateral_deviation].show);
    if (has_lost_source(input) || !(has_course || has_deviation)) return;
    write(1, {lateral_name(input), ""}, source_color(input, has_deviation ? Element::lateral_deviation : Element::course));
    const DeviationScale scale = deviation_scale(input.guidance.navigation_source, input.phase.presented);
    const auto is_old = [&](Element element) { return input.decisions[element].show == ElementShow::flagged; };
    const bool is_stale = is_old(Element::course) || is_old(Element::lateral_deviation);
    // Where there are three rows, the scale's name is left out.
    const int stale_row = rose.rows - 1;
    if (is_stale) write(stale_row, short_words_or_none("STALE"), painter.color(SymbolRole::caution));
    if (has_deviation && !scale.name.empty() && !(is_stale && stale_row == 2))
        write(2, {scale.name, ""}, source_color(input, Element::lateral_deviation));
}

void build_vertical_deviation(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::vertical_deviation].show;
    const Rect& box = painter.layout().vertical_deviation;
    const float t = painter.text_px();
    if (show == ElementShow::absent) return;
    const std::string_view name = has_lost_source(input) ? "NAV" : is_radio(input.guidance.navigation_source) ? "GS" : "GP";
    const float width = std::max(box.width, text_width_px(name, kMinText_px) + 2 * painter.stroke_px());
    const float row = legible_row_px(kDeviationName, t), left = box.right() - width;
    if (show == ElementShow::failed) return painter.crossed_out({left, box.center().y - 0.6f * t, width, 1.2f * t}, name);
    const design::Color color = source_color(input, Element::vertical_deviation);
    const float size = legible_size(kCourseText, painter.text_px());
    painter.fitted_text(name, {left, box.y, width, row}, TextAnchor::center, size, color);
    const float half = box.height / 2 - row - 0.6f * t, spacing = half / static_cast<float>(kMaxDots);
    const Point center{box.x + 0.6f * t, box.center().y};
    build_path_scale(painter, center, spacing, 0.5f * t);
    const DeviationScale scale = deviation_scale(input.guidance.navigation_source, input.phase.presented);
    // The pointer shows where the path is; positive is up in the deviation and down on the screen.
    const DotsOff off = dots_off(input.guidance.vertical_deviation, scale.vertical);
    build_path_pointer(painter, {center.x, center.y + static_cast<float>(off.dots) * spacing}, input, off.is_beyond);
    if (show == ElementShow::flagged)
        painter.text("STALE", {box.right() - 0.45f * t, box.center().y}, TextAnchor::center, size,
                     painter.color(SymbolRole::caution), static_cast<float>(-0.5 * base::kPi));
}

}  // namespace tedavis::draw
