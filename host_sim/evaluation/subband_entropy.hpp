/// Subband Entropy, a third opinion on clutter: how many bits a value of the picture's bands has. 0 in a flat picture.
///
/// Source: R. Rosenholtz, Y. Li, L. Nakano, "Measuring visual clutter", Journal of Vision 7(2):17 (2007): the mean entropy of the
/// bands of a steerable pyramid, 0.84 for lightness and 0.08 for each of the colours' two axes. A band's values are counted in as
/// many equal steps as the square root of their number says, from the least to the greatest: entropy tells how they are spread,
/// not how strong they are.
#pragma once

#include "host_sim/evaluation/lab_levels.hpp"

namespace tedavis::host_sim {

/// Bits.
[[nodiscard]] double subband_entropy(const LabLevels& picture);

}  // namespace tedavis::host_sim
