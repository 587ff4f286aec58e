/// A number whose last digits roll as the value changes, like the drums of an altimeter: between two readings both are seen in
/// part. A digit further left rolls along only while the digits right of it pass from their last reading to zero.
///
/// Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

/// How a number rolls. `step` divides 10 to the power of `last_digits`.
struct RollingFormat {
    int step = 1;         ///< units from one reading to the next
    int last_digits = 1;  ///< digits of the last column, which roll as one: 1 ("7", "8") or 2 ("60", "80")
};

/// What one column shows at the two readings next to the value. Where both are the same the column does not roll.
struct RollingColumn {
    base::FixedString<2> lower, upper;  ///< digits, "-" left of the first digit of a negative number, or empty

    [[nodiscard]] bool rolls() const { return lower != upper; }
};

inline constexpr std::size_t kMaxRollingColumns = 7;
inline constexpr double kMaxRollingValue = 99'999;

struct RollingDigits {
    base::FixedVector<RollingColumn, kMaxRollingColumns> columns;  ///< from the left; the last one has `last_digits` digits
    double share = 0;  ///< of the way from the lower reading to the upper one, [0, 1); the same for all columns that roll
};

/// `value` is limited to +-kMaxRollingValue; NaN becomes -kMaxRollingValue.
[[nodiscard]] RollingDigits rolling_digits(double value, const RollingFormat& format) noexcept;

/// Draws the digits at the right of `window`, clipped to it. `size` in texts; digits that have no room are smaller. The digits
/// nearest to the value are drawn first.
void build_rolling_digits(const Painter& painter, const Rect& window, const RollingDigits& digits, float size,
                          design::Color color);

}  // namespace tedavis::draw
