#include "host_sim/flight_test/text_in_pixels.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

/// Pixels from left, top up to before right, bottom.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
};

/// Of a quad, in the picture.
PixelBox box_of_quad(const WrittenGlyph& glyph, const RgbaPicture& picture) {
    const draw::Point last{glyph.right.x + glyph.down.x - glyph.corner.x, glyph.right.y + glyph.down.y - glyph.corner.y};
    const auto [left, right] = std::minmax({glyph.corner.x, glyph.right.x, glyph.down.x, last.x});
    const auto [top, bottom] = std::minmax({glyph.corner.y, glyph.right.y, glyph.down.y, last.y});
    const auto within = [](float value, std::uint32_t side) {
        return static_cast<int>(std::clamp(value, 0.0f, static_cast<float>(side)));
    };
    return {within(std::floor(left), picture.width), within(std::floor(top), picture.height),
            within(std::ceil(right), picture.width), within(std::ceil(bottom), picture.height)};
}

/// The atlas between its texels, as a bilinear sampler reads it; 0..1.
float atlas_value(float u, float v) {
    const draw::FontAtlas& atlas = draw::font_atlas();
    const float x = u * static_cast<float>(atlas.width) - 0.5f, y = v * static_cast<float>(atlas.height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const auto texel = [&](float column, float row) {
        const int c = std::clamp(static_cast<int>(column), 0, atlas.width - 1);
        const int r = std::clamp(static_cast<int>(row), 0, atlas.height - 1);
        return static_cast<float>(atlas.texels[static_cast<std::size_t>(r) * static_cast<std::size_t>(atlas.width) +
                                               static_cast<std::size_t>(c)]) /
               255;
    };
    const float right_share = x - left, down_share = y - top;
    const float above = texel(left, top) * (1 - right_share) + texel(left + 1, top) * right_share;
    const float below = texel(left, top + 1) * (1 - right_share) + texel(left + 1, top + 1) * right_share;
    return above * (1 - down_share) + below * down_share;
}

/// How far the middle of a pixel lies inside the outline, in pixels; nothing beyond the quad.
std::optional<float> inside_px(const WrittenGlyph& glyph, int x, int y) {
    const draw::Point right{glyph.right.x - glyph.corner.x, glyph.right.y - glyph.corner.y};
    const draw::Point down{glyph.down.x - glyph.corner.x, glyph.down.y - glyph.corner.y};
    const float area = right.x * down.y - right.y * down.x;
    if (area == 0) return std::nullopt;
    const float from_x = static_cast<float>(x) + 0.5f - glyph.corner.x, from_y = static_cast<float>(y) + 0.5f - glyph.corner.y;
    const float s = (from_x * down.y - from_y * down.x) / area, t = (right.x * from_y - right.y * from_x) / area;
    if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
    const float u = glyph.uv.x + s * (glyph.uv_right.x - glyph.uv.x) + t * (glyph.uv_down.x - glyph.uv.x);
    const float v = glyph.uv.y + s * (glyph.uv_right.y - glyph.uv.y) + t * (glyph.uv_down.y - glyph.uv.y);
    return (atlas_value(u, v) - 0.5f) * glyph.range_px;
}

float coverage_of(float inside_px, float thicker_px) { return std::clamp(inside_px + thicker_px + 0.5f, 0.0f, 1.0f); }

/// Neighbors reach into each other's quads.
float coverage_of_text(const PlacedWords& words, int x, int y) {
    float most = 0;
    for (const WrittenGlyph& glyph : words.glyphs)
        if (const std::optional<float> inside = inside_px(glyph, x, y)) most = std::max(most, coverage_of(*inside, 0));
    return most;
}

/// 0 for the color itself, less for others.
double likeness(const std::uint8_t* pixel, design::Color color) {
    const double red = pixel[0] - color.red, green = pixel[1] - color.green, blue = pixel[2] - color.blue;
    return -std::sqrt(red * red + green * green + blue * blue);
}

class Correlation {
public:
    void add(double a, double b) {
        ++count_;
        sum_a_ += a;
        sum_b_ += b;
        sum_aa_ += a * a;
        sum_bb_ += b * b;
        sum_ab_ += a * b;
    }
    /// 0 where one of the two does not vary, and where b grows with a by less than `slope`.
    [[nodiscard]] double value(double slope) const {
        if (count_ == 0) return 0;
        const double of_a = sum_aa_ - sum_a_ * sum_a_ / count_, of_b = sum_bb_ - sum_b_ * sum_b_ / count_;
        const double of_both = sum_ab_ - sum_a_ * sum_b_ / count_;
        return of_a > kSmall && of_b > kSmall && of_both >= slope * of_a ? of_both / std::sqrt(of_a * of_b) : 0;
    }

private:
    static constexpr double kSmall = 1e-6;
    double count_ = 0, sum_a_ = 0, sum_b_ = 0, sum_aa_ = 0, sum_bb_ = 0, sum_ab_ = 0;
};

double correlation_of(const RgbaPicture& picture, const PlacedWords& words, const WrittenGlyph& glyph) {
    Correlation correlation;
    const PixelBox box = box_of_quad(glyph, picture);
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) {
            const std::optional<float> inside = inside_px(glyph, x, y);
            if (!inside || (glyph.halo_px > 0 && coverage_of(*inside, glyph.halo_px) < 1)) continue;
            const std::size_t place = static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x);
            correlation.add(static_cast<double>(coverage_of_text(words, x, y)),
                            likeness(&picture.pixels[4 * place], glyph.color));
        }
    return correlation.value(kSeenDifference);
}

}  // namespace

std::optional<CharacterLook> faintest_character(const RgbaPicture& picture, const PlacedWords& words, std::size_t at,
                                                std::size_t end) {
    std::optional<CharacterLook> faintest;
    for (const WrittenGlyph& glyph : words.glyphs) {
        if (glyph.at < at || glyph.at >= end) continue;
        const double correlation = correlation_of(picture, words, glyph);
        if (faintest && faintest->correlation <= correlation) continue;
        faintest = {glyph.at, correlation, (glyph.right.x + glyph.down.x) / 2, (glyph.right.y + glyph.down.y) / 2};
    }
    return faintest;
}

}  // namespace tedavis::host_sim
