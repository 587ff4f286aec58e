/// Where things may be: translucent ellipsoids round the places of a layer, by its position and height accuracies (95 %).
///
/// Round points, models, other aircraft (traffic_state.hpp), and the own ship at the end of its way. Without a height accuracy
/// they are spheres; without a position accuracy there are none, for nobody knows how large. Pure but for the ground that is
/// asked. Bounded.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_mesh.hpp"

namespace tedavis::draw {

/// True where the element asks for them and the layer has places.
[[nodiscard]] bool has_ellipsoids(const ElementInput& input);
/// They belong to features that are counted elsewhere: returns how many there are.
std::uint32_t add_place_ellipsoids(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

}  // namespace tedavis::draw
