/// Pictures made from formulas, for measures of pictures.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render_core/perception/picture_view.hpp"

namespace tedavis::test_support {

using Rgb = std::array<std::uint8_t, 3>;

struct SyntheticPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;

    /// `color` is called with column and row.
    template <class Color>
    SyntheticPicture(int columns, int rows, const Color& color)
        : width(columns), height(rows), pixels(3 * perception::pixels_of(columns, rows)) {
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) set(x, y, color(x, y));
    }
    [[nodiscard]] Rgb at(int x, int y) const {
        const std::uint8_t* pixel = pixels.data() + 3 * (perception::pixels_of(width, y) + static_cast<std::size_t>(x));
        return {pixel[0], pixel[1], pixel[2]};
    }
    void set(int x, int y, const Rgb& color) {
        for (std::size_t c = 0; c < 3; ++c)
            pixels[3 * (perception::pixels_of(width, y) + static_cast<std::size_t>(x)) + c] = color[c];
    }
    [[nodiscard]] perception::PictureView view() const { return perception::packed_picture(pixels.data(), width, height); }

    /// By a right angle, clockwise.
    [[nodiscard]] SyntheticPicture turned() const {
        return {height, width, [this](int x, int y) { return at(y, height - 1 - x); }};
    }
    [[nodiscard]] SyntheticPicture mirrored() const {
        return {width, height, [this](int x, int y) { return at(width - 1 - x, y); }};
    }
};

inline SyntheticPicture flat_picture(int width, int height, const Rgb& color) {
    return {width, height, [&](int, int) { return color; }};
}

/// A number of 32 bits that follows from three.
inline std::uint32_t scrambled(std::uint32_t a, std::uint32_t b, std::uint32_t seed) {
    std::uint32_t n = a * 0x9E3779B1u ^ (b + 0x85EBCA6Bu) * 0xC2B2AE3Du ^ seed * 0x27D4EB2Fu;
    n = (n ^ n >> 15) * 0x2C1B3C6Du;
    n = (n ^ n >> 12) * 0x297A2D39u;
    return n ^ n >> 15;
}

/// Every pixel by chance, within `span` levels from `least`.
inline SyntheticPicture noise_picture(int width, int height, std::uint32_t seed, int least = 0, int span = 256) {
    return {width, height, [&](int x, int y) {
                Rgb color;
                for (std::uint32_t c = 0; c < 3; ++c)
                    color[c] = static_cast<std::uint8_t>(
                        least +
                        static_cast<int>(scrambled(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 3 * seed + c) %
                                         static_cast<std::uint32_t>(span)));
                return color;
            }};
}

/// Squares of `side` pixels, black and white.
inline SyntheticPicture checkerboard(int width, int height, int side) {
    return {width, height, [&](int x, int y) { return (x / side + y / side) % 2 == 0 ? Rgb{0, 0, 0} : Rgb{255, 255, 255}; }};
}

/// Like terrain under a sky with signs before it: ramps, patches of colour with slanted borders, and thin lines.
inline SyntheticPicture landscape(int width, int height, std::uint32_t seed) {
    return {width, height, [&](int x, int y) {
                const int skyline = height / 3 +
                                    static_cast<int>(scrambled(static_cast<std::uint32_t>(x / 37), 0, seed) % 40) * height / 400 +
                                    x * static_cast<int>(seed % 7) / 20;
                const auto ramp = static_cast<std::uint8_t>(255 * y / height);
                if (y < skyline)
                    return Rgb{static_cast<std::uint8_t>(40 + ramp / 3), static_cast<std::uint8_t>(90 + ramp / 3), 210};
                const std::uint32_t patch = scrambled(static_cast<std::uint32_t>((x + y / 3) / 53),
                                                      static_cast<std::uint32_t>((y - x / 5 + 4000) / 41), seed);
                if (patch % 11 == 0 && (x + 2 * y) % 9 == 0) return Rgb{255, 255, 255};
                const auto shade = static_cast<std::uint8_t>(patch >> 8 & 0x3F);
                return patch % 3 == 0
                           ? Rgb{static_cast<std::uint8_t>(120 + shade), static_cast<std::uint8_t>(100 + shade / 2), 30}
                           : Rgb{static_cast<std::uint8_t>(40 + shade / 2), static_cast<std::uint8_t>(70 + shade),
                                 static_cast<std::uint8_t>(20 + ramp / 8)};
            }};
}

}  // namespace tedavis::test_support
