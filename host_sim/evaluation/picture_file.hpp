/// Reads pictures of other software as they are displayed: 8-bit colours, opaque.
///
/// PNG by libpng; JPEG, TIFF, BMP, GIF and WebP by GDAL, as far as it was built with them. Grey values give three equal
/// channels, palettes are resolved, 16 bits are rounded to 8 (without gamma), and transparent pixels are composed over black.
#pragma once

#include <string>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// Alpha is 255 everywhere. Throws UserError where the file is missing, empty, damaged, no picture, or larger than
/// 32768 pixels a side.
[[nodiscard]] RgbaPicture read_picture(const std::string& path);

}  // namespace tedavis::host_sim
