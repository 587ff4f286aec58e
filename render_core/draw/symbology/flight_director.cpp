#include "render_core/draw/symbology/flight_director.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/bank_scale.hpp"
#include "render_core/draw/symbology/ladder_frame.hpp"

namespace tedavis::draw {
namespace {

using policy::Element;
using policy::ElementShow;

constexpr float kHalfBar = 2.6f;                         // texts
constexpr float kDashFrom = 2.2f, kDashTo = 4.2f;        // texts from the middle of the ladder
constexpr float kCrossWidth = 2.6f, kPlateWidth = 5.0f;  // texts
constexpr double kMaxReference_rad = base::radians(30);

/// Commands over an attitude that stands still would be followed for ever.
bool attitude_is_valid(const SymbologyInput& input) {
    return input.decisions[Element::attitude].show == ElementShow::normal && !input.decisions.unusual_attitude;
}

/// In the lower left corner of the attitude, above the flight-path vector's own.
Rect failure_place(const Painter& painter, float rows, float width) {
    const float t = painter.text_px();
    const Rect& attitude = painter.layout().attitude;
    const float height = std::max(1.4f * t, 1.15f * kMinText_px), pitch = height + 0.1f * t;
    return {attitude.x, attitude.bottom() - height - pitch * rows, width, height};
}

/// Where a sign with its rim is whole, `texts` from the sides of the attitude.
bool is_within(const Painter& painter, const ProjectedPoint& point, float texts) {
    return point.in_front && painter.layout().attitude.shrunk(texts * painter.text_px()).contains(point.at);
}

/// Left and right of the ladder. A part of a dash would have no rim at its end, and one alone no middle between them: both are
/// whole, or there are none.
void build_dashes(const Painter& painter, const LadderFrame& ladder, double elevation_rad, design::Color color) {
    const auto place = [&](float texts) {
        const double aside = ladder.tangent_of(std::fabs(texts) * painter.text_px());
        return ladder.at(elevation_rad, texts < 0 ? -aside : aside);
    };
    const ProjectedPoint left = place(-kDashTo), right = place(kDashTo);
    if (!is_within(painter, left, 0.3f) || !is_within(painter, right, 0.3f)) return;
    painter.line(left.at, place(-kDashFrom).at, color, 1.5f);
    painter.line(place(kDashFrom).at, right.at, color, 1.5f);
}

}  // namespace

void build_flight_director(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::flight_director].show;
    const bool is_over_stale = input.decisions[Element::attitude].show == ElementShow::flagged;
    if (show == ElementShow::absent || (!attitude_is_valid(input) && !is_over_stale)) return;
    if (show == ElementShow::failed || is_over_stale)
        return painter.crossed_out(failure_place(painter, 1, kCrossWidth * painter.text_px()), "FD");
    const float t = painter.text_px(), reach = kMaxBarTexts * t;
    const Point c = painter.layout().screen.center();
    const double up_px = input.view.focal_px * std::tan(limited(input.guidance.director_pitch_rad, -0.5, 0.5));
    const double right_px = limited(input.guidance.director_roll_rad, -1, 1) * static_cast<double>(kBarTexts_per_rad * t);
    const float y = c.y - std::clamp(static_cast<float>(up_px), -reach, reach);
    const float x = c.x + std::clamp(static_cast<float>(right_px), -reach, reach);
    const design::Color color = painter.color(show == ElementShow::flagged ? SymbolRole::caution : SymbolRole::engaged);
    painter.line({c.x - kHalfBar * t, y}, {c.x + kHalfBar * t, y}, color, 2);
    painter.line({x, c.y - kHalfBar * t}, {x, c.y + kHalfBar * t}, color, 2);
    if (show == ElementShow::flagged)
        painter.plate(failure_place(painter, 1, painter.plate_px("FD STALE", kPlateWidth)), "FD STALE", painter.type().label,
                      painter.color(SymbolRole::caution));
}

void build_path_reference(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::flight_path_reference].show;
    if (show == ElementShow::absent || !attitude_is_valid(input)) return;
    if (show == ElementShow::failed)
        return painter.crossed_out(failure_place(painter, 2, painter.plate_px("PATH", kCrossWidth)), "PATH");
    const LadderFrame ladder(input);
    const double descent_rad = limited(input.guidance.path_reference_rad, -kMaxReference_rad, kMaxReference_rad);
    const design::Color color = painter.color(show == ElementShow::flagged ? SymbolRole::caution : SymbolRole::selected);
    build_dashes(painter, ladder, -descent_rad, color);
    const ProjectedPoint label = ladder.at(-descent_rad, ladder.tangent_of((kDashTo + 0.3f) * painter.text_px()));
    char text[16];
    std::snprintf(text, sizeof text, "%.1f\xC2\xB0", base::degrees(descent_rad));
    const auto roll = static_cast<float>(-limited(input.roll_rad, -base::kPi, base::kPi));
    const ProjectedPoint end = ladder.at(-descent_rad, ladder.tangent_of((kDashTo + 2.8f) * painter.text_px()));
    if (is_within(painter, label, 0.5f) && is_within(painter, end, 0.5f))
        painter.text(text, label.at, TextAnchor::left, 0.75f, color, roll);
    if (show == ElementShow::flagged)
        painter.plate(failure_place(painter, 2, painter.plate_px("PATH STALE", kPlateWidth)), "PATH STALE", painter.type().label,
                      painter.color(SymbolRole::caution));
}

}  // namespace tedavis::draw
