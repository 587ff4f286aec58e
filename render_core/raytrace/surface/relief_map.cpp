#include "render_core/raytrace/surface/relief_map.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {
namespace {

/// -1..1
double relief_post(const ReliefMap& map, std::uint32_t column, std::uint32_t row) {
    const std::int16_t height = map.tile.at(column, row);
    return height == HeightGrid<std::int16_t>::kVoid ? 0 : std::clamp(height / map.full_scale, -1.0, 1.0);
}

/// 0..period - 1
std::uint32_t repeated(double whole, std::uint32_t period) {
    const auto rest = static_cast<std::int64_t>(whole) % static_cast<std::int64_t>(period);
    return static_cast<std::uint32_t>(rest < 0 ? rest + period : rest);
}

}  // namespace

SurfacePoint relief_at(const ReliefMap& map, double x, double y) {
    const double across = (static_cast<double>(map.first_column) + x) * map.density;
    const double down = (static_cast<double>(map.first_row) + y) * map.density;
    const double left = std::floor(across), top = std::floor(down);
    const double u = across - left, v = down - top;
    const std::uint32_t i = repeated(left, map.tile.columns), j = repeated(top, map.tile.rows);
    const std::uint32_t next_i = (i + 1) % map.tile.columns, next_j = (j + 1) % map.tile.rows;
    const double a = relief_post(map, i, j), b = relief_post(map, next_i, j);
    const double c = relief_post(map, i, next_j), d = relief_post(map, next_i, next_j);
    const double upper = (1 - u) * a + u * b, lower = (1 - u) * c + u * d;
    SurfacePoint point;
    point.height = map.amplitude * std::clamp((1 - v) * upper + v * lower, -1.0, 1.0);
    point.slope_x = map.amplitude * map.density * ((1 - v) * (b - a) + v * (d - c));
    point.slope_y = map.amplitude * map.density * (lower - upper);
    return point;
}

double steepest_slope(const ReliefMap& map) { return 2 * map.amplitude * map.density; }

}  // namespace tedavis::raytrace
