/// The colour of an obstacle: that of the obstacle alert for one that the predicted track comes too close to, as the planner has
/// decided; its own for all others. Pure functions; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

/// Returns the opaque colour of the feature's alert; `own` without an alert.
[[nodiscard]] design::Color obstacle_color(const ElementInput& input, std::uint32_t feature, design::Color own);

}  // namespace tedavis::draw
