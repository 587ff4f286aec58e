/// Exhaustive signed error of flat triangles against the true surface, on which the error bounds of a database are based.
///
/// Two piecewise linear surfaces differ most at a vertex of their overlay: at posts inside the triangle, and where its sides
/// cross rows, columns and diagonals of cells. All of them are visited. A cell with a void corner is not part of the true
/// surface: a place counts if one of the cells that touch it is. Heights above the ellipsoid. Pure functions; any thread.
#pragma once

#include <cstdint>

#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

/// A rectangle of neighbouring posts of the lattice, row by row.
struct PostWindowView {
    std::int64_t i0 = 0, j0 = 0;  ///< lattice coordinates of its first post
    std::uint32_t columns = 0, rows = 0;
    const float* surface_m = nullptr;
    const terrain::PostClass* post_class = nullptr;
};

struct MeshCorner {
    std::int64_t i = 0, j = 0;
    double surface_m = 0;
};

struct SignedError {
    double above_m = 0, below_m = 0;  ///< largest drawn minus true, largest true minus drawn; both >= 0

    [[nodiscard]] double largest_m() const { return above_m > below_m ? above_m : below_m; }
    void include(const SignedError& other) {
        above_m = above_m > other.above_m ? above_m : other.above_m;
        below_m = below_m > other.below_m ? below_m : other.below_m;
    }
};

/// The error and a place where the larger of its two parts occurs, in lattice coordinates; without an error the first corner.
struct PlacedError {
    SignedError error;
    double i = 0, j = 0;

    void include(const PlacedError& other) {
        if (other.error.largest_m() > error.largest_m()) {
            i = other.i;
            j = other.j;
        }
        error.include(other.error);
    }
};

/// Returns the error over the part of the triangle inside the window's cells; several windows that share their outermost posts
/// can cover a triangle. Corners in any order, at most 32768 posts apart. Zero-area triangles have no error.
[[nodiscard]] PlacedError placed_triangle_error(const PostWindowView& posts, const MeshCorner& a, const MeshCorner& b,
                                                const MeshCorner& c);
[[nodiscard]] SignedError triangle_error(const PostWindowView& posts, const MeshCorner& a, const MeshCorner& b,
                                         const MeshCorner& c);

}  // namespace tedavis::host_sim
