/// Which operators draw a traced picture (thesis 6.2.2.2): plain data.
#pragma once

#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::raytrace {

enum class Antialiasing : std::uint8_t {
    none,
    average_mipmap,  ///< slopes of what a pixel covers are averaged; outlines stay as they are
    supersampling,   ///< more rays where a pixel covers more than half a post (pixel_footprint.hpp)
};

enum class Shading : std::uint8_t { none, lambert, phong };

enum class Ambient : std::uint8_t {
    none,       ///< the sky lights every place alike
    sky_view,   ///< as much of it as the place sees
    apertures,  ///< so too, and the sun only as far as the place sees it, without a ray; moves with the sun
};

struct TraceSettings {
    static constexpr std::uint32_t kMaxRaysAlong = 8;
    static constexpr std::uint32_t kMaxMirrors = 8;

    SurfaceSettings surface;
    /// The surface is sampled `surface.subdivisions` times as finely, once at start, micro-structure included, and bilinear
    /// between: the vector kernel traces it then. Of approximate_bicubic it is the same surface, but for the micro-structure.
    bool is_surface_stored = false;
    Antialiasing antialiasing = Antialiasing::none;
    std::uint32_t rays_along = 2;  ///< at most, along each side of a pixel that is supersampled; 1..kMaxRaysAlong
    Shading shading = Shading::lambert;
    Ambient ambient = Ambient::none;
    bool has_shadows = false;   ///< a ray to the sun from each place
    std::uint32_t mirrors = 0;  ///< reflections of a ray that are followed, 0..kMaxMirrors
    std::uint32_t paths = 0;    ///< 0: local light; else so many paths a pixel of up to `bounces` rays (traced_light.hpp)
    std::uint32_t bounces = 2;
    bool has_data = false;      ///< colour of data and their certainty (TraceLook)
    bool has_capsules = false;  ///< trajectories (TraceLook)
};

/// Traced by the vector kernel, on the posts or on the stored surface; else ray by ray.
[[nodiscard]] constexpr bool is_kernel_surface(const TraceSettings& settings) {
    return settings.is_surface_stored || (!is_cubic(settings.surface.kind) && settings.surface.micro.kind == MicroKind::none);
}

}  // namespace tedavis::raytrace
