/// Heights that a picture holds as colours.
#pragma once

#include <cstdint>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

/// Metres of one pixel; terrain_rgb with black means "no height" by convention and lies below every land.
[[nodiscard]] inline double decoded_height_m(HeightEncoding encoding, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    if (encoding == HeightEncoding::terrarium) return red * 256.0 + green + blue / 256.0 - 32768.0;
    return (red * 65536 + green * 256 + blue - 100000) / 10.0;
}

}  // namespace tedavis::host_sim
