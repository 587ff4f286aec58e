#include "host_sim/evaluation/evaluation_views.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/reports/picture_text.hpp"
#include "render_core/draw/font_atlas.hpp"

namespace tedavis::host_sim {
namespace {

constexpr float kDimmed = 0.55f;    // of the grey picture under colours
constexpr double kFullTint = 0.25;  // the density at which a region has the scale's last colour

std::uint8_t byte_of(float value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 255.0f))); }

/// Rec. 709 on the stored values: enough for a backdrop.
float dim_grey(const std::uint8_t* pixel) {
    return kDimmed * (0.2126f * static_cast<float>(pixel[0]) + 0.7152f * static_cast<float>(pixel[1]) +
                      0.0722f * static_cast<float>(pixel[2]));
}

void paint(std::uint8_t* pixel, float grey, const std::array<std::uint8_t, 3>& color, float share) {
    for (std::size_t c = 0; c < 3; ++c) pixel[c] = byte_of(grey * (1 - share) + static_cast<float>(color[c]) * share);
    pixel[3] = 255;
}

RgbaPicture blank(std::uint32_t width, std::uint32_t height) {
    return {width, height, std::vector<std::uint8_t>(std::size_t{width} * height * 4, 255)};
}

/// Place of a pixel's middle among those of the cells: the one before it, and the share of the next one.
struct Between {
    std::uint32_t first, second;
    float share;
};

Between between(std::uint32_t pixel, float cell, std::uint32_t cells) {
    const float place = (static_cast<float>(pixel) + 0.5f) / cell - 0.5f;
    const float inside = std::clamp(place, 0.0f, static_cast<float>(cells - 1));
    const auto first = static_cast<std::uint32_t>(inside);
    return {first, std::min(first + 1, cells - 1), inside - static_cast<float>(first)};
}

void write_density(RgbaPicture& picture, const perception::PixelRegion& region, double density) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2f", density);
    const float width = static_cast<float>(region.right - region.left), height = static_cast<float>(region.bottom - region.top);
    PictureTextStyle style{std::min(0.3f * height, 22.0f), {0xff, 0xff, 0xff}};
    style = fitted(text, style, 0.8f * width);
    if (style.size_px < 6) return;
    const float x = static_cast<float>(region.left) + 0.5f * (width - draw::text_width_px(text, style.size_px));
    const float y = static_cast<float>(region.top) + 0.5f * height + 0.36f * style.size_px;
    const PictureTextStyle shadow{style.size_px, {0, 0, 0}};
    for (const auto& [dx, dy] : {std::pair{-1.0f, 0.0f}, std::pair{1.0f, 0.0f}, std::pair{0.0f, -1.0f}, std::pair{0.0f, 1.0f}})
        draw_text(picture, text, x + dx, y + dy, shadow);
    draw_text(picture, text, x, y, style);
}

}  // namespace

FloatMap enlarged(const FloatMap& map, std::uint32_t picture_width, std::uint32_t picture_height) {
    FloatMap out{picture_width, picture_height, 1, 1, std::vector<float>(std::size_t{picture_width} * picture_height)};
    for (std::uint32_t y = 0; y < picture_height; ++y) {
        const Between v = between(y, map.cell_height, map.height);
        for (std::uint32_t x = 0; x < picture_width; ++x) {
            const Between u = between(x, map.cell_width, map.width);
            const float upper = map.at(u.first, v.first) * (1 - u.share) + map.at(u.second, v.first) * u.share;
            const float lower = map.at(u.first, v.second) * (1 - u.share) + map.at(u.second, v.second) * u.share;
            out.values[std::size_t{y} * picture_width + x] = upper * (1 - v.share) + lower * v.share;
        }
    }
    return out;
}

std::array<std::uint8_t, 3> heat_color(float value) {
    static constexpr std::array<std::array<float, 3>, 6> kStops = {
        {{0, 0, 4}, {66, 10, 104}, {147, 38, 103}, {221, 81, 58}, {252, 165, 10}, {252, 255, 164}}};
    const float place = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(kStops.size() - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const float share = place - static_cast<float>(first);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = byte_of(kStops[first][c] * (1 - share) + kStops[first + 1][c] * share);
    return color;
}

RgbaPicture saliency_picture(const FloatMap& map) {
    RgbaPicture picture = blank(map.width, map.height);
    for (std::size_t n = 0; n < map.values.size(); ++n) std::fill_n(&picture.pixels[4 * n], 3, byte_of(255 * map.values[n]));
    return picture;
}

RgbaPicture heat_picture(const RgbaPicture& picture, const FloatMap& map) {
    // Most of a map is far below its maximum: colours are spread towards small values, and what is next to nothing stays grey.
    constexpr float kSpread = 0.6f, kFullCover = 0.3f, kMaxCover = 0.9f;
    RgbaPicture heat = blank(picture.width, picture.height);
    for (std::size_t n = 0; n < map.values.size(); ++n) {
        const float value = std::clamp(map.values[n], 0.0f, 1.0f);
        const float cover = kMaxCover * std::min(value / kFullCover, 1.0f);
        paint(&heat.pixels[4 * n], dim_grey(&picture.pixels[4 * n]), heat_color(std::pow(value, kSpread)), cover);
    }
    return heat;
}

RgbaPicture edge_picture(const std::vector<std::uint8_t>& edges, std::uint32_t width, std::uint32_t height) {
    RgbaPicture picture = blank(width, height);
    for (std::size_t n = 0; n < edges.size(); ++n)
        std::fill_n(&picture.pixels[4 * n], 3, static_cast<std::uint8_t>(edges[n] != 0 ? 255 : 0));
    return picture;
}

RgbaPicture region_picture(const RgbaPicture& picture, const perception::RegionGrid& grid, const std::vector<double>& densities) {
    RgbaPicture out = blank(picture.width, picture.height);
    for (std::size_t n = 0; n < out.pixels.size(); n += 4) paint(&out.pixels[n], dim_grey(&picture.pixels[n]), {}, 0);
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    auto next = densities.begin();
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const perception::PixelRegion region = perception::region_of(grid, column, row, width, height);
            const double density = *next++;
            const auto value = static_cast<float>(std::min(density / kFullTint, 1.0));
            for (int y = region.top; y < region.bottom - 1; ++y) {
                for (int x = region.left; x < region.right - 1; ++x) {
                    std::uint8_t* pixel =
                        &out.pixels[(static_cast<std::size_t>(y) * picture.width + static_cast<std::size_t>(x)) * 4];
                    paint(pixel, static_cast<float>(pixel[0]), heat_color(value), 0.2f + 0.5f * value);
                }
            }
            write_density(out, region, density);
        }
    }
    return out;
}

}  // namespace tedavis::host_sim
