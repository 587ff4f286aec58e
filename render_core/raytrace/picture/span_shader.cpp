#include "render_core/raytrace/picture/span_shader.hpp"

#include <algorithm>

#include "render_core/raytrace/picture/lit_terrain.hpp"
#include "render_core/raytrace/surface/pixel_footprint.hpp"

namespace tedavis::raytrace {
namespace {

SurfacePoint point_of(const SpanSurface& surface, std::uint32_t n) {
    return {surface.height[n], surface.slope_x[n], surface.slope_y[n]};
}

glm::dvec3 in_metres(const glm::dvec3& v, const GridScale& scale) {
    return {v.x * scale.column_m, v.y * scale.row_m, v.z * scale.height_m};
}

}  // namespace

Ray SpanRays::ray(std::uint32_t n) const {
    Ray ray;
    ray.origin = origins == nullptr ? origin : origins[n];
    ray.direction = {direction[0][n], direction[1][n], direction[2][n]};
    return ray;
}

template <class Height>
double SpanShader<Height>::footprint(float t) const {
    return footprint_posts(t, pixel_width_m, maps.scale);
}

template <class Height>
void SpanShader<Height>::average_slopes(SpanSurface& surface) const {
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const double covered = footprint(surface.t[n]);
        SurfacePoint point;
        if (!surface.is_hit[n] || covered < 1 || !maps.averages->find_surface(surface.x[n], surface.y[n], covered, point))
            continue;
        surface.slope_x[n] = static_cast<float>(point.slope_x);
        surface.slope_y[n] = static_cast<float>(point.slope_y);
    }
}

template <class Height>
void SpanShader<Height>::cover_with_data(const SpanSurface& surface, SpanLight& light) const {
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        if (!surface.is_hit[n]) continue;
        const DataColor data = data_color(look->values, look->uncertainties, look->legend, surface.x[n], surface.y[n]);
        for (int c = 0; c < 3; ++c) light.color[c][n] += data.cover * (data.color[c] - light.color[c][n]);
    }
}

template <class Height>
void SpanShader<Height>::cast_shadows(const SpanSurface& surface, SpanLight& light) const {
    const OcclusionTest test = {
        [](const void* asked, const Ray& ray) { return static_cast<const TracedTerrain*>(asked)->is_hidden(ray); }, terrain};
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        if (!surface.is_hit[n] || light.sun_seen[n] <= 0) continue;
        const bool is_dark =
            is_in_shadow(surface.x[n], surface.y[n], point_of(surface, n), look->sun.towards, maps.scale, test, {});
        if (is_dark) light.sun_seen[n] = 0;
    }
}

template <class Height>
void SpanShader<Height>::draw_capsules(const SpanRays& rays, const SpanSurface& surface, glm::vec3* light) const {
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        const Ray ray = rays.ray(n);
        const glm::dvec3 origin = in_metres(ray.origin, maps.scale), direction = in_metres(ray.direction, maps.scale);
        CapsuleHit nearest;
        nearest.t = surface.is_hit[n] ? double{surface.t[n]} : std::numeric_limits<double>::infinity();
        for (const Capsule& capsule : look->capsules) {
            const CapsuleHit hit = ray_capsule(origin, direction, 0, capsule);
            if (hit.is_hit && hit.t < nearest.t) nearest = hit;
        }
        if (!nearest.is_hit) continue;
        Material material;
        material.color = look->capsule_color;
        light[n] = local_light(material, nearest.normal, -glm::normalize(direction), look->sun, 1, look->sky, 1);
    }
}

template <class Height>
void SpanShader<Height>::follow_paths(const SpanRays& rays, const std::uint32_t* seeds, const SpanSurface& surface,
                                      glm::vec3* light) const {
    const LitTerrain lit = {terrain, look, maps.scale};
    const TracedLight bounced = {settings->bounces, settings->paths};
    for (std::uint32_t n = 0; n < surface.count; ++n) {
        if (!surface.is_hit[n]) continue;
        const Ray ray = rays.ray(n);
        light[n] =
            traced_light(lit.scene(), in_metres(ray.origin, maps.scale), in_metres(ray.direction, maps.scale), bounced, seeds[n]);
    }
}

template <class Height>
void SpanShader<Height>::shade(const SpanRays& rays, const std::uint32_t* seeds, SpanSurface& surface, glm::vec3* light) const {
    if (std::none_of(surface.is_hit, surface.is_hit + surface.count, [](bool is_hit) { return is_hit; })) {
        std::fill_n(light, surface.count, look->background);
        if (settings->has_capsules) draw_capsules(rays, surface, light);
        return;
    }
    if (settings->antialiasing == Antialiasing::average_mipmap && pixel_width_m > 0) average_slopes(surface);
    SpanLight all;
    std::fill_n(all.sun_seen, surface.count, 1.0f);
    std::fill_n(all.sky_seen, surface.count, 1.0f);
    find_colors(surface, *look, all.color);
    if (settings->has_data) cover_with_data(surface, all);
    if (settings->shading != Shading::none) {
        find_normals(surface, maps.scale, all.normal);
        if (settings->ambient != Ambient::none) find_sky(surface, *maps.sky, settings->ambient, look->sun.towards, all);
        if (settings->has_shadows) cast_shadows(surface, all);
    }
    if (settings->shading == Shading::phong)
        find_eyes(rays.direction[0], rays.direction[1], rays.direction[2], surface.count, maps.scale, all.eye);
    add_up_light(settings->shading, *look, surface.count, all);
    for (std::uint32_t n = 0; n < surface.count; ++n)
        light[n] = surface.is_hit[n] ? glm::vec3(all.light[0][n], all.light[1][n], all.light[2][n]) : look->background;
    if (settings->paths > 0) follow_paths(rays, seeds, surface, light);
    if (settings->has_capsules) draw_capsules(rays, surface, light);
}

template <class Height>
float SpanShader<Height>::mirror_of(const SpanSurface& surface, std::uint32_t n) const {
    return surface.is_hit[n] && surface.height[n] <= look->mirror_below ? look->material.mirror : 0;
}

template <class Height>
Ray SpanShader<Height>::mirrored(const SpanRays& rays, const SpanSurface& surface, std::uint32_t n) const {
    const SurfacePoint point = point_of(surface, n);
    const glm::dvec3 normal = normal_of(point, maps.scale), direction = in_metres(rays.ray(n).direction, maps.scale);
    const glm::dvec3 sent = direction - 2 * glm::dot(direction, normal) * normal;
    return ray_from_surface(surface.x[n], surface.y[n], point, in_grid_space(sent, maps.scale), {});
}

template struct SpanShader<std::int16_t>;
template struct SpanShader<float>;

}  // namespace tedavis::raytrace
