/// The color of an obstacle: that of the obstacle alert for one that the predicted track comes too close to, as the planner has
/// decided; its own for all others. Pure functions; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

/// `own`: without an alert, or of a feature that is no obstacle. Of an alert, opaque.
[[nodiscard]] design::Color obstacle_color(const ElementInput& input, std::uint32_t feature, design::Color own);

}  // namespace tedavis::draw
