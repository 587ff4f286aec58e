/// Ghosts (draw/data/ghost_signs.hpp) are shown in every design: whoever puts them into a scene wants to see them, in each phase.
#pragma once

#include "render_core/design/data_element.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::display {

/// Whether a layer has ghosts of which a design with these elements says nothing.
[[nodiscard]] bool needs_ghost_element(const design::DataElementList& elements, const scene::Layer& layer);
/// Shows them then. Stays for as long as the program.
[[nodiscard]] const design::DataElement& ghost_element();

}  // namespace tedavis::display
