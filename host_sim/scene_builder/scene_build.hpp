/// Builds a scene database from a scene file.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// The layer that is being made, how many are done, and of how many. May throw to stop the build; then nothing is written.
using SceneProgress = std::function<void(std::string_view layer, std::size_t done, std::size_t total)>;

struct MadeScene {
    SceneDraft draft;
    std::vector<std::string> notes;  ///< sentences that the user should read; each begins with a layer's name
};

/// Every layer from its source. `folder`: where relative names start. `given`: layers that are there already; they stand in for
/// the recipe's of the same names, whose sources are not read, and behind it otherwise. Throws UserError that begins with the
/// layer or its file.
[[nodiscard]] MadeScene make_scene(const SceneRecipe& recipe, const std::string& folder, const SceneProgress& progress,
                                   std::vector<LayerDraft> given = {});

/// Reads the scene file, makes the scene and puts the database in its place, whole or not at all. Its revision is one more than
/// that of a sound database that stood there, else 1. Returns the notes. Throws UserError.
std::vector<std::string> build_scene(const std::string& scene_file, const std::string& output, const SceneProgress& progress);

}  // namespace tedavis::host_sim
