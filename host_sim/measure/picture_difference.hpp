/// How different two pictures look, by the eye's measure instead of by numbers of colours.
#pragma once

#include <cstdint>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

struct PictureDifference {
    double mean = 0, largest = 0;  ///< CIEDE2000 over all pixels
    /// Mean over all pixels of how much the gradient of lightness (Sobel, in L* per pixel) differs: lines that came or went,
    /// where flat areas of another tone leave it at 0.
    double edges = 0;
};

/// Alpha is not looked at. Throws UserError where the sizes differ.
[[nodiscard]] PictureDifference picture_difference(const RgbaView& first, const RgbaView& second);

}  // namespace tedavis::host_sim
