#include "render_core/raytrace/search/node_walk.hpp"

#include <cmath>

namespace tedavis::raytrace {
namespace {

constexpr double kMinDirection = 1e-30;
constexpr double kLongest = 1e30;  // of a ray without an end: as good as none, but a number

bool is_parallel(float d) { return std::abs(double{d}) < kMinDirection; }

/// A ray along a grid line goes on one side of it: the one before the last line, else the one behind.
double direction_along(float d, double origin, std::uint32_t cells) {
    if (!is_parallel(d)) return d;
    return origin >= cells ? -kMinDirection : kMinDirection;
}

/// The cell of a place on an axis that a ray goes on from: on a grid line the one ahead.
std::uint32_t cell_ahead(double place, bool is_back, std::uint32_t cells) {
    const double cell = is_back ? std::ceil(place) - 1 : std::floor(place);
    return static_cast<std::uint32_t>(std::clamp(cell, 0.0, cells - 1.0));
}

}  // namespace

NodeWalk::NodeWalk(const Ray& ray, std::uint32_t columns, std::uint32_t rows)
    : origin_(ray.origin),
      direction_(direction_along(ray.direction.x, ray.origin.x, columns), direction_along(ray.direction.y, ray.origin.y, rows),
                 double{ray.direction.z}),
      t_(ray.from),
      end_(std::min(double{ray.to}, kLongest)),
      cells_{columns, rows} {
    for (int axis = 0; axis < 2; ++axis) {
        if (is_parallel(ray.direction[axis])) {
            if (origin_[axis] < 0 || origin_[axis] > cells_[axis]) return;
            continue;
        }
        const double to_first = (0 - origin_[axis]) / direction_[axis],
                     to_last = (cells_[axis] - origin_[axis]) / direction_[axis];
        const double enters = std::min(to_first, to_last), leaves = std::max(to_first, to_last);
        if (enters > t_) {
            t_ = enters;
            entered_by_ = axis;
        }
        end_ = std::min(end_, leaves);
    }
    is_inside_ = t_ <= end_;
    if (!is_inside_) return;
    for (int axis = 0; axis < 2; ++axis) {
        const bool is_back = direction_[axis] < 0;
        const std::uint32_t at_border = is_back ? cells_[axis] - 1 : 0;
        cell_[axis] = axis == entered_by_ ? at_border : cell_ahead(place_at(axis, t_), is_back, cells_[axis]);
    }
}

double NodeWalk::crossing_t(int axis, std::uint32_t level) const {
    if (std::abs(direction_[axis]) <= kMinDirection) return std::numeric_limits<double>::infinity();
    const std::uint32_t node = (axis == 0 ? cell_[0] : cell_[1]) >> level;
    const std::uint32_t end = axis == 0 ? cells_[0] : cells_[1];
    const std::uint32_t line = direction_[axis] < 0 ? node << level : std::min((node + 1) << level, end);
    const double t = (line - origin_[axis]) / direction_[axis];
    return t > t_ ? t : t_;
}

double NodeWalk::exit_t(std::uint32_t level) const { return std::min({crossing_t(0, level), crossing_t(1, level), end_}); }

CellRay NodeWalk::in_cell() const {
    const double across = crossing_t(0, 0), down = crossing_t(1, 0), exit = exit_t(0);
    const int left_by = exit == end_ && exit < std::min(across, down) ? -1 : (across <= down ? 0 : 1);
    const auto point_at = [&](double t, int side_axis, bool is_exit) {
        RayPoint point;
        point.t = t;
        point.z = height_at(t);
        double within[2];
        for (int axis = 0; axis < 2; ++axis) {
            const bool is_far_side = (direction_[axis] > 0) == is_exit;
            within[axis] = axis == side_axis ? (is_far_side ? 1 : 0) : std::clamp(place_at(axis, t) - cell_[axis], 0.0, 1.0);
        }
        point.place = {cell_[0], cell_[1], within[0], within[1]};
        return point;
    };
    return {point_at(t_, entered_by_, false), point_at(exit, left_by, true)};
}

void NodeWalk::leave(std::uint32_t level) {
    const double across = crossing_t(0, level), down = crossing_t(1, level);
    const int axis = across <= down ? 0 : 1, other = 1 - axis;
    const double t = std::min(across, down);
    if (t >= end_) {
        is_inside_ = false;
        return;
    }
    // Along the other axis the ray stays within the node, whatever rounding says.
    const std::uint32_t first = cell_[other] >> level << level;
    const std::uint32_t last = std::min(first + (1u << level), cells_[other]) - 1;
    t_ = t;
    entered_by_ = axis;
    cell_[other] = std::clamp(cell_ahead(place_at(other, t), direction_[other] < 0, cells_[other]), first, last);
    const std::uint32_t node = cell_[axis] >> level;
    if (direction_[axis] < 0) {
        is_inside_ = node > 0;
        cell_[axis] = (node << level) - 1;
    } else {
        cell_[axis] = (node + 1) << level;
        is_inside_ = cell_[axis] < cells_[axis];
    }
}

}  // namespace tedavis::raytrace
