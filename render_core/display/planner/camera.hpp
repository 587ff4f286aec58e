/// The camera of a picture: the own ship's eye point, the map's eye point far above it, and the transition between the two.
///
/// Map           a perspective straight down along the ellipsoid's normal, from so far above that it is as good as a parallel
///               projection: over 1 to 200 km places on the ground lie within a pixel of their true distance and azimuth (tested
///               against geodesics). It uses the meshes, levels of detail, depths, styles and drawers of the 3D picture.
/// Transition    straight up from the own ship, so that no terrain can be between. The camera turns down to the ground while the
///               own ship moves to the middle of the picture, and rises as the field of view narrows: height above the ground and
///               ground scale are geometric in the share of the transition, so both change monotonically.
/// Orthographic  a perspective as well, obliquely from far away onto the own ship, so that the same code draws it and proves its
///               errors. Its scale is that of the own ship's distance; a length anywhere in the picture, on the ground or up to 9
///               km high, is drawn within a hundredth of what a parallel projection makes of it, for ranges up to
///               design::kMaxOrthographicRange_m, at least 25 degrees down, on screens up to 1.67 times as high as wide.
/// Pure functions; any thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <type_traits>

#include "render_core/design/design_settings.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::display {

struct CameraInput {
    earth::Geodetic own_ship;
    double msl_m = 0;           ///< own ship's height above MSL
    double above_ground_m = 0;  ///< own ship's height above the terrain; above MSL where that is not known
    double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
    glm::dvec3 eye_m{0, 0, 0};  ///< eye point from the own ship: forward, right, down; the design's offset is added
    double map_up_rad = 0;      ///< true direction at the top of the map
    double map_share = 0;       ///< share of the transition from 3D (0) to the map or the orthographic view (1)
    std::uint32_t width_px = 1, height_px = 1;
};

struct Camera {
    terrain::View view;
    double haze_per_m = 0;     ///< 1 / distance at which haze hides 1 - 1/e; 0 for none, as on the map
    double height_weight = 0;  ///< weight of height errors where they displace nothing in the picture; 1 on the map
};
static_assert(std::is_trivially_copyable_v<Camera>);

/// `haze_distance_m`: of the 3D picture, 0 for none.
[[nodiscard]] Camera make_camera(const CameraInput& input, const design::ViewSettings& design, double haze_distance_m) noexcept;

/// Returns the pixels per metre on the map's ground, and across the orthographic view.
[[nodiscard]] double map_scale_px_per_m(const design::ViewSettings& design, std::uint32_t width_px,
                                        std::uint32_t height_px) noexcept;

}  // namespace tedavis::display
