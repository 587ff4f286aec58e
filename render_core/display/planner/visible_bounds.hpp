/// Upper bounds of what effects of the view change in a picture, by how near and how far what it shows is. Pure; any thread.
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

/// Part of full scale by which haze may change a colour as far away as `farthest_m`.
[[nodiscard]] double haze_bound(double haze_per_m, double farthest_m) noexcept;
/// The same of air: as dense all the way as at sea level.
[[nodiscard]] double air_bound(const design::AirSettings& air, double farthest_m) noexcept;
/// By distance, or as far as what is shown of the role reaches.
[[nodiscard]] draw::FocusRange focus_of(const design::DepthOfField& field, const ElementPlanner& elements, const glm::dvec3& eye);
/// The widest blur, in pixels, of what is seen.
[[nodiscard]] double blur_bound(const draw::FocusRange& focus, const SeenSpan& seen) noexcept;

}  // namespace tedavis::display
