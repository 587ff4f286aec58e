/// Subband Entropy, a third measure of clutter: the bits per value of the picture's bands. 0 for a uniform picture.
///
/// Source: R. Rosenholtz, Y. Li, L. Nakano, "Measuring visual clutter", Journal of Vision 7(2):17 (2007): the mean entropy of
/// the bands of a steerable pyramid, 0.84 for lightness and 0.08 for each of the colours' two axes. A band's histogram has as
/// many bins as the square root of the number of its values, from the least to the greatest: entropy measures their
/// distribution, not their strength.
#pragma once

#include "host_sim/evaluation/lab_levels.hpp"

namespace tedavis::host_sim {

/// Returns the Subband Entropy, bits.
[[nodiscard]] double subband_entropy(const LabLevels& picture);

}  // namespace tedavis::host_sim
