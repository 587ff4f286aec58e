/// Which features of a layer lie wholly out of a view, for records of what is drawn.
///
/// A feature is out of view where all its points are, over all heights that it may have, beyond one and the same side of the view
/// by more than a margin of 300 m and 0.5 % of the distance, which is more than a flat map of the surroundings is off, and by as
/// much more as the view's magnifiers move things. What is farther than kFarthestSight_rad is not judged: nothing that may be in
/// view is ever said to be out of it.
///
/// Pure. Bounded: the layer's points; of what is in view mostly the first ones.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

inline constexpr double kFarthestSight_rad = 0.05;

/// How many of what the element counts: features, of ways that are tubes all their points.
[[nodiscard]] std::uint32_t count_out_of_view(const ElementInput& input, const terrain::View& view);

}  // namespace tedavis::draw
