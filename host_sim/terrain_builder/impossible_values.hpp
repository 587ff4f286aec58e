/// Values of a raster that are impossible for ground and that the file does not declare as void: signs of another kind of data,
/// or of an undeclared void value.
#pragma once

#include "host_sim/terrain_builder/raster_source.hpp"

namespace tedavis::host_sim {

struct ImpossibleValues {
    double share = 0;                    ///< fraction of the sampled values
    double lowest_m = 0, highest_m = 0;  ///< of the impossible values
};

/// Examines a sample of at most 64 x 64 posts, evenly over the raster. For heights coded in colours it finds none. Throws
/// UserError where the file is damaged.
[[nodiscard]] ImpossibleValues impossible_values(const RasterSource& source, const RasterOptions& options);

}  // namespace tedavis::host_sim
