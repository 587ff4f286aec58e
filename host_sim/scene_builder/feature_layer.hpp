/// Makes a layer of points, lines or areas from the features of a file, as its recipe states.
///
/// The role chooses the shape: lines for trajectories, traffic, roads, rivers and runways, areas for no-go areas, airspaces,
/// storm cells, land cover and buildings, else points where the file has any; other shapes of the file are left out and noted.
/// Values that a file does not state, such as a time or a class, are missing, and the notes count them.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// A layer, and notes for the user; each begins with the layer's name.
struct FeatureLayer {
    LayerDraft draft;
    std::vector<std::string> notes;
};

/// Throws UserError, beginning with the layer's name, where no feature states an attribute or the recipe has keys for grids only.
/// A source without features is no fault: the layer is empty, with a note.
[[nodiscard]] FeatureLayer make_feature_layer(const LayerRecipe& recipe, SourceFeatures source);

}  // namespace tedavis::host_sim
