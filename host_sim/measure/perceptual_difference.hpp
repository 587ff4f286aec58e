/// Computes how visible the difference of two pictures is to an observer who switches between them at a given distance.
///
/// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
/// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3 (2020), for pictures of ordinary dynamic range: both
/// pictures are filtered by the contrast sensitivity of the eye, their colours are compared, and the difference is amplified
/// where edges or points differ.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

struct ViewingDistance {
    /// Pixels per degree of visual angle. The paper uses 67: a monitor 0.7 m wide with 3840 pixels at 0.7 m.
    double pixels_per_degree = 67;
};

/// One value per pixel, top row first: 0 where the pictures look equal, 1 at the greatest possible difference.
struct PerceptualDifference {
    std::uint32_t width = 0, height = 0;
    std::vector<double> map;
    double mean = 0;
};

/// The order of the pictures does not matter. Alpha is ignored. Throws UserError where the sizes differ.
[[nodiscard]] PerceptualDifference perceptual_difference(const RgbaView& first, const RgbaView& second,
                                                         ViewingDistance distance = {});

}  // namespace tedavis::host_sim
