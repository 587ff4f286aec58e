#include "render_core/draw/symbology/rolling_digits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw {
namespace {

constexpr float kRest = 1.05f;      // readings are so much farther apart than needed for one at rest to be seen alone
constexpr float kPairSize = 0.85f;  // digits of a pair, of the others

long power_of_ten(int exponent) {
    long power = 1;
    for (int i = 0; i < exponent; ++i) power *= 10;
    return power;
}

/// Column 0 is the last one.
base::FixedString<2> column_text(long reading, int last_digits, int column) {
    const long magnitude = std::labs(reading);
    char text[24];
    if (column == 0) {
        std::snprintf(text, sizeof text, "%0*ld", last_digits, magnitude % power_of_ten(last_digits));
        return {text};
    }
    const long from_here = magnitude / power_of_ten(last_digits + column - 1);  // the number that ends in this column
    if (from_here > 0) {
        std::snprintf(text, sizeof text, "%ld", from_here % 10);
        return {text};
    }
    const bool follows_first_digit = column == 1 || magnitude >= power_of_ten(last_digits + column - 2);
    return {reading < 0 && follows_first_digit ? "-" : ""};
}

/// Where one of the two readings stands.
struct DrumRow {
    bool is_upper = false;
    float y = 0;
};

/// Columns of digits at the right of the window.
class Drum {
public:
    Drum(const Painter& painter, const Rect& window, const RollingDigits& digits, float size, design::Color color)
        : painter_(painter), digits_(digits), color_(color), right_(window.right() - 0.2f * painter.text_px()), size_(size) {
        const float room = right_ - window.x - 0.05f * painter.text_px(), wanted = width_px();
        if (wanted > room) size_ *= std::max(0.0f, room) / wanted;
        // Digits of the smallest text may come nearer to the sides.
        if (width_px() > room) right_ = std::min(window.right(), window.center().x + width_px() / 2);
    }

    /// Writes the columns that roll, or those that do not.
    void write(const DrumRow& row, bool rolling) const {
        float left = right_ - width_px();
        for (std::size_t i = 0; i < digits_.columns.size(); ++i) {
            const RollingColumn& column = digits_.columns[i];
            const float width = column_px(i);
            const std::string_view text = row.is_upper ? column.upper.view() : column.lower.view();
            if (column.rolls() == rolling && !text.empty())
                painter_.text(text, {left + width / 2, row.y}, TextAnchor::center, size_of(i), color_, 0, TextRim::none);
            left += width;
        }
    }
    [[nodiscard]] float capitals_px() const { return font_atlas().cap_height_em * painter_.em_px(size_); }

private:
    [[nodiscard]] bool is_pair(std::size_t column) const { return digits_.columns[column].lower.size() == 2; }
    [[nodiscard]] float size_of(std::size_t column) const { return is_pair(column) ? kPairSize * size_ : size_; }
    [[nodiscard]] float column_px(std::size_t column) const {
        return text_width_px(is_pair(column) ? "00" : "0", painter_.em_px(size_of(column)));
    }
    [[nodiscard]] float width_px() const {
        float width = 0;
        for (std::size_t i = 0; i < digits_.columns.size(); ++i) width += column_px(i);
        return width;
    }

    const Painter& painter_;
    const RollingDigits& digits_;
    design::Color color_;
    float right_;
    float size_;
};

}  // namespace

RollingDigits rolling_digits(double value, const RollingFormat& format) noexcept {
    const double readings = limited(value, -kMaxRollingValue, kMaxRollingValue) / format.step;
    const double below = std::floor(readings);
    const long lower = static_cast<long>(below) * format.step, upper = lower + format.step;
    RollingDigits digits;
    digits.share = readings - below;
    for (int column = static_cast<int>(kMaxRollingColumns); column-- > 0;) {
        const RollingColumn made{column_text(lower, format.last_digits, column), column_text(upper, format.last_digits, column)};
        if (made.lower.empty() && made.upper.empty()) continue;
        const bool added = digits.columns.try_push_back(made);
        TEDAVIS_CHECK(added);
    }
    return digits;
}

void build_rolling_digits(const Painter& painter, const Rect& window, const RollingDigits& digits, float size,
                          design::Color color) {
    const Drum drum(painter, window, digits, size, color);
    const float needed = (window.height + drum.capitals_px()) / 2, pitch = kRest * needed, center = window.center().y,
                share = static_cast<float>(digits.share);
    const DrumRow lower{false, center + share * pitch}, upper{true, center - (1 - share) * pitch};
    const bool is_upper_nearer = digits.share >= 0.5;
    const DrumRow& near = is_upper_nearer ? upper : lower;
    const DrumRow& far = is_upper_nearer ? lower : upper;
    painter.batch().set_clip(window, ClippedText::cut);
    drum.write({near.is_upper, center}, false);
    drum.write(near, true);
    if (std::fabs(far.y - center) < needed) drum.write(far, true);
    painter.batch().lift_clip();
}

}  // namespace tedavis::draw
