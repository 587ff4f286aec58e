/// Draws small diagrams that face the viewer, above the positions of a layer of points: several attributes of a point, or one
/// attribute over height.
///
/// Points that follow each other at the same latitude and longitude are one profile, drawn above the lowest of them: the value
/// to the right, over the layer's range, and the height upwards, over the profile's range. A point alone has a bar for each of
/// its first kMaxDiagramBars quantitative attributes; the layer's least value has a bar of kMinBar, the largest a full one. The
/// value of a profile is the element's colour attribute, else its size attribute, else the first quantitative one. A cross marks
/// a missing value. The nearest come first; diagrams that would cover another billboard, or lie behind terrain, are hidden.
///
/// `detail`: below 1 a profile has fewer knots, each the mean of as many neighbours, with a line from the least to the largest of
/// them and a cross on the axis where one is missing; its knots count as aggregated. A point alone has fewer of its bars, the
/// first.
///
/// Pure, apart from one query to the ground per diagram. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMaxDiagramBars = 5, kMaxProfileSamples = 24;
inline constexpr float kMinBar = 0.08f;  ///< share of the diagram's height
/// Size of the plate without its name, in text sizes.
inline constexpr float kDiagramWidth = 4.2f, kDiagramHeight = 3.2f;

/// Returns the attribute that profiles of the layer show, or null.
[[nodiscard]] const scene::Attribute* profile_attribute(const design::DataElement& element, const scene::Layer& layer);
/// True where consecutive points have the same latitude and longitude.
[[nodiscard]] bool has_profiles(const scene::Layer& layer);

/// Draws the diagrams. A point counts as drawn with its diagram; points of a profile beyond kMaxProfileSamples are hidden.
[[nodiscard]] ElementCount add_diagrams(BillboardSheet& sheet, const ElementInput& input);

}  // namespace tedavis::draw
