/// Rasterises areas, such as land cover polygons, so that their classes can colour the ground.
#pragma once

#include <optional>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Converts a layer of areas, with attributes by feature, to a grid of posts `cell_m` apart over its bounding rectangle, or over
/// the part of that in the region. A post has the values of the last area that covers it by the even-odd rule (a ring that is
/// traversed back leaves a hole), and is missing where there is no area. Names are lost. Throws UserError, beginning with the
/// layer's name, where a grid is not possible.
[[nodiscard]] LayerDraft rasterized(const LayerDraft& areas, double cell_m, const std::optional<RegionRecipe>& region);

}  // namespace tedavis::host_sim
