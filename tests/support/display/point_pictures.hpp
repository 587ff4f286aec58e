/// Pictures of the display with and without one of its elements, and whether they show it: pixels of its color that appear in its
/// place, in the one and not in the other.
#pragma once

#include <cmath>
#include <cstdlib>

#include "host_sim/png_file.hpp"
#include "render_core/design/color.hpp"
#include "render_core/draw/rect.hpp"

namespace tedavis::test_support {

/// Top row first, as host_sim::upright gives them.
struct PointPictures {
    host_sim::RgbaPicture with, without;
};

/// Smoothing and transparent grounds mix colors a little.
inline constexpr int kPointTolerance = 48;

inline bool is_of_color(const std::uint8_t* pixel, design::Color color) {
    return std::abs(pixel[0] - color.red) <= kPointTolerance && std::abs(pixel[1] - color.green) <= kPointTolerance &&
           std::abs(pixel[2] - color.blue) <= kPointTolerance;
}

/// Pixels of the color within the place that the picture without the element has not.
inline std::size_t gained_pixels(const PointPictures& pictures, const draw::Rect& place, design::Color color) {
    std::size_t gained = 0;
    const host_sim::RgbaPicture& picture = pictures.with;
    for (std::uint32_t y = 0; y < picture.height; ++y)
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const auto fx = static_cast<float>(x) + 0.5f, fy = static_cast<float>(y) + 0.5f;
            if (fx < place.x || fx > place.right() || fy < place.y || fy > place.bottom()) continue;
            const std::size_t at = (std::size_t{y} * picture.width + x) * 4;
            if (is_of_color(&pictures.with.pixels[at], color) && !is_of_color(&pictures.without.pixels[at], color)) ++gained;
        }
    return gained;
}

/// Control: the element is taken away.
inline PointPictures removed(const PointPictures& pictures) { return {pictures.without, pictures.without}; }

/// Control: what the element changed stands outside its place, around the edge of the screen if need be.
inline PointPictures moved(const PointPictures& pictures, const draw::Rect& place) {
    PointPictures changed{pictures.without, pictures.without};
    const std::uint32_t width = pictures.with.width, height = pictures.with.height;
    const bool is_wide = place.width > 0.5f * static_cast<float>(width);
    const auto by_x = is_wide ? 0u : static_cast<std::uint32_t>(std::ceil(place.width)) + 1;
    const auto by_y = is_wide ? static_cast<std::uint32_t>(std::ceil(place.height)) + 1 : 0u;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::size_t at = (std::size_t{y} * width + x) * 4;
            const bool is_inside = static_cast<float>(x) + 0.5f >= place.x && static_cast<float>(x) + 0.5f <= place.right() &&
                                   static_cast<float>(y) + 0.5f >= place.y && static_cast<float>(y) + 0.5f <= place.bottom();
            if (!is_inside) continue;
            const std::size_t to = (std::size_t{(y + by_y) % height} * width + (x + by_x) % width) * 4;
            for (std::size_t c = 0; c < 4; ++c) changed.with.pixels[to + c] = pictures.with.pixels[at + c];
        }
    return changed;
}

/// Control: the element has another color: red is blue, and blue is red; white and grey are green, and green is grey.
inline PointPictures recolored(const PointPictures& pictures) {
    PointPictures changed = pictures;
    for (std::size_t at = 0; at < changed.with.pixels.size(); at += 4) {
        std::uint8_t* const pixel = &changed.with.pixels[at];
        const std::uint8_t red = pixel[0];
        pixel[0] = pixel[2];
        pixel[2] = static_cast<std::uint8_t>(red / 2);
        pixel[1] = static_cast<std::uint8_t>(pixel[1] / 2);
    }
    return changed;
}

}  // namespace tedavis::test_support
