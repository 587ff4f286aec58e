#include "host_sim/accuracy/knobs/scaled_picture.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

/// The two pixels between whose middles a place lies, along one axis.
struct PixelPair {
    std::uint32_t first = 0, second = 0;
    double share = 0;  ///< of the second one

    PixelPair(std::uint32_t at, std::uint32_t to, std::uint32_t from) {
        const double place = std::clamp((at + 0.5) * from / to - 0.5, 0.0, from - 1.0);
        first = static_cast<std::uint32_t>(place);
        second = std::min(first + 1, from - 1);
        share = place - first;
    }
    [[nodiscard]] double of(double a, double b) const { return a + share * (b - a); }
};

}  // namespace

RgbaPicture scaled_picture(const RgbaView& picture, const PictureSize& size) {
    RgbaPicture scaled;
    scaled.width = size.width;
    scaled.height = size.height;
    scaled.pixels.reserve(std::size_t{4} * size.width * size.height);
    for (std::uint32_t y = 0; y < size.height; ++y) {
        const PixelPair down(y, size.height, picture.height);
        const std::uint8_t *const above = picture.row(down.first), *const below = picture.row(down.second);
        for (std::uint32_t x = 0; x < size.width; ++x) {
            const PixelPair across(x, size.width, picture.width);
            for (std::size_t color = 0; color < 4; ++color) {
                const std::size_t left = std::size_t{4} * across.first + color, right = std::size_t{4} * across.second + color;
                const double value = down.of(across.of(above[left], above[right]), across.of(below[left], below[right]));
                scaled.pixels.push_back(static_cast<std::uint8_t>(std::lround(value)));
            }
        }
    }
    return scaled;
}

}  // namespace tedavis::host_sim
