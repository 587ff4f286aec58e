/// Weights of the points of a polyline for its shape and values: points with a weight below a tolerance may be left out.
///
/// D. H. Douglas and T. K. Peucker, Algorithms for the reduction of the number of points required to represent a digitized line
/// or its caricature, Cartographica 10(2), 1973, without recursion: the distance at which a section is split is the weight of
/// the splitting point, limited to the weight of the section. Keeping the points whose weight exceeds a tolerance gives the
/// method's result, and no omitted point is farther from the simplified polyline than the tolerance.
///
/// Memory  the caller's. Bounded: the square of the points at most, points times their logarithm usually. Pure; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"

namespace tedavis::draw {

struct PolylineVertex {
    glm::dvec3 place{0};               ///< m
    std::array<double, 3> values{{}};  ///< scaled to metres that count like those of the position; NaN: ignored
};

/// A pending section between two kept points.
struct PolylineStretch {
    std::uint32_t first, last;
    float weight_m;
};

/// Computes the weights in metres; both ends have infinite weight. `weights` and `waiting` have room for as many items as there
/// are points.
void weigh_vertices(base::Span<const PolylineVertex> points, base::Span<float> weights,
                    base::Span<PolylineStretch> waiting) noexcept;

/// Distance of a point from the segment between two others, or of its values from the interpolated ones, whichever is larger.
[[nodiscard]] double distance_from_segment(const PolylineVertex& point, const PolylineVertex& from,
                                           const PolylineVertex& to) noexcept;

}  // namespace tedavis::draw
