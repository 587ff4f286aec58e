/// Bounds the distance between a flat triangle in space and the same triangle over the lattice.
///
/// A triangle is drawn flat in ECEF; its error against the true surface is measured over the lattice, where heights are linear
/// in longitude and latitude. With X(longitude, latitude, height) the place in ECEF and w the barycentric weights of a point,
/// sum w X(corner) - X(sum w corner) = 1/2 sum w D²X(d, d), d from the point to the corners (Taylor's theorem), and sums
/// sum w d d are at most a quarter of the products of the extents (Popoviciu; Cauchy and Schwarz). The second derivatives are
///   longitude twice: -(N+h) cos φ outwards from the axis, which is -(N+h) cos² φ up and (N+h) cos φ sin φ polewards,
///   latitude twice: -(M+h) up and dM/dφ north, mixed: -(M+h) sin φ east, height with longitude: cos φ east, with latitude:
///   north.
/// Between a pole and its ring the true surface is linear along each meridian, and so is the triangle: the ring's chord and the
/// meridian's add, and nothing is mixed.
/// The vertical turns by no more than the triangle's own extent in angle, which lets sideways parts become upward ones.
#pragma once

#include <cstdint>

#include "render_core/terrain/lattice.hpp"

namespace tedavis::host_sim {

/// Bounds in metres, 0 or more: how much higher, lower, and horizontally displaced the flat triangle is drawn.
struct CurvatureBound {
    double up_m = 0, down_m = 0, shift_m = 0;

    void include(const CurvatureBound& o) {
        up_m = up_m > o.up_m ? up_m : o.up_m;
        down_m = down_m > o.down_m ? down_m : o.down_m;
        shift_m = shift_m > o.shift_m ? shift_m : o.shift_m;
    }
};

/// Returns the bound for triangles within `columns` cells across and the rows j0..j1 whose heights differ by at most `rise_m`. It
/// includes the curvature of the rows beside a pole, which have a spacing of their own.
[[nodiscard]] CurvatureBound curvature_bound(const terrain::Lattice& lattice, std::uint32_t columns, std::uint32_t j0,
                                             std::uint32_t j1, double rise_m);

}  // namespace tedavis::host_sim
