/// The perceived difference of two colours: CIELAB and CIEDE2000.
///
/// Frames are sRGB for the display (design/color.hpp); L*a*b* refers to the white of sRGB, D65. About 1 is the least visible
/// difference between adjacent patches.
#pragma once

#include "render_core/design/color.hpp"

namespace tedavis::design {

/// CIE 1976 L*a*b*: lightness 0..100, red against green, yellow against blue.
struct Lab {
    double lightness = 0, a = 0, b = 0;
};

/// Linear light of the sRGB primaries; 0..1; values outside are clamped.
struct LinearRgb {
    double red = 0, green = 0, blue = 0;
};

[[nodiscard]] LinearRgb linear_rgb(Color color) noexcept;
/// Converts linear light to L*a*b* (primaries after IEC 61966-2-1, L*a*b* after CIE 15).
[[nodiscard]] Lab lab_of(const LinearRgb& light) noexcept;

/// Returns the CIEDE2000 difference with all weights 1: CIE 142, in the form of Sharma, Wu, Dalal, "The CIEDE2000
/// color-difference formula", Color Research and Application 30 (2005), which also gives the test pairs.
[[nodiscard]] double color_difference(const Lab& first, const Lab& second) noexcept;

}  // namespace tedavis::design
