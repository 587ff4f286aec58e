/// Feature Congestion pixel by pixel in double, by direct sums over two-dimensional windows: an oracle that shares no code with
/// host_sim/evaluation, and is some hundred times slower.
#pragma once

#include "tests/support/perception/itti_reference.hpp"

namespace tedavis::test_support {

struct CongestionControls {
    /// What a wrong measure would do.
    bool without_colors = false, without_directions = false, one_size = false;
};

/// Of each pixel.
[[nodiscard]] Field congestion_reference(const perception::PictureView& picture, const CongestionControls& controls = {});

}  // namespace tedavis::test_support
