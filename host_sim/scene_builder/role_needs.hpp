/// A layer whose role could show nothing of its source is refused, instead of a scene with an empty layer.
#pragma once

#include "host_sim/scene_builder/scene_recipe.hpp"
#include "host_sim/scene_builder/source_kind.hpp"

namespace tedavis::host_sim {

/// Throws UserError, which says what the role needs, where the source is of another kind or attributes are not bound.
void require_what_role_needs(const LayerRecipe& recipe, SourceKind kind);

}  // namespace tedavis::host_sim
