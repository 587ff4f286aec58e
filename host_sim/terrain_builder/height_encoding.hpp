/// Decodes heights from the colours of a picture.
#pragma once

#include <cstdint>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {

/// Returns the height of a pixel in metres. By convention black in terrain_rgb means "no height"; it decodes to a height below
/// any land.
[[nodiscard]] inline double decoded_height_m(HeightEncoding encoding, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    if (encoding == HeightEncoding::terrarium) return red * 256.0 + green + blue / 256.0 - 32768.0;
    return (red * 65536 + green * 256 + blue - 100000) / 10.0;
}

}  // namespace tedavis::host_sim
