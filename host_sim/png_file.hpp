/// PNG pictures: 8-bit RGBA or grey, top row first.
///
/// The same pixels always give the same bytes (fixed compression and filter settings).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tedavis::host_sim {

struct RgbaPicture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  ///< width * height * 4
};

/// Rows of RGBA8 without copying them. `bottom_up`: the bottom row comes first, as GL reads back.
struct RgbaView {
    const std::uint8_t* pixels = nullptr;
    std::uint32_t width = 0, height = 0;
    bool bottom_up = false;

    [[nodiscard]] const std::uint8_t* row(std::uint32_t y_from_top) const {
        const std::size_t place = bottom_up ? height - 1 - y_from_top : y_from_top;
        return pixels + place * width * 4;
    }
};
/// A copy, top row first.
[[nodiscard]] RgbaPicture upright(const RgbaView& view);
[[nodiscard]] inline RgbaView view_of(const RgbaPicture& picture) {
    return {picture.pixels.data(), picture.width, picture.height, false};
}

/// One number per pixel, top row first, without copying them.
struct GreyView {
    const std::uint8_t* pixels = nullptr;
    std::uint32_t width = 0, height = 0;

    [[nodiscard]] const std::uint8_t* row(std::uint32_t y_from_top) const { return pixels + std::size_t{y_from_top} * width; }
};

using PaletteColor = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// A picture of 256 colors at most, without alpha.
struct PalettePicture {
    std::uint32_t width = 0, height = 0;
    std::vector<PaletteColor> colors;
    std::vector<std::uint8_t> pixels;  ///< width * height indices in `colors`, top row first
};

/// The file's bytes.
[[nodiscard]] std::string encode_png(const RgbaView& view);
[[nodiscard]] std::string encode_grey_png(const GreyView& view);
/// The same without alpha and compressed as far as possible, for pages that embed their pictures. A picture of greys alone has
/// one channel.
[[nodiscard]] std::string encode_small_png(const RgbaView& view);
/// Compressed as far as possible.
[[nodiscard]] std::string encode_palette_png(const PalettePicture& picture);
/// Writes a file, complete or not at all. Throws UserError.
void write_png(const std::string& path, const RgbaView& view);
/// Reads any PNG as RGBA8. Throws UserError where it is missing, damaged or no PNG.
[[nodiscard]] RgbaPicture read_png(const std::string& path);

/// The picture at 1/n of its size, each pixel the mean of its n x n block (cut at the border); n such that the result
/// is at most `max_width` wide.
[[nodiscard]] RgbaPicture shrunk(const RgbaView& view, std::uint32_t max_width);

}  // namespace tedavis::host_sim
