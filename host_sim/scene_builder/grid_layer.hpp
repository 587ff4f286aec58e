/// A grid layer of a scene from a raster file, as its recipe binds it.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// `folder`: what relative names of files start from. Throws UserError, one sentence that names the layer and the file.
[[nodiscard]] LayerDraft make_grid_layer(const LayerRecipe& recipe, const std::string& folder);

}  // namespace tedavis::host_sim
