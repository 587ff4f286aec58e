#include "render_core/raytrace/shading/traced_light.hpp"

#include <cmath>
#include <initializer_list>

#include "render_core/base/check.hpp"
#include "render_core/raytrace/shading/arc_functions.hpp"

namespace tedavis::raytrace {
namespace {

std::uint32_t stirred_seed(std::uint32_t bits) {
    bits = (bits ^ (bits >> 16)) * 0x7feb352du;
    bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

std::uint32_t reversed_bits(std::uint32_t bits) {
    bits = (bits << 16) | (bits >> 16);
    bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
    bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
    return ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
}

/// Each bit is turned over or not by those above it (Owen); even factors only carry upwards (Laine and Karras 2011).
std::uint32_t scrambled(std::uint32_t bits, std::uint32_t seed) {
    std::uint32_t x = reversed_bits(bits) + seed;
    for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) x ^= x * factor;
    return reversed_bits(x);
}

std::uint32_t sobol_second(std::uint32_t n) {
    std::uint32_t sum = 0;
    for (std::uint32_t column = 0x80000000u; n != 0; n >>= 1, column ^= column >> 1)
        if ((n & 1) != 0) sum ^= column;
    return sum;
}

double unit_of_bits(std::uint32_t bits) { return bits * 0x1p-32; }

glm::dvec3 mirrored(const glm::dvec3& direction, const glm::dvec3& normal) {
    return direction - 2 * glm::dot(direction, normal) * normal;
}

glm::vec3 path_light(const LitScene& scene, glm::dvec3 origin, glm::dvec3 direction, const TracedLight& settings,
                     std::uint32_t path, std::uint32_t seed) {
    glm::vec3 light(0), kept(1);
    bool is_seen_by_mirror = true;  // the eye's own ray sees the highlight as a mirror does
    for (std::uint32_t bounce = 0;; ++bounce) {
        const LitPlace place = scene.intersect(scene.context, origin, direction);
        if (!place.is_hit) return light + kept * scene.sky;
        const Material& material = place.material;
        const bool is_lit =
            glm::dot(place.normal, scene.sun.towards) > 0 && !scene.is_hidden(scene.context, place.point, scene.sun.towards);
        if (is_lit) {
            Material seen = material;
            seen.color *= 1 - material.mirror;
            seen.gloss *= is_seen_by_mirror ? 1.0f : 0.0f;  // a diffuse ray spreads highlights until they are gone
            light += kept * local_light(seen, place.normal, -direction, scene.sun, 1, glm::vec3(0), 0);
        }
        if (bounce == settings.bounces) return light;
        const double choice = even_sample(path, 2 * bounce, seed).x;
        is_seen_by_mirror = choice < double{material.mirror};
        if (is_seen_by_mirror) {
            direction = mirrored(direction, place.normal);
        } else {
            const glm::dvec2 spread = even_sample(path, 2 * bounce + 1, seed);
            direction = cosine_direction(place.normal, spread.x, spread.y);
            kept *= material.color;
        }
        origin = place.point;
    }
}

}  // namespace

glm::dvec2 even_sample(std::uint32_t n, std::uint32_t dimension, std::uint32_t seed) {
    const std::uint32_t own = stirred_seed(seed * 0x9e3779b9u + stirred_seed(dimension + 1));
    const std::uint32_t place = scrambled(n, own);  // another order, in which whole blocks stay together
    return {unit_of_bits(scrambled(reversed_bits(place), stirred_seed(own ^ 0x85ebca6bu))),
            unit_of_bits(scrambled(sobol_second(place), stirred_seed(own ^ 0xc2b2ae35u)))};
}

glm::dvec3 cosine_direction(const glm::dvec3& normal, double u, double v) {
    const double radius = std::sqrt(u);
    const glm::dvec2 turned = radius * direction_of_angle(2 * kArcPi * v - kArcPi);
    // Two vectors across the normal, without a branch that could make them short (Duff et al. 2017).
    const double sign = normal.z < 0 ? -1 : 1, a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
    const glm::dvec3 across(1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    const glm::dvec3 down(b, sign + normal.y * normal.y * a, -normal.y);
    return glm::normalize(turned.x * across + turned.y * down + std::sqrt(1 - u) * normal);
}

glm::vec3 traced_light(const LitScene& scene, const glm::dvec3& origin, const glm::dvec3& direction, const TracedLight& settings,
                       std::uint32_t seed) {
    TEDAVIS_CHECK(settings.paths > 0 && settings.bounces <= TracedLight::kMaxBounces);
    glm::vec3 sum(0);
    for (std::uint32_t n = 0; n < settings.paths; ++n)
        sum += path_light(scene, origin, glm::normalize(direction), settings, n, seed);
    return sum / static_cast<float>(settings.paths);
}

}  // namespace tedavis::raytrace
