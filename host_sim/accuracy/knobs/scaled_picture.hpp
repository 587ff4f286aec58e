/// Scales a picture as the hardware of a display does.
#pragma once

#include "host_sim/options/picture_options.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// Interpolates bilinearly between the centres of the four nearest pixels, in the coded values of the colours; beyond the outer
/// centres the nearest pixel is repeated.
[[nodiscard]] RgbaPicture scaled_picture(const RgbaView& picture, const PictureSize& size);

}  // namespace tedavis::host_sim
