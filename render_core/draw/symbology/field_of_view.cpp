#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {

Rect field_of_view_box(const Layout& layout) noexcept {
    const Rect &air = layout.air, &attitude = layout.attitude;
    const float row = 0.5f * air.height;
    return {air.x, attitude.bottom() - row, air.width, row};
}

void build_field_of_view(const Painter& painter, const SymbologyInput& input) {
    if (input.decisions.unusual_attitude || !shows_value(input.decisions[policy::Element::attitude].show)) return;
    const double whole_rad = 2 * std::atan(input.view.center_x / input.view.focal_px);
    ShortText text("FOV ");
    text.append(whole_number(std::round(base::degrees(limited(whole_rad, 0, base::kPi)))).view());
    text.append("\xC2\xB0");
    painter.fitted_text(text.view(), field_of_view_box(painter.layout()), TextAnchor::center, 0.85f,
                        painter.color(SymbolRole::scale));
}

}  // namespace tedavis::draw
