/// Builds translucent ellipsoids of possible positions round the positions of a layer, from its position and height accuracies
/// (95 %).
///
/// They are drawn round points, models, other aircraft (traffic_state.hpp), and the own ship at the end of its trail. Without a
/// height accuracy they are spheres; without a position accuracy there are none. Pure, apart from queries to the ground.
/// Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

/// True where the element requests them and the layer has positions.
[[nodiscard]] bool has_ellipsoids(const ElementInput& input);
/// Adds them and returns their number; their features are counted elsewhere.
std::uint32_t add_place_ellipsoids(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
