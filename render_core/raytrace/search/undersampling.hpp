/// **Inexact.** Draws a picture with fewer rays: pixels between corners of similar colour are interpolated (adaptive
/// undersampling: Akimoto, Mase and Suenaga 1991).
///
/// The picture is divided into squares, whose corners are traced. Where no channel differs between the corners by more than the
/// allowed contrast, the other pixels are interpolated bilinearly; else the square is divided into four, down to single pixels.
///
/// What goes wrong: an object that lies between the corners of a square is not drawn, whatever its contrast: peaks of a skyline,
/// needles, thin shadows. Smaller squares and a lower contrast make that rarer, but not impossible. With squares of one pixel, or
/// a contrast below zero, every pixel is traced.
///
/// No recursion, no heap: the caller provides the memory. Pure apart from `color`, which is called at most once per pixel.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/check.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::raytrace {

struct Undersampling {
    static constexpr std::uint32_t kLargestSquare = 64;

    std::uint32_t square = 8;    ///< pixels from corner to corner, 1..kLargestSquare
    float contrast = 4 / 255.f;  ///< largest difference of a channel, 0..1, over which pixels are interpolated
};

struct UndersampledPicture {
    base::Span<glm::vec3> pixels;     ///< row by row
    base::Span<std::uint8_t> traced;  ///< one per pixel; 1 where the pixel was traced; all 0 before the first call
    std::uint32_t width = 0, height = 0;
};

namespace undersampling {

struct Square {
    std::uint32_t left, top, right, bottom;  ///< pixels of the corners, which are part of the square
};

template <class Color>
const glm::vec3& traced_pixel(const UndersampledPicture& picture, std::uint32_t x, std::uint32_t y, const Color& color,
                              std::uint64_t& rays) {
    const std::size_t pixel = std::size_t{y} * picture.width + x;
    if (picture.traced[pixel] == 0) {
        picture.pixels[pixel] = color(x, y);
        picture.traced[pixel] = 1;
        ++rays;
    }
    return picture.pixels[pixel];
}

inline float contrast_of(const glm::vec3 (&corner)[4]) {
    float most = 0;
    for (int channel = 0; channel < 3; ++channel) {
        const auto [low, high] = std::minmax({corner[0][channel], corner[1][channel], corner[2][channel], corner[3][channel]});
        most = std::max(most, high - low);
    }
    return most;
}

inline void interpolate(const UndersampledPicture& picture, const Square& square, const glm::vec3 (&corner)[4]) {
    const float across = static_cast<float>(std::max(square.right - square.left, 1u));
    const float down = static_cast<float>(std::max(square.bottom - square.top, 1u));
    for (std::uint32_t y = square.top; y <= square.bottom; ++y)
        for (std::uint32_t x = square.left; x <= square.right; ++x) {
            const std::size_t pixel = std::size_t{y} * picture.width + x;
            if (picture.traced[pixel] != 0) continue;
            const float u = static_cast<float>(x - square.left) / across, v = static_cast<float>(y - square.top) / down;
            picture.pixels[pixel] = (corner[0] * (1 - u) + corner[1] * u) * (1 - v) + (corner[2] * (1 - u) + corner[3] * u) * v;
        }
}

}  // namespace undersampling

/// Draws a tile, corners included, which lies within the picture. Tiles of concurrent workers must not share pixels. Returns the
/// number of traced pixels. `color(x, y)` traces a pixel and returns its colour.
template <class Color>
std::uint64_t undersample(const UndersampledPicture& picture, const undersampling::Square& tile, const Undersampling& settings,
                          const Color& color) {
    using undersampling::Square;
    TEDAVIS_CHECK(tile.right < picture.width && tile.bottom < picture.height && settings.square >= 1 &&
                  settings.square <= Undersampling::kLargestSquare);
    constexpr int kDeepest = 7 * 3 + 2;
    Square waiting[kDeepest];
    std::uint64_t rays = 0;
    for (std::uint32_t top = tile.top; top == tile.top || top < tile.bottom; top += settings.square)
        for (std::uint32_t left = tile.left; left == tile.left || left < tile.right; left += settings.square) {
            int count = 0;
            waiting[count++] = {left, top, std::min(left + settings.square, tile.right),
                                std::min(top + settings.square, tile.bottom)};
            while (count > 0) {
                const Square square = waiting[--count];
                const auto at = [&](std::uint32_t x, std::uint32_t y) {
                    return undersampling::traced_pixel(picture, x, y, color, rays);
                };
                const glm::vec3 corner[4] = {at(square.left, square.top), at(square.right, square.top),
                                             at(square.left, square.bottom), at(square.right, square.bottom)};
                const bool is_smallest = square.right - square.left <= 1 && square.bottom - square.top <= 1;
                if (is_smallest) continue;
                if (undersampling::contrast_of(corner) <= settings.contrast) {
                    undersampling::interpolate(picture, square, corner);
                    continue;
                }
                const std::uint32_t x = (square.left + square.right) / 2, y = (square.top + square.bottom) / 2;
                const bool is_wide = square.right - square.left > 1, is_high = square.bottom - square.top > 1;
                waiting[count++] = {square.left, square.top, is_wide ? x : square.right, is_high ? y : square.bottom};
                if (is_wide) waiting[count++] = {x, square.top, square.right, is_high ? y : square.bottom};
                if (is_high) waiting[count++] = {square.left, y, is_wide ? x : square.right, square.bottom};
                if (is_wide && is_high) waiting[count++] = {x, y, square.right, square.bottom};
            }
        }
    return rays;
}

}  // namespace tedavis::raytrace
