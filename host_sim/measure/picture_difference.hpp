/// The difference of two pictures by perceptual measures.
#pragma once

#include <cstdint>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

struct PictureDifference {
    double mean = 0, largest = 0;  ///< CIEDE2000 over all pixels
    /// Mean over all pixels of the difference of lightness gradients (Sobel, in L* per pixel). Added or removed lines raise it;
    /// flat areas of another tone do not.
    double edges = 0;
};

/// Alpha is ignored. Throws UserError where the sizes differ.
[[nodiscard]] PictureDifference picture_difference(const RgbaView& first, const RgbaView& second);

}  // namespace tedavis::host_sim
