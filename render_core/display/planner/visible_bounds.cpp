#include "render_core/display/planner/visible_bounds.hpp"

#include <cmath>

#include "render_core/earth/atmosphere.hpp"

namespace tedavis::display {

double haze_bound(double haze_per_m, double farthest_m) noexcept { return -std::expm1(-haze_per_m * farthest_m); }

double air_bound(const design::AirSettings& air, double farthest_m) noexcept {
    const earth::Air at_sea = earth::air_of_visibility(air.visibility_m);
    const double per_m = at_sea.molecules_per_m.z + at_sea.aerosol_per_m / earth::kAerosolAlbedo;
    // Light that comes in counts by its root.
    return std::sqrt(-std::expm1(-per_m * farthest_m));
}

draw::FocusRange focus_of(const design::DepthOfField& field, const ElementPlanner& elements, const glm::dvec3& eye) {
    if (field.blur_px <= 0) return {};
    draw::FocusRange focus{true, field.focus_near_m, field.focus_far_m, field.blur_px, field.taps};
    if (field.focus_role == scene::LayerRole::count) return focus;
    terrain::DepthSpan reach;
    focus.is_known = elements.distances_m(field.focus_role, eye, reach);
    focus.near_m = reach.near_m;
    focus.far_m = reach.far_m;
    return focus;
}

double blur_bound(const draw::FocusRange& focus, const SeenSpan& seen) noexcept {
    const double far = seen.farthest_m > focus.far_m ? 1 - focus.far_m / seen.farthest_m : 0;
    const double near = seen.nearest_m < focus.near_m ? std::fmin(focus.near_m / std::fmax(seen.nearest_m, 1e-3) - 1, 1) : 0;
    return focus.blur_px * std::fmax(far, near);
}

}  // namespace tedavis::display
