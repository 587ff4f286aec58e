/// The operators that draw a traced picture (thesis 6.2.2.2). Plain data.
#pragma once

#include "render_core/raytrace/search/search_settings.hpp"
#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::raytrace {

enum class Antialiasing : std::uint8_t {
    none,
    average_mipmap,  ///< slopes are averaged over a pixel; outlines are not smoothed
    supersampling,   ///< more rays where a pixel covers more than half a post (pixel_footprint.hpp)
};

enum class Shading : std::uint8_t { none, lambert, phong };

enum class Ambient : std::uint8_t {
    none,       ///< the sky lights every point equally
    sky_view,   ///< sky light in proportion to the visible sky
    apertures,  ///< the same, and sunlight in proportion to the visible sun, without a shadow ray
};

struct TraceSettings {
    static constexpr std::uint32_t kMaxRaysAlong = 8;
    static constexpr std::uint32_t kMaxMirrors = 8;

    SurfaceSettings surface;
    SearchSettings search;  ///< of all rays; one that is not exact traces ray by ray, over the posts
    /// The surface is sampled once at start, `surface.subdivisions` times as finely, micro-structure included, with bilinear
    /// interpolation, so that the vector kernel can trace it. For approximate_bicubic it is the same surface, except for the
    /// micro-structure.
    bool is_surface_stored = false;
    Antialiasing antialiasing = Antialiasing::none;
    std::uint32_t rays_along = 2;  ///< largest number of rays along each side of a supersampled pixel; 1..kMaxRaysAlong
    Shading shading = Shading::lambert;
    Ambient ambient = Ambient::none;
    bool has_shadows = false;   ///< a ray to the sun from each hit
    std::uint32_t mirrors = 0;  ///< largest number of reflections of a ray, 0..kMaxMirrors
    std::uint32_t paths = 0;    ///< 0: local light; else paths per pixel, each of up to `bounces` rays (traced_light.hpp)
    std::uint32_t bounces = 2;
    bool has_data = false;      ///< colours of data and their uncertainty (TraceLook)
    bool has_capsules = false;  ///< trajectories (TraceLook)
};

/// True where the vector kernel traces the posts or the stored surface; else rays are traced one by one.
[[nodiscard]] constexpr bool is_kernel_surface(const TraceSettings& settings) {
    return settings.search.is_exact() &&
           (settings.is_surface_stored || (!is_cubic(settings.surface.kind) && settings.surface.micro.kind == MicroKind::none));
}

/// True where a picture needs only the first hits of its pixels' rays and the cells of these hits: no secondary rays, and
/// nothing that is prepared from all heights but their bounds. Such a picture can be drawn of paged ground.
[[nodiscard]] constexpr bool needs_primary_hits_only(const TraceSettings& settings) {
    return is_kernel_surface(settings) && !settings.is_surface_stored && settings.antialiasing == Antialiasing::none &&
           settings.ambient == Ambient::none && !settings.has_shadows && settings.mirrors == 0 && settings.paths == 0;
}

}  // namespace tedavis::raytrace
