/// Pictures of other software, as the eye gets them: colours of 8 bits, opaque.
///
/// PNG by libpng; JPEG, TIFF, BMP, GIF and WebP by GDAL, as far as it was built with them. Grey values are colours with three
/// equal parts, palettes are looked up, 16 bits become the nearest of 8 (no gamma is applied), and what is transparent lies on
/// black, as on a screen that is off.
#pragma once

#include <string>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// Alpha is 255 everywhere. Throws UserError where the file is missing, empty, damaged, no picture, or larger than
/// 32768 pixels a side.
[[nodiscard]] RgbaPicture read_picture(const std::string& path);

}  // namespace tedavis::host_sim
