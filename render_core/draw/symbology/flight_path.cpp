#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {
namespace {

using policy::ElementShow;

constexpr int kCircleSteps = 16;

/// Circle, wings and fin. At the edge of its box it is no longer conformal: amber and without fin.
void build_symbol(const Painter& painter, Point at, bool conformal) {
    const float t = painter.text_px(), radius = 0.5f * t;
    const design::Color color = painter.color(conformal ? SymbolRole::scale : SymbolRole::caution);
    Point circle[kCircleSteps];
    for (int i = 0; i < kCircleSteps; ++i) {
        const double angle = 2 * base::kPi * i / kCircleSteps;
        circle[i] = {at.x + radius * static_cast<float>(std::cos(angle)), at.y + radius * static_cast<float>(std::sin(angle))};
    }
    painter.polyline(circle, color, 1.3f, true);
    painter.line({at.x - 1.5f * t, at.y}, {at.x - radius, at.y}, color, 1.3f);
    painter.line({at.x + radius, at.y}, {at.x + 1.5f * t, at.y}, color, 1.3f);
    if (conformal) painter.line({at.x, at.y - 1.1f * t}, {at.x, at.y - radius}, color, 1.3f);
}

}  // namespace

void build_flight_path(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[policy::Element::flight_path].show;
    const float t = painter.text_px();
    const Rect& attitude = painter.layout().attitude;
    if (show == ElementShow::failed && input.decisions[policy::Element::attitude].show != ElementShow::failed)
        painter.crossed_out({attitude.x, attitude.bottom() - 1.4f * t, 2.6f * t, 1.4f * t}, "FPV");
    if (show != ElementShow::normal) return;
    const ProjectedPoint path = project(input.view, {input.velocity_north_mps, input.velocity_east_mps, -input.velocity_up_mps});
    if (!path.in_front) return;
    const Rect room = conformal_box(painter.layout()).shrunk(1.7f * t);
    const Point kept{std::clamp(path.at.x, room.x, room.right()), std::clamp(path.at.y, room.y, room.bottom())};
    build_symbol(painter, kept, room.contains(path.at));
}

}  // namespace tedavis::draw
