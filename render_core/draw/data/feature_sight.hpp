/// Counts the features of a layer that lie completely outside a view, for the record.
///
/// A feature is out of view where all its points, over all heights that it may have, are beyond the same side of the view by
/// more than a margin: 300 m plus 0.5 % of the distance, which covers the error of the flat approximation, plus the
/// displacement by the view's magnifiers. Features farther than kFarthestSight_rad are not counted: a feature that may be in
/// view never counts as out of view.
///
/// Pure. Bounded: the layer's points; for features in view mostly the first ones.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

inline constexpr double kFarthestSight_rad = 0.05;

/// Returns the count in the element's units: features, or for tubes all their points.
[[nodiscard]] std::uint32_t count_out_of_view(const ElementInput& input, const terrain::View& view);

}  // namespace tedavis::draw
