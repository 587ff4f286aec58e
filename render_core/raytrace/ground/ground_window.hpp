/// The destination of heights of a terrain database: a window of its lattice as a height grid.
///
/// Column c and row r of the grid are post (window.i0 + c, window.j0 + r) of the lattice (terrain/lattice.hpp). The window
/// contains posts as stored: on a lattice round the Earth it does not continue beyond the last column, which repeats the
/// meridian of column 0. A row at a pole is an ordinary row whose posts are all the same point. The true cells beside it are
/// triangles with their apex at the pole; the grid divides them in two, which gives the same surface along their sides, but not
/// inside.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/height_grid.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::raytrace {

/// Borrowed memory. `Height` is std::int16_t or float.
template <class Height>
struct GroundWindow {
    terrain::PostRange window;  ///< first and last post, both included; within the lattice
    base::Span<Height> posts;   ///< row by row, without gaps: columns() * rows()
    /// Metres above MSL per height step. Use 1 for float heights: any other step rounds them.
    double step_m = 1;

    [[nodiscard]] std::uint32_t columns() const { return window.i1 - window.i0 + 1; }
    [[nodiscard]] std::uint32_t rows() const { return window.j1 - window.j0 + 1; }
    [[nodiscard]] HeightGrid<Height> grid() const { return {posts.data(), columns(), rows(), columns()}; }
};

/// Rounding of metres to height steps in a grid.
struct GroundRounding {
    float largest_m = 0;      ///< largest difference of a height from the stored one
    bool has_beyond = false;  ///< some heights exceed the range of Height and became void
    [[nodiscard]] bool are_whole() const { return largest_m == 0 && !has_beyond; }
};

}  // namespace tedavis::raytrace
