/// The look of an element's solids, from its design. Pure function; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::draw {

/// What a margin, in which a thing may be, has of the thing's opacity.
inline constexpr float kMarginShare = 0.35f;

[[nodiscard]] SolidLook look_of(const ElementInput& input);

}  // namespace tedavis::draw
