/// Decomposes a picture into bands of three sizes and four directions, and a coarser residual.
///
/// Source: E. P. Simoncelli, W. T. Freeman, "The steerable pyramid", IEEE ICIP (1995); filters in the plane of frequencies as J.
/// Portilla, E. P. Simoncelli, International Journal of Computer Vision 40 (2000): raised cosines over an octave, cosines cubed
/// over directions. Together with the frequencies above the first band, the squares of all filters add up to 1. The picture is
/// continued periodically. A band's values are at the centres of its pixels, each 2^size of the picture's.
#pragma once

#include <vector>

#include "host_sim/evaluation/gaussian_window.hpp"

namespace tedavis::host_sim {

inline constexpr int kBandSizes = 3, kBandDirections = 4;

/// Returns the bands from the finest size on, direction by direction, then the residual: kBandSizes x kBandDirections + 1 maps,
/// each size with half the width and height of the one before. Sides are multiples of 2^kBandSizes without prime factors above 5.
[[nodiscard]] std::vector<ValueMap> steerable_bands(const ValueMap& picture);

}  // namespace tedavis::host_sim
