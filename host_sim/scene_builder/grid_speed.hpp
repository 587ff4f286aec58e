/// The speed of wind at the posts of a grid: `variable = "derived:wind_speed"` beside the attributes 'east' and 'north' of its
/// own layer. Missing where one of them is. Its uncertainty is the greater of theirs, unknown if these are of two kinds.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Throws UserError.
[[nodiscard]] AttributeDraft grid_speed(const LayerRecipe& recipe, const AttributeRecipe& attribute, const LayerDraft& layer);

}  // namespace tedavis::host_sim
