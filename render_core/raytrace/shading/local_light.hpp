/// Local illumination: material colour, Lambert's diffuse and Phong's glossy part (Lambert 1760; Phong 1975).
///
/// Colours are linear; all vectors are unit vectors in a frame in metres. Pure; of the C library only sqrt is used.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace tedavis::raytrace {

struct Material {
    glm::vec3 color{0.5f};         ///< reflectance of each colour, 0..1
    float gloss = 0;               ///< share of Phong's highlight, 0..1
    std::uint32_t sharpness = 16;  ///< exponent of the highlight, 1..65536
    float mirror = 0;              ///< share of light that it reflects as a mirror, 0..1; only in traced_light.hpp
};

struct DirectedLight {
    glm::dvec3 towards{0, 0, 1};  ///< unit vector towards the light
    glm::vec3 radiance{1};        ///< linear; what a white surface that faces the light reflects
};

/// Cosine between normal and light, 0 where the light is behind the surface.
[[nodiscard]] inline double lambert(const glm::dvec3& normal, const glm::dvec3& towards_light) {
    return std::max(0.0, glm::dot(normal, towards_light));
}

/// x to an integer power, by squarings: equal on every machine.
[[nodiscard]] inline double whole_power(double x, std::uint32_t exponent) {
    double power = 1;
    for (; exponent != 0; exponent >>= 1, x *= x)
        if ((exponent & 1) != 0) power *= x;
    return power;
}

/// Phong's term; 0 where the light is behind the surface, or its reflection points away from the eye.
[[nodiscard]] inline double phong(const glm::dvec3& normal, const glm::dvec3& towards_light, const glm::dvec3& towards_eye,
                                  std::uint32_t sharpness) {
    const double cosine = glm::dot(normal, towards_light);
    if (cosine <= 0) return 0;
    const double along = glm::dot(2 * cosine * normal - towards_light, towards_eye);
    return along <= 0 ? 0 : whole_power(std::min(along, 1.0), sharpness);
}

/// Returns the reflected light of a uniform sky (`sky` times its visible share, 0..1) and of the directed light (times its
/// visible share, 0..1).
[[nodiscard]] inline glm::vec3 local_light(const Material& material, const glm::dvec3& normal, const glm::dvec3& towards_eye,
                                           const DirectedLight& light, double light_seen, const glm::vec3& sky, double sky_seen) {
    const auto diffuse = static_cast<float>(light_seen * lambert(normal, light.towards));
    const auto highlight = static_cast<float>(light_seen * phong(normal, light.towards, towards_eye, material.sharpness));
    return material.color * (sky * static_cast<float>(sky_seen) + light.radiance * diffuse) +
           light.radiance * (material.gloss * highlight);
}

}  // namespace tedavis::raytrace
