/// Depth of field as planned for a frame (view_effects_pass.hpp). Plain data.
#pragma once

#include <cstdint>

namespace tedavis::draw {

/// The range of distances from the eye point that is sharp.
struct FocusRange {
    bool is_known = false;
    double near_m = 0, far_m = 0;
    double blur_px = 0;       ///< radius of the blur at infinite distance
    std::uint32_t taps = 16;  ///< number of samples per square of pixels
};

}  // namespace tedavis::draw
