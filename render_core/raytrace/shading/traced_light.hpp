/// Global illumination by path tracing: mirrors, and diffuse light of several bounces (Whitted 1980; Kajiya 1986). The most
/// exact and most expensive way to shade.
///
/// A path is followed in a loop, not recursively: each hit adds its light, weighted by the path's throughput, and the path
/// continues in one direction. Mirror or diffuse bounces are chosen in proportion to the material's reflectances; diffuse
/// directions are cosine-distributed. Samples come from a low-discrepancy sequence (Sobol's first two dimensions, scrambled and
/// shuffled for each bounce and pixel: Owen 1995; Burley 2020), so pictures are reproducible on every machine.
///
/// What is inexact: light after the last bounce is left out, so that few bounces are too dark in valleys; few paths are noisy.
/// Light comes from a uniform sky and one directed light, which is tested by a shadow ray at every bounce.
///
/// Pure, apart from the two functions of the scene; any thread; at most `bounces` rays and as many shadow rays per path.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/raytrace/shading/local_light.hpp"

namespace tedavis::raytrace {

/// The hit of a ray; directions in metres.
struct LitPlace {
    bool is_hit = false;
    glm::dvec3 point{0};  ///< start of the next ray, lifted off the surface (cast_shadow.hpp)
    glm::dvec3 normal{0, 0, 1};
    Material material;
};

/// The caller's scene. Points and directions are in one frame in metres.
struct LitScene {
    LitPlace (*intersect)(const void* context, const glm::dvec3& origin, const glm::dvec3& direction) = nullptr;
    bool (*is_hidden)(const void* context, const glm::dvec3& origin, const glm::dvec3& direction) = nullptr;
    const void* context = nullptr;
    DirectedLight sun;
    glm::vec3 sky{1};  ///< radiance of the sky, for rays without a hit
};

struct TracedLight {
    static constexpr std::uint32_t kMaxBounces = 16;

    std::uint32_t bounces = 3;  ///< rays after the first, 0..kMaxBounces
    std::uint32_t paths = 16;   ///< paths per pixel, 1 or more
};

/// Returns the light along a ray, the mean of all paths. `seed` identifies the pixel.
[[nodiscard]] glm::vec3 traced_light(const LitScene& scene, const glm::dvec3& origin, const glm::dvec3& direction,
                                     const TracedLight& settings, std::uint32_t seed);

/// Returns a cosine-distributed unit vector about a normal, from two numbers in 0..1.
[[nodiscard]] glm::dvec3 cosine_direction(const glm::dvec3& normal, double u, double v);

/// Returns point n of the sequence for a seed and a position in the path, in [0, 1) each. Of 2^k points, each elementary box of
/// area 2^-k contains one.
[[nodiscard]] glm::dvec2 even_sample(std::uint32_t n, std::uint32_t dimension, std::uint32_t seed);

}  // namespace tedavis::raytrace
