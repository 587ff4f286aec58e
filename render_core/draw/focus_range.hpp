/// Depth of field, as planned of a frame (view_effects_pass.hpp). Plain data.
#pragma once

namespace tedavis::draw {

/// The range of distances from the eye point that is sharp.
struct FocusRange {
    bool is_known = false;
    double near_m = 0, far_m = 0;
    double blur_px = 0;  ///< radius infinitely far
};

}  // namespace tedavis::draw
