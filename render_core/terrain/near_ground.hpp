/// How many pixels an error of the surface can be, by the ground round the eye itself.
///
/// The box of a coarse chunk that holds the eye says nothing of the ground in it. So boxes are followed down to the exact chunks,
/// those that could move pixels most first, and in the exact chunks beside the eye to blocks of their posts and to flat triangles
/// between posts. What is asked of none of them is bounded by what is larger. So steps, voids, insets and the antimeridian need
/// no assumption about slopes between the eye and what it sees.
#pragma once

#include "render_core/terrain/height_query.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Of this view. Without steps for numbers that are not finite. Reads the vertices of four chunks at most, and the directory
/// pages on the way to them, at once: those that the query has kept are not read again.
[[nodiscard]] NearGround near_ground(HeightQuery& heights, const View& view);

}  // namespace tedavis::terrain
