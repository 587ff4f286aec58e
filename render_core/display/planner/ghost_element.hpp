/// Ghosts (draw/data/ghost_signs.hpp) are shown in every design and phase, since a scene has them only in order to show them.
#pragma once

#include "render_core/design/data_element.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::display {

/// Whether a layer has ghosts, and a design with these elements has none that shows them.
[[nodiscard]] bool needs_ghost_element(const design::DataElementList& elements, const scene::Layer& layer);
/// Returns the element that shows them then; it is valid as long as the program runs.
[[nodiscard]] const design::DataElement& ghost_element();

}  // namespace tedavis::display
