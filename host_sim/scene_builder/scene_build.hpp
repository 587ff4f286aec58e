/// Builds a scene database from a scene file.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_recipe.hpp"

namespace tedavis::host_sim {

/// Called with the name of the current layer and the numbers of layers done and in all. May throw to stop the build; then nothing
/// is written.
using SceneProgress = std::function<void(std::string_view layer, std::size_t done, std::size_t total)>;

struct MadeScene {
    SceneDraft draft;
    std::vector<std::string> notes;  ///< sentences that the user should read; each begins with a layer's name
};

/// Makes every layer from its source. Relative names are relative to `folder`. `given` are existing layers: they replace the
/// recipe's of the same names, whose sources are not read; others are appended. Throws UserError, whose message begins with the
/// layer or its file.
[[nodiscard]] MadeScene make_scene(const SceneRecipe& recipe, const std::string& folder, const SceneProgress& progress,
                                   std::vector<LayerDraft> given = {});

/// Reads the scene file, makes the scene and writes the database to `output`, complete or not at all. Its revision is one more
/// than that of a valid database that it replaces, else 1. Returns the notes. Throws UserError.
std::vector<std::string> build_scene(const std::string& scene_file, const std::string& output, const SceneProgress& progress);

}  // namespace tedavis::host_sim
