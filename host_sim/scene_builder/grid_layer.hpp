/// Makes a grid layer of a scene from a raster file, as its recipe states.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// A layer, and sentences about what the user should know of it; each begins with the layer's name.
struct GridLayer {
    LayerDraft draft;
    std::vector<std::string> notes;
};

/// `folder`: what relative names of files start from. Throws UserError, one sentence that names the layer and the file.
[[nodiscard]] GridLayer make_grid_layer(const LayerRecipe& recipe, const std::string& folder);

}  // namespace tedavis::host_sim
