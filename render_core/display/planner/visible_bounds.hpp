/// Upper bounds of what effects of the view change in a picture, from the distances of what it shows. Pure functions; any thread.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/draw/focus_range.hpp"

namespace tedavis::display {

/// What the eye sees lies between these distances from it.
struct SeenSpan {
    double nearest_m = 0;
    /// Infinite where that is not known: elements may be seen beyond the ground.
    double farthest_m = std::numeric_limits<double>::infinity();
};

/// Returns the part of full scale by which haze may change a colour as far away as `farthest_m`.
[[nodiscard]] double haze_bound(double haze_per_m, double farthest_m) noexcept;
/// Returns the same for air, which is assumed to be as dense everywhere as at sea level.
[[nodiscard]] double air_bound(const design::AirSettings& air, double farthest_m) noexcept;
/// Returns the range in focus, by distance or by what is shown of a role.
[[nodiscard]] draw::FocusRange focus_of(const design::DepthOfField& field, const ElementPlanner& elements, const glm::dvec3& eye);
/// Returns the widest blur, in pixels, of what is seen.
[[nodiscard]] double blur_bound(const draw::FocusRange& focus, const SeenSpan& seen) noexcept;

}  // namespace tedavis::display
