/// Computes the light of up to 64 points at once, in floats: the same as local_light() and aperture_light() (with the smooth
/// overlap) for single points in double. The error is below 2e-5 for a light of 1, with apertures 1e-3 (tests).
///
/// The loops over arrays have no branches, so that compilers vectorise them. Pure; any thread; of the C library only sqrt is
/// used. Results for rays without a hit are meaningless.
#pragma once

#include "render_core/raytrace/picture/trace_look.hpp"
#include "render_core/raytrace/picture/trace_settings.hpp"
#include "render_core/raytrace/picture/traced_terrain.hpp"
#include "render_core/raytrace/shading/sky_map.hpp"

namespace tedavis::raytrace {

/// Unit vectors in metres; [x, y, z][place].
struct SpanVectors {
    float of[3][PixelSpan::kMax];
};

struct SpanLight {
    SpanVectors normal, eye;          ///< `eye` is needed for Phong's light only
    float sun_seen[PixelSpan::kMax];  ///< 0..1
    float sky_seen[PixelSpan::kMax];  ///< 0..1
    float color[3][PixelSpan::kMax];  ///< of the ground
    float light[3][PixelSpan::kMax];  ///< the result
};

void find_normals(const SpanSurface& surface, const GridScale& scale, SpanVectors& normals);
/// Computes the directions to the eye point, for rays with directions in grid space.
void find_eyes(const float* direction_x, const float* direction_y, const float* direction_z, std::uint32_t count,
               const GridScale& scale, SpanVectors& eyes);
void find_colors(const SpanSurface& surface, const TraceLook& look, float (&color)[3][PixelSpan::kMax]);
/// Computes the visible share of the sky; with apertures also that of the sun, by which `sun_seen` is multiplied.
template <class Height>
void find_sky(const SpanSurface& surface, const SkyMap<Height>& sky, Ambient ambient, const glm::dvec3& towards_sun,
              SpanLight& light);
/// Computes `light` from normals, colours and the visible shares.
void add_up_light(Shading shading, const TraceLook& look, std::uint32_t count, SpanLight& light);

}  // namespace tedavis::raytrace
