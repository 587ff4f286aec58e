/// Shades the hits of up to 64 rays with all operators of shading that the settings select.
///
/// Pure, apart from queries to the terrain; any thread. The light of a hit depends on its ray alone.
#pragma once

#include "render_core/raytrace/picture/span_light.hpp"
#include "render_core/raytrace/picture/traced_scene.hpp"

namespace tedavis::raytrace {

/// Rays in the scene's grid space.
struct SpanRays {
    glm::dvec3 origin{0};                 ///< of all rays, where `origins` is null
    const glm::dvec3* origins = nullptr;  ///< one per ray
    float direction[3][PixelSpan::kMax];  ///< [x, y, z][ray]

    [[nodiscard]] Ray ray(std::uint32_t n) const;
};

template <class Height>
struct SpanShader {
    const TraceSettings* settings = nullptr;
    const TracedTerrain* terrain = nullptr;
    ShadingMaps<Height> maps;
    const TraceLook* look = nullptr;
    double pixel_width_m = 0;  ///< width of a pixel at t = 1, for averages; 0: no averages

    /// Writes the light. `seeds` number the rays, for paths. Averages may change the surface's slopes.
    void shade(const SpanRays& rays, const std::uint32_t* seeds, SpanSurface& surface, glm::vec3* light) const;
    /// Number of posts that a pixel covers at `t`.
    [[nodiscard]] double footprint(float t) const;
    /// The share of light that hit n reflects as a mirror.
    [[nodiscard]] float mirror_of(const SpanSurface& surface, std::uint32_t n) const;
    /// The ray that is reflected at hit n.
    [[nodiscard]] Ray mirrored(const SpanRays& rays, const SpanSurface& surface, std::uint32_t n) const;

private:
    void average_slopes(SpanSurface& surface) const;
    void cover_with_data(const SpanSurface& surface, SpanLight& light) const;
    void cast_shadows(const SpanSurface& surface, SpanLight& light) const;
    void draw_capsules(const SpanRays& rays, const SpanSurface& surface, glm::vec3* light) const;
    void follow_paths(const SpanRays& rays, const std::uint32_t* seeds, const SpanSurface& surface, glm::vec3* light) const;
};

}  // namespace tedavis::raytrace
