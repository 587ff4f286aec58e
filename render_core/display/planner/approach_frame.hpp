/// The input for runways and their approach lights: the eye point, the own ship, and where the planned flight ends. Pure.
#pragma once

#include "render_core/draw/data/extended_centerline.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::display {

struct ElementFrame;

/// Returns the view's direction and scale; the own ship by geometric height, where its position is valid; and as destination the
/// last point of the planned flight, within 20 km of the own ship. Without a valid position it states neither: a light that
/// shows an old angle would mislead. `scene`: null where there is none.
[[nodiscard]] draw::ApproachFrame approach_frame(const ElementFrame& frame, const scene::Scene* scene);

}  // namespace tedavis::display
