/// Builds the model of a layer of meshes at its points; the attribute "heading" (rad from north) rotates it, "scale" scales it.
///
/// The model has its own colours, or the element's where the element colours by an attribute. `detail`: below kShapesFrom
/// (obstacle_solids.hpp) it is drawn as its bounding box along its own axes, in the mean of its colours. Pure, apart from
/// queries to the ground. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

/// A model that exceeds a SolidMesh is hidden everywhere.
[[nodiscard]] ElementCount add_models(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
