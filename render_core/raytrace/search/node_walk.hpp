/// Visits the nodes of a mipmap that a ray crosses, in order, at any level.
///
/// Cells are separated by the times at which the ray crosses grid lines; a time is the same number for both sides of a line. A
/// node is entered where the previous one was left, without a gap.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/search/cell_ray.hpp"

namespace tedavis::raytrace {

class NodeWalk {
public:
    /// Over a grid of columns x rows cells.
    NodeWalk(const Ray& ray, std::uint32_t columns, std::uint32_t rows);

    /// False where the ray misses the grid, and after it has left the grid.
    [[nodiscard]] bool is_inside() const { return is_inside_; }
    [[nodiscard]] std::uint32_t column() const { return cell_[0]; }
    [[nodiscard]] std::uint32_t row() const { return cell_[1]; }
    [[nodiscard]] double t() const { return t_; }
    /// Time at which the ray leaves the node of the current cell at a level, or ends.
    [[nodiscard]] double exit_t(std::uint32_t level) const;
    [[nodiscard]] double height_at(double t) const { return origin_.z + t * direction_.z; }
    /// Returns the segment from here to the exit of the current cell. Coordinates on the entry and exit sides are exact.
    [[nodiscard]] CellRay in_cell() const;
    /// Advances to the cell behind the node of the current one.
    void leave(std::uint32_t level);

private:
    [[nodiscard]] double crossing_t(int axis, std::uint32_t level) const;
    [[nodiscard]] double place_at(int axis, double t) const { return origin_[axis] + t * direction_[axis]; }

    glm::dvec3 origin_, direction_;
    double t_ = 0, end_ = 0;
    std::uint32_t cells_[2], cell_[2] = {};
    int entered_by_ = -1;  ///< axis; -1: the ray began inside
    bool is_inside_ = false;
};

}  // namespace tedavis::raytrace
