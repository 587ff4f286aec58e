/// A view of a picture, as the measures of perception read it.
///
/// Frame  rows from the top, pixels from the left; sRGB, eight bits per channel: red, green, blue, and an unused fourth channel
/// where there are four. Owns nothing; the bytes must outlive the view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tedavis::perception {

inline constexpr int kMaxPictureSide = 8192;
inline constexpr int kColors = 3, kMaxChannels = 4;

struct PictureView {
    const std::uint8_t* pixels = nullptr;  ///< pointer to the top row
    int width = 0, height = 0;             ///< 1..kMaxPictureSide
    int channels = 3;                      ///< bytes per pixel, 3 or 4
    std::ptrdiff_t row_bytes = 0;          ///< offset from a row to the one below; negative where the bottom row is stored first

    [[nodiscard]] const std::uint8_t* row(int y) const { return pixels + y * row_bytes; }
    [[nodiscard]] bool is_valid() const {
        const std::ptrdiff_t stride = row_bytes < 0 ? -row_bytes : row_bytes;
        return pixels != nullptr && width >= 1 && height >= 1 && width <= kMaxPictureSide && height <= kMaxPictureSide &&
               (channels == 3 || channels == 4) && stride >= std::ptrdiff_t{width} * channels;
    }
};

[[nodiscard]] constexpr std::size_t pixels_of(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Returns a view of a picture whose rows are stored without gaps, top row first.
[[nodiscard]] constexpr PictureView packed_picture(const std::uint8_t* pixels, int width, int height, int channels = kColors) {
    return {pixels, width, height, channels, std::ptrdiff_t{width} * channels};
}

/// Copies a row as red, green, blue triples; `out` has room for 3 x width bytes and one more.
inline void copy_colors(const PictureView& picture, int y, std::uint8_t* out) {
    const std::uint8_t* from = picture.row(y);
    if (picture.channels == kColors) {
        std::memcpy(out, from, static_cast<std::size_t>(kColors) * static_cast<std::size_t>(picture.width));
        return;
    }
    // The fourth byte is overwritten by the next pixel.
    for (int x = 0; x < picture.width; ++x) std::memcpy(out + kColors * x, from + 4 * x, 4);
}

}  // namespace tedavis::perception
