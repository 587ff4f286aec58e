/// Simulates colour vision without one of the three kinds of cones.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim {

enum class ColorVision : std::uint8_t { normal, protan, deutan, tritan };
inline constexpr std::array<ColorVision, 4> kColorVisions = {ColorVision::normal, ColorVision::protan, ColorVision::deutan,
                                                             ColorVision::tritan};

/// "normal vision", "protanopia" and so on.
[[nodiscard]] const char* to_string(ColorVision vision) noexcept;

/// Machado, Oliveira, Fernandes, "A physiologically-based model for simulation of color vision deficiency", IEEE Transactions on
/// Visualization and Computer Graphics 15 (2009), at severity 1, applied to linear light. According to its authors it is least
/// accurate for tritanopia.
[[nodiscard]] design::LinearRgb seen_with(ColorVision vision, const design::LinearRgb& light) noexcept;

}  // namespace tedavis::host_sim
