/// How many pixels an error of the surface is where the eye is close over the ground.
///
/// The posts round the eye are looked at themselves, a few cells to each side: the flat triangles of the exact chunks, in space,
/// clipped to the view. They differ from the true surface by no more than their chunks state. What lies beyond those cells is at
/// least as far away as the meridians and parallels round them. So steps, voids, insets and the antimeridian need no assumption
/// about slopes between the eye and what it sees.
#pragma once

#include "render_core/terrain/height_query.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Of this view. Zeros where nothing is gained or known: the eye is high above the posts round it, not over the lattice or beside
/// a pole, posts cannot be had, or they are so far apart that flat triangles say little. Scans the cells of four chunks at most.
[[nodiscard]] NearGround near_ground(HeightQuery& heights, const View& view);

}  // namespace tedavis::terrain
