/// Checks whether the colours of a palette are distinguishable: in their order, on shaded terrain, with colour vision
/// deficiencies, and beside other elements.
///
/// Classes of a nominal palette have no order, and no colours lie between them.
///
/// Differences are CIEDE2000 (color_difference.hpp). About 1 is just noticeable between adjacent patches; stops are never
/// adjacent on a terrain, so several times as much is required. Requirements:
///   order     by `lightness`: each stop at least kLightnessStep brighter (or each darker) than the one before it, in a
///             diverging palette from both ends to the middle; by `hue`: the hue turns one way, less than once around, every
///             stop has at least the chroma kHueChroma, and two steps differ more than one. In normal vision and without each of
///             the three kinds of cones (color_vision.hpp), where for `hue` only the steps are checked.
///   distance  any two stops differ by kDistance, in the three deficiencies by kDeficientDistance.
///   light     neighbouring stops differ by kLitDistance in every light from the design's ambient share to full light.
///   apart     no colour of the palette, at and between stops, differs by less than kApart in full light, or kApartInShade in the
///             design's least light, from the sea, the colour of missing data, and, where warning colours are on, any band
///             as it is displayed: with its strength over any colour of the palette and over the sea. A palette of objects in
///             the air is compared only with the colour of missing data: the shape of its surfaces differs from that of ground,
///             and no band covers them.
///
/// Failure  a list of sentences, one for the worst place of each requirement; empty when all hold.
#pragma once

#include <string>
#include <vector>

#include "render_core/design/design_settings.hpp"

namespace tedavis::host_sim {

inline constexpr double kLightnessStep = 5;  ///< L*
inline constexpr double kHueChroma = 8;      ///< C*
inline constexpr double kDistance = 7.5, kDeficientDistance = 6;
inline constexpr double kLitDistance = 2;
inline constexpr double kApart = 10, kApartInShade = 4;

/// Checks order and distance. Every sentence begins with `name`, the palette's file.
[[nodiscard]] std::vector<std::string> palette_faults(const design::Palette& palette, const std::string& name);
/// Checks light and apart with the light, the sea, the missing data and the warning bands of a design.
[[nodiscard]] std::vector<std::string> palette_faults_in_design(const design::Palette& palette,
                                                                const design::DesignSettings& design, const std::string& name);

}  // namespace tedavis::host_sim
