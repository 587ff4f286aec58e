/// The first point of a surface on a ray, in long double and without a hierarchy: an oracle for the tracer, and slow.
///
/// How far a ray is above the surface is a function of t alone. It is continuous, and smooth between the times at which the ray
/// crosses lines of posts and (two triangles) diagonals: linear there over triangles, quadratic over a bilinear patch. The
/// reference merges these times in order and looks where the function changes its sign. No planes are intersected, no cells are
/// boxed; what it shares with the tracer is the definition of the surface. Only what lies higher than all posts, or lower, is
/// left out.
#pragma once

#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::test_support {

/// What becomes of a ray that is below the surface without having met it: it began there, or came through the border of the grid
/// or a cell without heights.
enum class FromBelow : std::uint8_t {
    ends,    ///< it meets nothing more
    passes,  ///< it may come out and meet the surface from above
    meets,   ///< where it comes out it meets the surface
};

struct ReferenceHit {
    raytrace::HitSide side = raytrace::HitSide::none;
    long double t = 0;                  ///< only where something is met
    std::uint32_t column = 0, row = 0;  ///< of the cell; one of several where the point is on a border
    /// The smallest height over or under the surface at which the ray turns, comes or goes: a ray moved up or down by less has
    /// the same answer, and a t that differs by little. Height steps; infinite where the ray never comes near.
    long double clearance = 0;
    /// The smallest quotient of such a height and the numbers from which it is made: a step, the ray's way up or down, and its
    /// way across times the steepness of the cell. A tracer that counts from the ray's origin and rounds each of a few operations
    /// by e may differ where this is a few e, and nowhere else.
    long double margin = 0;
    /// By how much t changes where the height over the surface changes by as much as those numbers. Only where something is met.
    long double t_scale = 0;
};

template <class Height>
class ReferenceTracer {
public:
    /// The grid is borrowed.
    ReferenceTracer(const raytrace::HeightGrid<Height>& grid, raytrace::CellSurface surface);

    [[nodiscard]] ReferenceHit trace(const raytrace::Ray& ray, FromBelow from_below = FromBelow::ends) const;

private:
    raytrace::HeightGrid<Height> grid_;
    raytrace::CellSurface surface_;
    long double lowest_, highest_;  ///< of all posts with a height
};

extern template class ReferenceTracer<std::int16_t>;
extern template class ReferenceTracer<float>;

}  // namespace tedavis::test_support
