/// Light by following rays on from where they meet something: mirrors, and diffuse light of several bounces (Whitted 1980; Kajiya
/// 1986). The most exact and most expensive way to shade.
///
/// A path goes on as a loop, not as a recursion: what is met adds its light, weighed by what the path has kept so far, then the
/// path goes on in one direction. Mirrors and diffuse bounces are chosen between by how much of each the material reflects;
/// diffuse directions are spread by the cosine. Choices come from a sequence that covers evenly (Sobol's first two dimensions,
/// scrambled and put in another order for each bounce and pixel: Owen 1995; Burley 2020): the same picture every time and
/// everywhere.
///
/// What is inexact: light after the last bounce is left out, so that few bounces are too dark in valleys; few paths are noisy.
/// Light comes from an even sky and one directed light, which is asked for by a shadow ray at every bounce.
///
/// Pure apart from the two functions that it is given; any thread; bounces rays and as many shadow rays at most.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/raytrace/shading/local_light.hpp"

namespace tedavis::raytrace {

/// What a ray met; directions in metres.
struct LitPlace {
    bool is_met = false;
    glm::dvec3 point{0};  ///< from where rays go on, lifted off the surface (cast_shadow.hpp)
    glm::dvec3 normal{0, 0, 1};
    Material material;
};

/// The scene, as the caller has it. Points and directions are in one frame in metres.
struct LitScene {
    LitPlace (*meet)(const void* context, const glm::dvec3& origin, const glm::dvec3& direction) = nullptr;
    bool (*is_hidden)(const void* context, const glm::dvec3& origin, const glm::dvec3& direction) = nullptr;
    const void* context = nullptr;
    DirectedLight sun;
    glm::vec3 sky{1};  ///< radiance of all that rays meet where they meet nothing
};

struct TracedLight {
    static constexpr std::uint32_t kMaxBounces = 16;

    std::uint32_t bounces = 3;  ///< rays after the first, 0..kMaxBounces
    std::uint32_t paths = 16;   ///< for each pixel, 1 or more
};

/// Light that comes along a ray; mean of all paths. `seed` says which pixel.
[[nodiscard]] glm::vec3 traced_light(const LitScene& scene, const glm::dvec3& origin, const glm::dvec3& direction,
                                     const TracedLight& settings, std::uint32_t seed);

/// A unit vector about a normal, spread by the cosine, from two numbers of 0..1.
[[nodiscard]] glm::dvec3 cosine_direction(const glm::dvec3& normal, double u, double v);

/// Point n of the sequence for a seed and a place in the path: 0..1 each, 1 left out. Of 2^k points each of 2^k equal boxes,
/// however long or wide, has one.
[[nodiscard]] glm::dvec2 even_sample(std::uint32_t n, std::uint32_t dimension, std::uint32_t seed);

}  // namespace tedavis::raytrace
