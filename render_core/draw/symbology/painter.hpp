/// Strokes, texts and signs of failure in the one style that all symbols share.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/draw/quad_batch.hpp"
#include "render_core/draw/symbology/fitted_words.hpp"
#include "render_core/draw/symbology/layout.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"
#include "render_core/draw/text_size.hpp"

namespace tedavis::draw {

using design::SymbolRole;

using ShortText = base::FixedString<31>;

/// Returns `value` limited to [low, high]; NaN becomes `low`. Keeps numbers printable and loops bounded.
[[nodiscard]] double limited(double value, double low, double high) noexcept;
/// Returns the value rounded to a whole number, with at least `digits` digits and a minus sign where it is negative.
[[nodiscard]] ShortText whole_number(double value, int digits = 1) noexcept;
/// Returns the value with one decimal; never "-0.0".
[[nodiscard]] ShortText tenths(double value) noexcept;

/// Text on a black plate needs no dark rim.
enum class TextRim : std::uint8_t { dark, none };

class Painter {
public:
    /// All must outlive the painter. AC 25-11B: colour is never the only cue.
    Painter(QuadBatch& batch, const Layout& layout, const design::SymbologyPalette& palette = design::kDaySymbology)
        : batch_(batch), layout_(layout), palette_(palette) {}

    [[nodiscard]] QuadBatch& batch() const { return batch_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }
    [[nodiscard]] float text_px() const { return layout_.text_px; }
    [[nodiscard]] float stroke_px() const { return layout_.stroke_px; }
    [[nodiscard]] design::Color color(SymbolRole role) const { return palette_.color(role); }
    /// Sizes of text.
    [[nodiscard]] const design::SymbologyType& type() const { return palette_.type; }
    /// Colour of the label of an element: that of scales, or amber where the value is stale or not from its first source.
    [[nodiscard]] design::Color label_color(policy::ElementShow show) const;

    /// Pixels an em of a text of this size, in texts.
    [[nodiscard]] float em_px(float size) const { return size * text_px() > kMinText_px ? size * text_px() : kMinText_px; }

    /// Width of a plate that is so many texts wide, or as wide as its text of the smallest size needs.
    [[nodiscard]] float plate_px(std::string_view text, float texts) const;

    /// Lines have a dark rim; without a colour they have that of scales. `strokes` is the width in ordinary lines.
    void line(Point from, Point to, design::Color color, float strokes = 1) const;
    void line(Point from, Point to) const { line(from, to, color(SymbolRole::scale)); }
    void polyline(base::Span<const Point> points, design::Color color, float strokes = 1, bool closed = false) const;
    void polyline(base::Span<const Point> points) const { polyline(points, color(SymbolRole::scale)); }
    /// `size` in texts; no text is smaller than kMinText_px.
    void text(std::string_view text, Point at, TextAnchor anchor, float size, design::Color color, float angle_rad = 0,
              TextRim rim = TextRim::dark) const;
    void text(std::string_view text, Point at, TextAnchor anchor, float size) const {
        this->text(text, at, anchor, size, color(SymbolRole::scale));
    }
    /// Draws a text at half the height of the box, smaller where it does not fit. Where it would be below kMinText_px, it has
    /// shorter words or lacks its last letters (cut_words()).
    void fitted_text(const Words& words, const Rect& box, TextAnchor anchor, float size, design::Color color,
                     TextRim rim = TextRim::dark) const;
    /// Draw text in the middle of a black box, the second with a frame of the text's colour.
    void plate(const Rect& box, const Words& words, float size, design::Color color) const;
    void framed_plate(const Rect& box, const Words& words, float size, design::Color color) const;
    /// Draws failed information: a dark box, a red cross and the name of what failed, in a narrow box one word per line.
    void failed(const Rect& box, std::string_view text) const;
    /// Draws information that is lost but replaced by other information: amber text over a red cross. A box that is too small for
    /// the smallest text is enlarged, within the attitude or the rose if it lies there.
    void crossed_out(const Rect& box, std::string_view text) const;
    /// Draws a framed number over its scale, with amber frame and digits when `flagged`.
    void readout(const Rect& box, std::string_view text, bool flagged) const;

private:
    QuadBatch& batch_;
    const Layout& layout_;
    const design::SymbologyPalette& palette_;
};

}  // namespace tedavis::draw
