/// Refuses a layer whose role cannot show its source, which would give an empty layer.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_kind.hpp"

namespace tedavis::host_sim {

/// Throws UserError, with the needs of the role, where the source is of another kind or required attributes are missing.
void require_what_role_needs(const LayerRecipe& recipe, SourceKind kind);

}  // namespace tedavis::host_sim
