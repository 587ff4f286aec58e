/// Lines of sight and viewsheds over a flat grid, by the tracer (trace_ray.hpp): which places see each other, exactly over the
/// field's surface. For labels, hidden focus and threats.
///
/// Points are places of grid space. The ends of a line of sight do not hide each other: neither does the ground that they stand
/// on, as the line begins and ends above it by a bound of the tracer's rounding. A place where there is no surface sees and is
/// seen at the height that it is given, above 0.
///
/// Pure; any thread. Lines may look through the underside of the surface only with a field that has minima.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/base/span.hpp"
#include "render_core/raytrace/height_grid.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

template <class Height>
[[nodiscard]] bool is_visible(const TracedField<Height>& field, const glm::dvec3& from, const glm::dvec3& to);

/// One result for each of `to`; 1 where it is seen.
template <class Height>
void find_visible(const TracedField<Height>& field, const glm::dvec3& from, base::Span<const glm::dvec3> to,
                  base::Span<std::uint8_t> seen);

/// Every post of a window as seen from one place.
struct Viewshed {
    glm::dvec3 observer{0};
    double target_height = 0;  ///< above the post, height steps, 0 or more
    PostRegion window;
};

/// 1 where the target over a post of the window is seen, else 0; posts without a height are not seen. Row by row over the
/// window; rows are shared out to the workers.
template <class Height>
void find_viewshed(const TracedField<Height>& field, const Viewshed& viewshed, base::Workers& workers,
                   base::Span<std::uint8_t> seen);

}  // namespace tedavis::raytrace
