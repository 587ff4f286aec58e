/// The display's typeface: B612 Bold as a signed-distance atlas with its measures, baked by toolchains/bake_font.cpp.
///
/// One atlas serves every size. A texel holds 0.5 + distance / (2 * spread), positive inside the outline. Text is UTF-8;
/// broken sequences and characters without a glyph show '?'.
///
/// Thread    any (constant data). Memory  none. Failure  none.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"

namespace tedavis::draw {

struct Glyph {
    std::uint32_t code_point;
    float advance_em;
    /// Texels, from the pen on the baseline, y down; the spread around the outline is inside. Empty for a space.
    std::int16_t left, top, width, height;
    std::uint16_t u, v;  ///< top-left texel in the atlas
};

struct FontAtlas {
    int width = 0, height = 0;  ///< size in texels, powers of two
    float texels_per_em = 0;
    float spread_em = 0;                    ///< distance at which a texel reaches 0 or 1
    float cap_height_em = 0;                ///< height of the capitals and digits
    base::Span<const Glyph> glyphs;         ///< ascending code points
    base::Span<const std::uint8_t> texels;  ///< one byte each, top row first
};
[[nodiscard]] const FontAtlas& font_atlas() noexcept;

/// The glyph of a code point, '?' where the typeface has none.
[[nodiscard]] const Glyph& glyph_of(std::uint32_t code_point) noexcept;

/// Takes the first code point off `text`, which must not be empty; a broken sequence costs one byte and gives U+FFFD.
[[nodiscard]] std::uint32_t take_code_point(std::string_view& text) noexcept;

/// Width of a line of text, `size_px` pixels an em.
[[nodiscard]] float text_width_px(std::string_view text, float size_px) noexcept;

}  // namespace tedavis::draw
