/// Makes a grid layer of a scene from a raster file, as its recipe states.
#pragma once

#include <cstdint>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Largest number of posts of one attribute of a grid, over all levels and times.
inline constexpr std::uint64_t kMaxGridPosts = 1U << 26U;

/// A layer, and notes for the user; each begins with the layer's name.
struct GridLayer {
    LayerDraft draft;
    std::vector<std::string> notes;
};

/// Relative names of files are relative to `folder`. Throws UserError, one sentence that names the layer and the file.
[[nodiscard]] GridLayer make_grid_layer(const LayerRecipe& recipe, const std::string& folder);

}  // namespace tedavis::host_sim
