/// The look of an element's solids, from its design. Pure function; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::draw {

/// Opacity of a margin of possible positions, as a share of the object's.
inline constexpr float kMarginShare = 0.35f;

[[nodiscard]] SolidLook look_of(const ElementInput& input);

}  // namespace tedavis::draw
