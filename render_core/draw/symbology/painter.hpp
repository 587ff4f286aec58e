/// Strokes, texts and failure pictures that all symbols share: one style for the whole display.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/layout.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::draw {

// AC 25-11B table 5-1: red warning, amber caution, white scales, green engaged. Colour is never the only cue.
inline constexpr design::Color kScaleColor{255, 255, 255};
inline constexpr design::Color kWarningColor{255, 48, 48};
inline constexpr design::Color kCautionColor{255, 176, 0};
inline constexpr design::Color kEngagedColor{64, 240, 96};
inline constexpr design::Color kSelectedColor{0, 224, 255};     ///< what the pilot has selected
inline constexpr design::Color kGnssCourseColor{255, 96, 255};  ///< course and deviations of GNSS; of radio: kEngagedColor
inline constexpr design::Color kReferenceColor{255, 224, 0};
inline constexpr design::Color kRimColor{0, 0, 0};
inline constexpr design::Color kTapeGround{16, 20, 28, 150};
inline constexpr design::Color kReadoutGround{0, 0, 0, 255};

using ShortText = base::FixedString<31>;

/// `value` within [low, high]; not-a-number becomes `low`. Keeps numbers printable and loops bounded.
[[nodiscard]] double limited(double value, double low, double high) noexcept;
/// Rounded to a whole number, with at least `digits` digits and a minus sign where it is negative.
[[nodiscard]] ShortText whole_number(double value, int digits = 1) noexcept;

/// Text on a black plate needs no dark rim.
enum class TextRim : std::uint8_t { dark, none };

class Painter {
public:
    Painter(QuadBatch& batch, const Layout& layout) : batch_(batch), layout_(layout) {}

    [[nodiscard]] QuadBatch& batch() const { return batch_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }
    [[nodiscard]] float text_px() const { return layout_.text_px; }
    [[nodiscard]] float stroke_px() const { return layout_.stroke_px; }

    /// White by default, with a dark rim.
    void line(Point from, Point to, design::Color color = kScaleColor, float strokes = 1) const;
    void polyline(base::Span<const Point> points, design::Color color = kScaleColor, float strokes = 1,
                  bool closed = false) const;
    /// `size` in texts.
    void text(std::string_view text, Point at, TextAnchor anchor, float size, design::Color color = kScaleColor,
              float angle_rad = 0, TextRim rim = TextRim::dark) const;
    /// Shrunk to the width where it does not fit; middle of the height.
    void fitted_text(std::string_view text, const Rect& box, TextAnchor anchor, float size, design::Color color,
                     TextRim rim = TextRim::dark) const;
    /// Text in the middle of a black box, and with a frame of its colour.
    void plate(const Rect& box, std::string_view text, float size, design::Color color) const;
    void framed_plate(const Rect& box, std::string_view text, float size, design::Color color) const;
    /// The picture of failed information in its place: a dark box, a red cross and what failed.
    void failed(const Rect& box, std::string_view text) const;
    /// What is lost but replaced by something else: amber text over a red cross.
    void crossed_out(const Rect& box, std::string_view text) const;
    /// Framed number over its scale; amber frame and digits when `flagged`.
    void readout(const Rect& box, std::string_view text, bool flagged) const;

private:
    QuadBatch& batch_;
    const Layout& layout_;
};

/// Colour of a label by how its element is shown: white, or amber where it is not from its first source or is stale.
[[nodiscard]] design::Color label_color(policy::ElementShow show) noexcept;

}  // namespace tedavis::draw
