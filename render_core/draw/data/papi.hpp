/// A precision approach path indicator: four lights to the left of the aiming point, whose colours show whether the own ship is
/// above or below the approach path.
///
/// A light is white from above its own angle, red from below. For a path of 3 degrees the angles are 3.5, 3.17, 2.83 and 2.5
/// degrees from the runway outwards (ICAO Annex 14, Volume I, 5.3.5 and figure 5-20): on the path the two nearest to the runway
/// are red and the two others white. For another path they are shifted with it. Colour is not the only cue: a white light is a
/// square, a red one a horizontal bar, half as high.
///
/// Pure functions; any thread.
#pragma once

#include <array>

#include "render_core/base/units.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kPapiLights = 4;
inline constexpr double kPapiReach_m = 10 * base::kMetresPerNauticalMile, kPapiAzimuth_deg = 10;
inline constexpr double kPapiPath_deg = 3;                     ///< where the scene states none
inline constexpr double kPapiFree_m = 15, kPapiSpacing_m = 9;  ///< from the edge to the first light, and between lights

/// From the runway outwards: true for white.
using PapiLights = std::array<bool, kPapiLights>;
/// `angle_deg`: elevation of the own ship above the lights' horizontal.
[[nodiscard]] PapiLights papi_lights(double angle_deg, double path_deg = kPapiPath_deg);

/// Whether the lights are visible `before_m` ahead of them along the approach and `aside_m` beside it. False for NaN.
[[nodiscard]] bool is_papi_seen(double before_m, double aside_m);

}  // namespace tedavis::draw
