/// Small diagrams that face the eye, above the places of a layer of points: what one says by several attributes, or how one
/// attribute changes with height.
///
/// Points that follow each other at the same latitude and longitude are one profile: the value to the right, the height upwards,
/// from the least to the largest of either; over the lowest of them. A point alone has a bar for each of its first
/// kMaxDiagramBars quantitative attributes, from the least of the layer, which has a bar of kMinBar, to the largest. The value
/// of a profile is the element's colour attribute, else its size attribute, else the first quantitative one. A cross stands where
/// a value is missing. The nearest come first; what would cover another billboard, and what terrain stands before, is hidden.
///
/// `detail`: below 1 a profile has fewer knots, each the mean of as many neighbours, with a line from the least to the largest of
/// them and a cross on the axis where one is missing; its knots count as aggregated. A point alone has fewer of its bars, the
/// first.
///
/// Pure but for the ground that is asked, once a diagram. Bounded.
#pragma once

#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMaxDiagramBars = 5, kMaxProfileSamples = 24;
inline constexpr float kMinBar = 0.08f;  ///< of the diagram's height
/// Of the text's size: the plate, without its name.
inline constexpr float kDiagramWidth = 4.2f, kDiagramHeight = 3.2f;

/// What profiles of the layer show; null: nothing.
[[nodiscard]] const scene::Attribute* profile_attribute(const design::DataElement& element, const scene::Layer& layer);
/// Whether any points follow each other at one place.
[[nodiscard]] bool has_profiles(const scene::Layer& layer);

/// Points are drawn with the diagram that shows them. Of a profile longer than kMaxProfileSamples the rest is hidden.
[[nodiscard]] ElementCount add_diagrams(BillboardSheet& sheet, const ElementInput& input);

}  // namespace tedavis::draw
