/// A point of a surface over the grid: its height and slopes.
///
/// In grid space (height_grid.hpp): heights in height steps, slopes in height steps per post. On a crease the slopes are those
/// of the side in which the point was computed.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace tedavis::raytrace {

struct SurfacePoint {
    double height = 0;
    double slope_x = 0;  ///< dz/dx: towards higher columns
    double slope_y = 0;  ///< dz/dy: towards higher rows
};

/// The lengths of the three units of grid space.
struct GridScale {
    double column_m = 1, row_m = 1, height_m = 1;  ///< above 0
};

/// Returns the unit normal away from the ground, in a frame with the axes of grid space in metres; (0, 0, 1) for level ground.
/// The third component is always positive, and no division is by a length below 1.
[[nodiscard]] inline glm::dvec3 normal_of(const SurfacePoint& point, const GridScale& scale) {
    const double x = -point.slope_x * (scale.height_m / scale.column_m), y = -point.slope_y * (scale.height_m / scale.row_m);
    const double length = std::sqrt(x * x + y * y + 1);
    return {x / length, y / length, 1 / length};
}

}  // namespace tedavis::raytrace
