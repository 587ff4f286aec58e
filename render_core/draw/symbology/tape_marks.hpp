/// Marks on a vertical scale: coloured bands, flags with letters, the bug of a selected value, a trend and the minimum of an
/// approach; and the row above the scale with the selected value.
///
/// Values are in the scale's display units. A mark follows its element's decision: normal, amber and hollow where it is flagged,
/// nothing where it is failed or absent (the row then says what failed). Every mark stays within `TapeScale::box`, which the
/// caller sets as the clip; numbers that are not finite leave a mark out. Pure: no GL, no clock, no heap. Thread any.
#pragma once

#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/aircraft_settings.hpp"
#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {

// From the scale's edge inwards, in texts: bands and the bug, ticks, the trend, numbers.
inline constexpr float kBandWidth = 0.45f;
inline constexpr float kBugWidth = 0.65f;
inline constexpr float kTrendInset = 0.78f;
inline constexpr float kNumberInset = 1.1f;
inline constexpr float kBugReach = 1.0f;       ///< of a bug, up and down from its value
inline constexpr float kFlagWidth = 1.5f;      ///< width of the flags' letters, beyond the edge
inline constexpr float kTapeTextSize = 0.92f;  ///< 11 px where a text is 12 px
inline constexpr float kTapeRowHeight = 1.4f;

/// Where the units of a scale are on the screen.
struct TapeScale {
    Rect box;           ///< of all that is drawn
    float edge = 0;     ///< x of the line from which the ticks go inwards
    float inwards = 1;  ///< 1: to the right, -1: to the left
    double middle = 0;  ///< the unit at half the height of the box
    double px_per_unit = 1;

    [[nodiscard]] float y_of(double unit) const noexcept;
    /// `texts` from the edge inwards.
    [[nodiscard]] float x_of(float texts, const Painter& painter) const { return edge + inwards * texts * painter.text_px(); }
};

enum class TapeBandLook : std::uint8_t {
    whole,
    half,  ///< along the edge; the inner half of the width is left to another band
    pole,  ///< white stripes over the colour
};

/// A range of values along the edge.
struct TapeBand {
    double low = 0, high = 0;
    design::Color color;
    TapeBandLook look = TapeBandLook::whole;
};
inline constexpr std::size_t kMaxTapeBands = 8;

/// A named value: one or two letters beyond the edge. Of flags that would overlap, only the first is shown.
struct TapeFlag {
    double at = 0;
    base::FixedString<2> letters;
    design::Color color;
};
inline constexpr std::size_t kMaxTapeFlags = design::kMaxSpeedFlags;

/// A selected value. When it is off the scale, the bug stays at the end and half of it is visible.
struct TapeBug {
    policy::ElementShow show = policy::ElementShow::absent;
    double at = 0;
};

/// The predicted value; no trend is shown where it differs from the present one by less than `threshold`.
struct TapeTrend {
    bool is_shown = false;
    double to = 0, threshold = 0;
};

/// Minimum of an approach. `color` as long as it is not flagged.
struct TapeMinimum {
    policy::ElementShow show = policy::ElementShow::absent;
    double at = 0;
    design::Color color;
};

struct TapeMarks {
    base::FixedVector<TapeBand, kMaxTapeBands> bands;  ///< later ones cover earlier ones
    base::FixedVector<TapeFlag, kMaxTapeFlags> flags;
    TapeBug bug;
    TapeTrend trend;
    TapeMinimum minimum;
};

void build_tape_bands(const Painter& painter, const TapeScale& scale, base::Span<const TapeBand> bands);
void build_tape_flags(const Painter& painter, const TapeScale& scale, base::Span<const TapeFlag> flags);
void build_tape_bug(const Painter& painter, const TapeScale& scale, const TapeBug& bug);
/// From the scale's middle.
void build_tape_trend(const Painter& painter, const TapeScale& scale, const TapeTrend& trend);
void build_tape_minimum(const Painter& painter, const TapeScale& scale, const TapeMinimum& minimum);

/// A row beside a scale: text in `color` on black, framed amber where it is flagged, crossed red with `name` where it failed,
/// nothing where it is absent.
struct TapeRow {
    policy::ElementShow show = policy::ElementShow::absent;
    std::string_view text, name;
    design::Color color;
    std::string_view short_text{};  ///< where the text is too long; empty: there is none
};
void build_tape_row(const Painter& painter, const Rect& box, const TapeRow& row);

}  // namespace tedavis::draw
