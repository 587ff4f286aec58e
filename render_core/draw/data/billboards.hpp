/// Icons and names of a layer's features, above their places: obstacles, places, runways, samples, models, storms, areas.
///
/// A point's billboard stands above the point, a line's above its middle, an area's above the middle of its corners, on the
/// ground, where the storm has gone to; no-go areas and airspaces have theirs at their ceiling, with their limits below the name
/// (area_limits.hpp). A size attribute makes the icon between its least and its greatest size; without one it
/// has size_m (kIconSize_m where the design names none) at its distance, within the same limits. `link` leads a line down to the
/// ground. Classes of an ordinal attribute "kind" come first, the higher the sooner: each counts as half the distance; then
/// comes the nearer. The name of what would cover one that came before, or the symbology, goes to its other side, then above it,
/// then both up on a longer stem; then it stands without its name (an airspace with its limits alone), then it is hidden; so is
/// what terrain stands before. Obstacles have no longer stems, which would read as their heights: after their names they lose the
/// stem, and stand on the spot, under the symbology. Stems are thin and grey. `detail`: the share of the features that have their
/// names, those that come first; places without one are left out, and so are
/// more than kMostPlaces * detail of them; everything else keeps its icon.
///
/// Pure but for the ground that is asked: at most once a candidate and link. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr double kIconSize_m = 80;
inline constexpr double kFarthestBillboard_m = 80'000;
inline constexpr double kMostPlaces = 24;  ///< of a picture with less than all detail
/// Of the text's size.
inline constexpr float kLeastIcon = 1.0f, kGreatestIcon = 2.2f;

[[nodiscard]] ElementCount add_billboards(BillboardSheet& sheet, const ElementInput& input);

}  // namespace tedavis::draw
