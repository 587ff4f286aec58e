/// The nodes of a mipmap that a ray crosses, in order, at whatever level is asked for.
///
/// Cells are told apart by the times at which the ray crosses grid lines, each one number for both its sides. The node to the
/// next is entered where the last was left: nothing lies between.
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

    /// False before the first call of leave() where the ray misses the grid, and after it has left it.
    [[nodiscard]] bool is_inside() const { return is_inside_; }
    [[nodiscard]] std::uint32_t column() const { return cell_[0]; }
    [[nodiscard]] std::uint32_t row() const { return cell_[1]; }
    [[nodiscard]] double t() const { return t_; }
    /// When the ray leaves the node of the present cell at a level, or ends.
    [[nodiscard]] double exit_t(std::uint32_t level) const;
    [[nodiscard]] double height_at(double t) const { return origin_.z + t * direction_.z; }
    /// From here to the exit of the present cell. Coordinates are exact on the sides that it enters and leaves by.
    [[nodiscard]] CellRay in_cell() const;
    /// To the cell behind the node of the present one.
    void leave(std::uint32_t level);

private:
    [[nodiscard]] double crossing_t(int axis, std::uint32_t level) const;
    [[nodiscard]] double place_at(int axis, double t) const { return origin_[axis] + t * direction_[axis]; }

    glm::dvec3 origin_, direction_;
    double t_ = 0, end_ = 0;
    std::uint32_t cells_[2], cell_[2] = {};
    int entered_by_ = -1;  ///< axis; -1: begun within
    bool is_inside_ = false;
};

}  // namespace tedavis::raytrace
