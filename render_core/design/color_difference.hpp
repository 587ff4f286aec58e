/// How different two colours look: CIELAB and CIEDE2000.
///
/// Frames are sRGB for the display (design/color.hpp); L*a*b* refers to the white of sRGB, D65. About 1 is the least difference
/// that people see between patches that touch.
#pragma once

#include "render_core/design/color.hpp"

namespace tedavis::design {

/// CIE 1976 L*a*b*: lightness 0..100, red against green, yellow against blue.
struct Lab {
    double lightness = 0, a = 0, b = 0;
};

/// Linear light of the sRGB primaries; 0..1 in a display's range, beyond it is cut.
struct LinearRgb {
    double red = 0, green = 0, blue = 0;
};

[[nodiscard]] LinearRgb linear_rgb(Color color) noexcept;
/// IEC 61966-2-1 for the primaries, CIE 15 for L*a*b*.
[[nodiscard]] Lab lab_of(const LinearRgb& light) noexcept;

/// CIEDE2000 with all weights 1: CIE 142, in the form of Sharma, Wu, Dalal, "The CIEDE2000 color-difference formula", Color
/// Research and Application 30 (2005), which also gives the test pairs.
[[nodiscard]] double color_difference(const Lab& first, const Lab& second) noexcept;

}  // namespace tedavis::design
