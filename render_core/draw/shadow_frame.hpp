/// The light frame of a frame's shadows: axes along the light, and three nested squares perpendicular to it, one for each level
/// of the shadow map (shadow_map.hpp). Pure; any thread.
///
/// Positions in the light frame are metres from an anchor: right, up, and towards the sun. The anchor is the nearest node of a
/// 1/20 degree grid, the sun's direction is that at the anchor, and a level's middle is a whole number of its texels from
/// there: texels stay fixed in the world while the eye point moves, so that shadow edges do not crawl. Between two nodes (5 km)
/// the direction changes by 0.001 rad.
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kShadowLevels = 3;
/// Ratio of the widths of consecutive levels.
inline constexpr double kLevelRatio = 4;
/// Angular radius of the sun.
inline constexpr double kSunRadius_rad = 0.00465;
/// Positions farther from the anchor, towards the sun or away from it, are not in the map.
inline constexpr double kShadowReach_m = 400'000;

/// A bounding sphere of a shadow caster.
struct CasterBall {
    glm::dvec3 middle{0};  ///< ECEF
    double radius_m = 0;
    double top_m = 0;  ///< over the ellipsoid; no part is higher
};

struct ShadowLevel {
    glm::dvec2 middle_m{0};  ///< right and up from the anchor
    double half_m = 0;
    bool is_used = false;  ///< something casts there
};

struct ShadowFrame {
    glm::dvec3 anchor{0};               ///< ECEF
    glm::dmat3 axes{1.0};               ///< columns, ECEF unit vectors: right, up, towards the sun
    ShadowLevel levels[kShadowLevels];  ///< the finest first
    double sine = 1;                    ///< of the light's elevation
    /// Bounds of the casters in the light frame; without casters `low_m` is above `high_m`.
    glm::dvec3 low_m{kShadowReach_m}, high_m{-kShadowReach_m};
    double top_m = -kShadowReach_m;  ///< no caster is higher over the ellipsoid
    double on_ground = 0;            ///< share of the light that a full shadow removes; 0: no shadows are drawn

    [[nodiscard]] glm::dvec3 in_light(const glm::dvec3& place) const { return (place - anchor) * axes; }
};

struct ShadowView {
    const terrain::View& view;
    double eye_height_m = 0;                    ///< over the ground below it, 0 at least
    double azimuth_rad = 0, elevation_rad = 0;  ///< of the light, where the eye is
    std::uint32_t level_px = 1024;
};

/// Makes the light frame, without casters.
[[nodiscard]] ShadowFrame make_shadow_frame(const ShadowView& from);
/// Adds a caster.
void add_caster(ShadowFrame& frame, const CasterBall& ball);

/// True where anything that the sphere may shade, down to `lowest_m` above the ellipsoid, may be in the picture.
[[nodiscard]] bool shades_the_view(const ShadowFrame& frame, const terrain::View& view, const CasterBall& ball, double lowest_m);

/// Returns the edge length of a level's texel.
[[nodiscard]] inline double texel_m(const ShadowLevel& level, std::uint32_t level_px) { return 2 * level.half_m / level_px; }

}  // namespace tedavis::draw
