/// Makes a layer of points, lines or areas from the features of a file, as its recipe states.
///
/// The role chooses the shape: lines for trajectories, traffic, roads, rivers and runways, areas for no-go areas, airspaces,
/// storm cells, land cover and buildings, else points where the file has any; other shapes of the file are left out and noted. Of
/// a feature that a file cannot place in time or in a class nothing is made up: the value is missing, and the notes count it.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// A layer, and sentences about what the user should know of it; each begins with the layer's name.
struct FeatureLayer {
    LayerDraft draft;
    std::vector<std::string> notes;
};

/// Throws UserError, beginning with the layer's name, where an attribute is not stated by any feature or the recipe asks for what
/// only grids have. No features are no fault: the layer is empty, and a note says so.
[[nodiscard]] FeatureLayer make_feature_layer(const LayerRecipe& recipe, SourceFeatures source);

}  // namespace tedavis::host_sim
