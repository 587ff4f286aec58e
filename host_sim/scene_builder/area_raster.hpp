/// Rasterises areas, such as land cover polygons, so that their classes can colour the ground.
#pragma once

#include <optional>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// A layer of areas, with attributes by feature, as posts `cell_m` apart over the rectangle round them, or over the part of it
/// that lies in the region. A post has the values of the last area that covers it (even-odd: a ring that is walked back to leaves
/// a hole), and none where there is no area. Names are lost. Throws UserError, beginning with the layer's name, where that cannot
/// be.
[[nodiscard]] LayerDraft rasterized(const LayerDraft& areas, double cell_m, const std::optional<RegionRecipe>& region);

}  // namespace tedavis::host_sim
