/// Where the heights of a terrain database go: posts of its lattice as a height grid.
///
/// Column c and row r of the grid are post (window.i0 + c, window.j0 + r) of the lattice (terrain/lattice.hpp). It is a window of
/// posts as they are stored: round the Earth it does not go on behind the last column, which is the meridian of column 0 again. A
/// row at a pole is a row as others are, all its posts being one point. The cells beside it are triangles with their apex there;
/// the grid divides them in two, which is the same surface along their sides, but not between.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/height_grid.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::raytrace {

/// Borrowed memory. `Height` is std::int16_t or float.
template <class Height>
struct GroundWindow {
    terrain::PostRange window;  ///< first and last, both included; within the lattice
    base::Span<Height> posts;   ///< row by row, without gaps: columns() * rows()
    /// Metres above MSL of one height step. Heights of floats are best in metres: any other step rounds them.
    double step_m = 1;

    [[nodiscard]] std::uint32_t columns() const { return window.i1 - window.i0 + 1; }
    [[nodiscard]] std::uint32_t rows() const { return window.j1 - window.j0 + 1; }
    [[nodiscard]] HeightGrid<Height> grid() const { return {posts.data(), columns(), rows(), columns()}; }
};

/// What has become of metres in a grid of height steps.
struct GroundRounding {
    float largest_m = 0;      ///< by how much a height differs from what is stored
    bool has_beyond = false;  ///< heights that a step cannot say are void
    [[nodiscard]] bool are_whole() const { return largest_m == 0 && !has_beyond; }
};

}  // namespace tedavis::raytrace
