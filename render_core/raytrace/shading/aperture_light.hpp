/// Light through the aperture of a point (ambient aperture lighting: Oat and Sander 2007): a round sun that the terrain may
/// hide in part, and the sky. The sun may move, and no shadow ray is needed.
#pragma once

#include "render_core/raytrace/shading/cap_overlap.hpp"
#include "render_core/raytrace/shading/sky_map.hpp"

namespace tedavis::raytrace {

inline constexpr double kSunRadius_rad = 0.00465;

enum class OverlapKind : std::uint8_t { exact, smooth };

struct ApertureLight {
    double sun = 0;  ///< visible share of the sun, 0..1
    double sky = 0;  ///< light of a uniform sky on the surface, 0..1
};

/// `towards_sun` and `normal` are unit vectors in a frame in metres. A sun of size 0 is visible or not.
[[nodiscard]] ApertureLight aperture_light(const Aperture& aperture, const glm::dvec3& normal, const glm::dvec3& towards_sun,
                                           double sun_radius_rad, OverlapKind kind);

}  // namespace tedavis::raytrace
