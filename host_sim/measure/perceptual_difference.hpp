/// How visible the difference of two pictures is to somebody who switches between them at a given distance.
///
/// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images",
/// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3 (2020), for pictures of ordinary dynamic range:
/// both pictures are blurred as the eye blurs them, their colours are compared, and where they differ in edges or points the
/// difference counts more.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

struct ViewingDistance {
    /// Pixels that one degree of the eye's view covers. The paper takes 67: a monitor 0.7 m wide with 3840 pixels, 0.7 m away.
    double pixels_per_degree = 67;
};

/// A value a pixel, top row first: 0 where the pictures look alike, 1 where they could not differ more.
struct PerceptualDifference {
    std::uint32_t width = 0, height = 0;
    std::vector<double> map;
    double mean = 0;
};

/// The order of the pictures does not matter. Alpha is not looked at. Throws UserError where the sizes differ.
[[nodiscard]] PerceptualDifference perceptual_difference(const RgbaView& first, const RgbaView& second,
                                                         ViewingDistance distance = {});

}  // namespace tedavis::host_sim
