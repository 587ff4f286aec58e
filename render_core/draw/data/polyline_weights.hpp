/// How much each point of a way matters for its shape and its values: which may be left out at a given tolerance.
///
/// D. H. Douglas and T. K. Peucker, Algorithms for the reduction of the number of points required to represent a digitized line
/// or its caricature, Cartographica 10(2), 1973, without recursion: the distance at which a stretch is split is the weight of the
/// point that splits it, and never more than that of the stretch. Who keeps the points that weigh more than a tolerance keeps
/// what the method would keep, and no point left out is farther from the way between those kept than the tolerance.
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
    std::array<double, 3> values{{}};  ///< in metres that count like those of the place; NaN: none, which weighs nothing
};

/// A stretch that waits: between two points that are kept.
struct PolylineStretch {
    std::uint32_t first, last;
    float weight_m;
};

/// Weights in metres; both ends weigh infinitely much. `weights` and `waiting` have room for as many as there are points.
void weigh_vertices(base::Span<const PolylineVertex> points, base::Span<float> weights,
                    base::Span<PolylineStretch> waiting) noexcept;

/// Distance of a point from the way between two others, or of its values from those on the line between theirs if that is more.
[[nodiscard]] double distance_from_way(const PolylineVertex& point, const PolylineVertex& from,
                                       const PolylineVertex& to) noexcept;

}  // namespace tedavis::draw
