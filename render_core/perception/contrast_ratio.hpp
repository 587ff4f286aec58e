/// The contrast ratio of WCAG 2.1.
#pragma once

namespace tedavis::perception {

/// Returns the ratio of two relative luminances 0..1 (design/color.hpp), in any order: 1 for equal ones, 21 for black and
/// white.
[[nodiscard]] constexpr double contrast_ratio(double first, double second) {
    return first > second ? (first + 0.05) / (second + 0.05) : (second + 0.05) / (first + 0.05);
}

}  // namespace tedavis::perception
