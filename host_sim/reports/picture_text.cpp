#include "host_sim/reports/picture_text.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

/// Bilinear, 0 .. 1; texel centres lie at halves.
float atlas_value(float u, float v) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    const auto at = [&](int x, int y) {
        const auto column = static_cast<std::size_t>(std::clamp(x, 0, atlas.width - 1));
        const auto row = static_cast<std::size_t>(std::clamp(y, 0, atlas.height - 1));
        return static_cast<float>(atlas.texels[row * static_cast<std::size_t>(atlas.width) + column]) / 255.0f;
    };
    const float left = std::floor(u - 0.5f), top = std::floor(v - 0.5f);
    const float right_share = u - 0.5f - left, bottom_share = v - 0.5f - top;
    const int x = static_cast<int>(left), y = static_cast<int>(top);
    const float upper = at(x, y) * (1 - right_share) + at(x + 1, y) * right_share;
    const float lower = at(x, y + 1) * (1 - right_share) + at(x + 1, y + 1) * right_share;
    return upper * (1 - bottom_share) + lower * bottom_share;
}

void blend(RgbaPicture& picture, std::uint32_t x, std::uint32_t y, const std::array<std::uint8_t, 3>& color, float coverage) {
    std::uint8_t* pixel = &picture.pixels[(std::size_t{y} * picture.width + x) * 4];
    for (std::size_t c = 0; c < 4; ++c) {
        const float ink = c < 3 ? color[c] : 255.0f;
        pixel[c] = static_cast<std::uint8_t>(std::lround(static_cast<float>(pixel[c]) * (1 - coverage) + ink * coverage));
    }
}

/// First pixel whose centre lies at or after the edge, inside 0 .. count.
std::uint32_t first_pixel(float edge, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(edge - 0.5f), 0.0f, static_cast<float>(count)));
}

void draw_glyph(RgbaPicture& picture, const draw::Glyph& glyph, float pen_x, float baseline_y, const PictureTextStyle& style) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    const float texel_px = style.size_px / atlas.texels_per_em;
    const float range_px = 2 * atlas.spread_em * style.size_px;  // pixels between the atlas's values 0 and 1
    const float left = pen_x + glyph.left * texel_px, top = baseline_y + glyph.top * texel_px;
    const std::uint32_t right = first_pixel(left + glyph.width * texel_px, picture.width);
    const std::uint32_t bottom = first_pixel(top + glyph.height * texel_px, picture.height);
    for (std::uint32_t y = first_pixel(top, picture.height); y < bottom; ++y) {
        for (std::uint32_t x = first_pixel(left, picture.width); x < right; ++x) {
            const float u = glyph.u + (static_cast<float>(x) + 0.5f - left) / texel_px;
            const float v = glyph.v + (static_cast<float>(y) + 0.5f - top) / texel_px;
            const float coverage = std::clamp((atlas_value(u, v) - 0.5f) * range_px + 0.5f, 0.0f, 1.0f);
            if (coverage > 0) blend(picture, x, y, style.color, coverage);
        }
    }
}

}  // namespace

PictureTextStyle fitted(std::string_view text, PictureTextStyle style, float room_px) {
    const float width = draw::text_width_px(text, style.size_px);
    if (width > room_px) style.size_px *= room_px / width;
    return style;
}

void draw_text(RgbaPicture& picture, std::string_view text, float x, float baseline_y, const PictureTextStyle& style) {
    while (!text.empty()) {
        const draw::Glyph& glyph = draw::glyph_of(draw::take_code_point(text));
        draw_glyph(picture, glyph, x, baseline_y, style);
        x += glyph.advance_em * style.size_px;
    }
}

}  // namespace tedavis::host_sim
