/// From what up to 64 rays met to the light that comes along them: all operators of shading that settings ask for.
///
/// Pure but for the terrain that it asks; any thread. A place's light depends on its ray alone, not on the places beside it.
#pragma once

#include "render_core/raytrace/picture/span_light.hpp"
#include "render_core/raytrace/picture/traced_scene.hpp"

namespace tedavis::raytrace {

/// Rays in the scene's grid space.
struct SpanRays {
    glm::dvec3 origin{0};                 ///< of all, where `origins` is null
    const glm::dvec3* origins = nullptr;  ///< one a ray
    float direction[3][PixelSpan::kMax];  ///< [x, y, z][ray]

    [[nodiscard]] Ray ray(std::uint32_t n) const;
};

template <class Height>
struct SpanShader {
    const TraceSettings* settings = nullptr;
    const TracedTerrain* terrain = nullptr;
    ShadingMaps<Height> maps;
    const TraceLook* look = nullptr;
    double pixel_width_m = 0;  ///< of a pixel where t is 1, for averages; 0: none

    /// `seeds` number the rays, for paths. The surface's slopes may be changed: by averages.
    void shade(const SpanRays& rays, const std::uint32_t* seeds, SpanSurface& surface, glm::vec3* light) const;
    /// Posts that a pixel covers at `t`.
    [[nodiscard]] double footprint(float t) const;
    /// The share of light that the place mirrors.
    [[nodiscard]] float mirror_of(const SpanSurface& surface, std::uint32_t n) const;
    /// The ray that a mirror at place n sends on.
    [[nodiscard]] Ray mirrored(const SpanRays& rays, const SpanSurface& surface, std::uint32_t n) const;

private:
    void average_slopes(SpanSurface& surface) const;
    void cover_with_data(const SpanSurface& surface, SpanLight& light) const;
    void cast_shadows(const SpanSurface& surface, SpanLight& light) const;
    void draw_capsules(const SpanRays& rays, const SpanSurface& surface, glm::vec3* light) const;
    void follow_paths(const SpanRays& rays, const std::uint32_t* seeds, const SpanSurface& surface, glm::vec3* light) const;
};

}  // namespace tedavis::raytrace
