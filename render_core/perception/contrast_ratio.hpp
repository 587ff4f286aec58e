/// How well something stands out by its brightness alone: the contrast ratio of WCAG 2.1.
#pragma once

namespace tedavis::perception {

/// Of two relative luminances 0..1 (design/color.hpp) in any order: 1 alike .. 21 black and white.
[[nodiscard]] constexpr double contrast_ratio(double first, double second) {
    return first > second ? (first + 0.05) / (second + 0.05) : (second + 0.05) / (first + 0.05);
}

}  // namespace tedavis::perception
