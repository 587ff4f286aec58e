/// How the sun of a frame sees the things that cast shadows: the light's own axes, and three nested squares across them that a
/// map of shadows has a level for each (shadow_map.hpp). Pure; any thread.
///
/// Places in the light's frame are metres from an anchor: right, up, and towards the sun. The anchor is the nearest knot of a net
/// of 1/20 degree, the sun's direction that at the anchor, and a level's middle a whole number of its texels from there: while
/// the eye moves, texels stay where they are in the world, so that no edge crawls. Between two knots (5 km) the sun turns by a
/// thousandth.
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
/// Each level is so many times wider than the one before.
inline constexpr double kLevelRatio = 4;
/// Of the sun's disc.
inline constexpr double kSunRadius_rad = 0.00465;
/// Places farther from the anchor, towards the sun or away from it, are in no map.
inline constexpr double kShadowReach_m = 400'000;

/// A ball with what casts a shadow in it.
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
    /// Casters lie between these places of the light's frame; while there are none, the first is beyond the second.
    glm::dvec3 low_m{kShadowReach_m}, high_m{-kShadowReach_m};
    double top_m = -kShadowReach_m;  ///< no caster is higher over the ellipsoid
    double on_ground = 0;            ///< what a whole shadow takes of the light; 0: none is drawn

    [[nodiscard]] glm::dvec3 in_light(const glm::dvec3& place) const { return (place - anchor) * axes; }
};

struct ShadowView {
    const terrain::View& view;
    double eye_height_m = 0;                    ///< over the ground below it, 0 at least
    double azimuth_rad = 0, elevation_rad = 0;  ///< of the light, where the eye is
    std::uint32_t level_px = 1024;
};

/// Without casters yet.
[[nodiscard]] ShadowFrame make_shadow_frame(const ShadowView& from);
/// One more of them.
void add_caster(ShadowFrame& frame, const CasterBall& ball);

/// Whether anything that the ball may shade, down to `lowest_m` over the ellipsoid, may be in the picture.
[[nodiscard]] bool shades_the_view(const ShadowFrame& frame, const terrain::View& view, const CasterBall& ball, double lowest_m);

/// Edge of a texel of a level.
[[nodiscard]] inline double texel_m(const ShadowLevel& level, std::uint32_t level_px) { return 2 * level.half_m / level_px; }

}  // namespace tedavis::draw
