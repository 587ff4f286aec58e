/// Values of a raster that no ground has, and that the file does not declare as void: marks of another kind of data, or of a void
/// value that nobody stated.
#pragma once

#include "host_sim/terrain_builder/raster_source.hpp"

namespace tedavis::host_sim {

struct ImpossibleValues {
    double share = 0;                    ///< of the values looked at
    double lowest_m = 0, highest_m = 0;  ///< of those
};

/// By a sample of at most 64 x 64 posts, evenly over the raster. Nothing is found in heights that colours hold. Throws UserError
/// where the file is damaged.
[[nodiscard]] ImpossibleValues impossible_values(const RasterSource& source, const RasterOptions& options);

}  // namespace tedavis::host_sim
