/// Light of up to 64 places at once, in floats: what local_light() and aperture_light() (with the smooth overlap) give one by one
/// in double. Off by less than 2e-5 of a light of 1, with apertures 1e-3 (tests).
///
/// Plain loops without branches over arrays, which compilers turn into vectors. Pure; any thread; no function of the C library
/// but sqrt. Places that were not met get numbers too, which mean nothing.
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
    SpanVectors normal, eye;           ///< the eye only for Phong's light
    float sun_seen[PixelSpan::kMax];   ///< 0..1
    float sky_seen[PixelSpan::kMax];   ///< 0..1
    float colour[3][PixelSpan::kMax];  ///< of the ground
    float light[3][PixelSpan::kMax];   ///< what comes of it
};

void find_normals(const SpanSurface& surface, const GridScale& scale, SpanVectors& normals);
/// Towards the eye, along rays whose directions are those of grid space.
void find_eyes(const float* direction_x, const float* direction_y, const float* direction_z, std::uint32_t count,
               const GridScale& scale, SpanVectors& eyes);
void find_colors(const SpanSurface& surface, const TraceLook& look, float (&colour)[3][PixelSpan::kMax]);
/// How much of the sky is seen; of apertures also how much of the sun, by which `sun_seen` is multiplied.
template <class Height>
void find_sky(const SpanSurface& surface, const SkyMap<Height>& sky, Ambient ambient, const glm::dvec3& towards_sun,
              SpanLight& light);
/// From normals, colours and what is seen to `light`.
void add_up_light(Shading shading, const TraceLook& look, std::uint32_t count, SpanLight& light);

}  // namespace tedavis::raytrace
