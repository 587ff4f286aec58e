/// Whether the colours of a palette can be read: in their order, on shaded terrain, by everybody, beside what else is drawn.
///
/// Classes of a nominal palette have no order, and no colours lie between them.
///
/// Differences are CIEDE2000 (color_difference.hpp). About 1 is just noticeable between patches that touch; stops never touch on
/// a terrain, so several times as much is asked for. Requirements:
///   order     by `lightness`: each stop at least kLightnessStep brighter (or each darker) than the one before it, in a
///             diverging palette from both ends to the middle; by `hue`: the hue turns one way, less than once around, every
///             stop has a chroma of kHueChroma, and one step differs less than two. In normal vision and without each of the
///             three kinds of cones (color_vision.hpp), where for `hue` the steps alone count.
///   distance  any two stops differ by kDistance, in the three deficiencies by kDeficientDistance.
///   light     neighbouring stops differ by kLitDistance in every light from the design's ambient share to full light.
///   apart     no colour of the palette, stops and between them, comes closer than kApart in full light, kApartInShade in the
///             design's least light, to the sea, to the colour of missing data, and, where warning colours are on, to any band
///             as it is displayed: with its strength over any colour of the palette and over the sea. A palette of objects in
///             the air only to the colour of missing data: its surfaces have a shape that no ground has, and no band covers them.
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

/// Order and distance. `name` stands at the head of every sentence: the palette's file.
[[nodiscard]] std::vector<std::string> palette_faults(const design::Palette& palette, const std::string& name);
/// Light and apart, with the light, the sea, the missing data and the warning bands of a design.
[[nodiscard]] std::vector<std::string> palette_faults_in_design(const design::Palette& palette,
                                                                const design::DesignSettings& design, const std::string& name);

}  // namespace tedavis::host_sim
