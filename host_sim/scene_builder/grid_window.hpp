/// The posts of a grid within a region.
#pragma once

#include <optional>
#include <vector>

#include "host_sim/scene_builder/grid_source.hpp"
#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Columns and rows of the source, in the order of the layer's; columns may go round the Earth.
struct GridWindow {
    std::vector<int> columns, rows;
    double west_deg = 0, north_deg = 0;
};

/// Returns the columns and rows in the region and one beyond each of its sides, so that all of it lies between posts. Empty
/// vectors where the grid has no post in it.
[[nodiscard]] GridWindow window_of(const GridPlaces& places, const std::optional<RegionRecipe>& region);

/// Returns the values of the window from a plane of the source.
[[nodiscard]] std::vector<float> cut(const std::vector<float>& plane, const GridPlaces& places, const GridWindow& window);

}  // namespace tedavis::host_sim
