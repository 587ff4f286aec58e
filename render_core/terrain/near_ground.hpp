/// Upper bound of a surface error in pixels, from the ground round the eye point.
///
/// The box of a coarse chunk that contains the eye point gives no useful bound. So boxes are refined down to the exact chunks,
/// those with the largest bound first, and in the exact chunks near the eye point to blocks of posts and to flat triangles
/// between posts. What is not refined is bounded by its parent. No assumption is made about slopes between the eye point and
/// the ground, so steps, voids, insets and the antimeridian need no special case.
#pragma once

#include "render_core/terrain/height_query.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Returns the bounds for a view, without steps where its numbers are not finite. Reads the vertices of at most four chunks,
/// and the directory pages that lead to them, synchronously; cached ones are not read again.
[[nodiscard]] NearGround near_ground(HeightQuery& heights, const View& view);

}  // namespace tedavis::terrain
