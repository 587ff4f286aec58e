/// The look of an element's solids, from its design. Pure function; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::draw {

[[nodiscard]] SolidLook look_of(const ElementInput& input);

}  // namespace tedavis::draw
