/// A picture in another size, as the hardware of a display scales it.
#pragma once

#include "host_sim/options/picture_options.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// Between the middles of the four nearest pixels linearly, in the numbers of the colours; beyond the outer middles as they are.
[[nodiscard]] RgbaPicture scaled_picture(const RgbaView& picture, const PictureSize& size);

}  // namespace tedavis::host_sim
