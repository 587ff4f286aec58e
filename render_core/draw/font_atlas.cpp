#include "render_core/draw/font_atlas.hpp"

#include <cstddef>

#include "render_core/draw/font/b612_glyphs.hpp"
#include "render_core/draw/font/b612_texels.hpp"

namespace tedavis::draw {
namespace {

static_assert(b612::k_b612_atlas_bin_size == static_cast<std::size_t>(b612::kWidth) * b612::kHeight,
              "atlas and measures are of one baking");

constexpr std::size_t kGlyphCount = sizeof b612::kGlyphs / sizeof b612::kGlyphs[0];
constexpr FontAtlas kAtlas{b612::kWidth,
                           b612::kHeight,
                           b612::kTexelsPerEm,
                           b612::kSpread_em,
                           b612::kCapHeight_em,
                           base::Span<const Glyph>(b612::kGlyphs, kGlyphCount),
                           base::Span<const std::uint8_t>(b612::k_b612_atlas_bin, b612::k_b612_atlas_bin_size)};

constexpr std::uint32_t kReplacement = 0xFFFD;

/// Index of the glyph, kGlyphCount when there is none.
constexpr std::size_t search(std::uint32_t code_point) noexcept {
    std::size_t low = 0, high = kGlyphCount;
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        if (b612::kGlyphs[middle].code_point < code_point)
            low = middle + 1;
        else
            high = middle;
    }
    return low < kGlyphCount && b612::kGlyphs[low].code_point == code_point ? low : kGlyphCount;
}

/// Most texts are ASCII.
struct AsciiPlaces {
    static constexpr std::uint32_t kCount = 0x80;
    std::uint16_t place[kCount] = {};

    constexpr AsciiPlaces() noexcept {
        for (std::uint32_t n = 0; n < kCount; ++n) place[n] = static_cast<std::uint16_t>(search(n));
    }
};
constexpr AsciiPlaces kAscii;

std::size_t find(std::uint32_t code_point) noexcept {
    return code_point < AsciiPlaces::kCount ? kAscii.place[code_point] : search(code_point);
}

/// Bytes of the sequence that starts with `lead`; 0 when no sequence starts so.
std::size_t sequence_length(unsigned char lead) noexcept {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead < 0xE0) return 2;
    if (lead >= 0xE0 && lead < 0xF0) return 3;
    return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

}  // namespace

const FontAtlas& font_atlas() noexcept { return kAtlas; }

const Glyph& glyph_of(std::uint32_t code_point) noexcept {
    const std::size_t found = find(code_point);
    return b612::kGlyphs[found < kGlyphCount ? found : find('?')];
}

std::uint32_t take_code_point(std::string_view& text) noexcept {
    const auto lead = static_cast<unsigned char>(text.front());
    if (lead < AsciiPlaces::kCount) {
        text.remove_prefix(1);
        return lead;
    }
    const std::size_t length = sequence_length(lead);
    constexpr unsigned char kLeadBits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    std::uint32_t code_point = lead & kLeadBits[length];
    bool whole = length != 0 && length <= text.size();
    for (std::size_t i = 1; whole && i < length; ++i) {
        const auto next = static_cast<unsigned char>(text[i]);
        whole = (next & 0xC0) == 0x80;
        code_point = code_point << 6 | (next & 0x3Fu);
    }
    constexpr std::uint32_t kShortest[] = {0, 0, 0x80, 0x800, 0x10000};
    whole = whole && code_point >= kShortest[length] && code_point <= 0x10FFFF && (code_point < 0xD800 || code_point > 0xDFFF);
    text.remove_prefix(whole ? length : 1);
    return whole ? code_point : kReplacement;
}

float text_width_px(std::string_view text, float size_px) noexcept {
    float width_em = 0;
    while (!text.empty()) width_em += glyph_of(take_code_point(text)).advance_em;
    return width_em * size_px;
}

}  // namespace tedavis::draw
