/// A point of a surface over the grid: its height, and how steep it is there.
///
/// Grid space (height_grid.hpp): heights in height steps, slopes in height steps a post. Slopes of a surface with creases are
/// those of the side that the place was looked up in.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace tedavis::raytrace {

struct SurfacePoint {
    double height = 0;
    double slope_x = 0;  ///< dz/dx: towards higher columns
    double slope_y = 0;  ///< dz/dy: towards higher rows
};

/// How long the three units of grid space are.
struct GridScale {
    double column_m = 1, row_m = 1, height_m = 1;  ///< above 0
};

/// The unit vector away from the ground, in a frame with the axes of grid space and metres along them. Flat is (0, 0, 1). The
/// third component is never zero or less, and nothing is divided by a length below 1.
[[nodiscard]] inline glm::dvec3 normal_of(const SurfacePoint& point, const GridScale& scale) {
    const double x = -point.slope_x * (scale.height_m / scale.column_m), y = -point.slope_y * (scale.height_m / scale.row_m);
    const double length = std::sqrt(x * x + y * y + 1);
    return {x / length, y / length, 1 / length};
}

}  // namespace tedavis::raytrace
