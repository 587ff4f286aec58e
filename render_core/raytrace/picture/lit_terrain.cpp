#include "render_core/raytrace/picture/lit_terrain.hpp"

#include "render_core/raytrace/picture/span_light.hpp"

namespace tedavis::raytrace {
namespace {

Ray ray_in_grid(const GridScale& scale, const glm::dvec3& origin_m, const glm::dvec3& direction_m) {
    Ray ray;
    ray.origin = in_grid_space(origin_m, scale);
    ray.direction = in_grid_space(direction_m, scale);
    return ray;
}

LitPlace lit_place(const void* asked, const glm::dvec3& origin, const glm::dvec3& direction) {
    const LitTerrain& lit = *static_cast<const LitTerrain*>(asked);
    const RayHit hit = lit.terrain->intersect(ray_in_grid(lit.scale, origin, direction));
    LitPlace place;
    place.is_hit = hit.is_hit;
    if (!hit.is_hit) return place;
    place.normal = normal_of(hit.point, lit.scale);
    const glm::dvec3 start = ray_from_surface(hit.x, hit.y, hit.point, {0, 0, 1}, {}).origin;
    place.point = {start.x * lit.scale.column_m, start.y * lit.scale.row_m, start.z * lit.scale.height_m};
    SpanSurface surface;
    surface.count = 1;
    surface.height[0] = static_cast<float>(hit.point.height);
    float color[3][PixelSpan::kMax];
    find_colors(surface, *lit.look, color);
    place.material = lit.look->material;
    place.material.color = {color[0][0], color[1][0], color[2][0]};
    if (surface.height[0] > lit.look->mirror_below) place.material.mirror = 0;
    return place;
}

bool is_light_hidden(const void* asked, const glm::dvec3& origin, const glm::dvec3& direction) {
    const LitTerrain& lit = *static_cast<const LitTerrain*>(asked);
    return lit.terrain->is_hidden(ray_in_grid(lit.scale, origin, direction));
}

}  // namespace

LitScene LitTerrain::scene() const {
    LitScene made;
    made.intersect = lit_place;
    made.is_hidden = is_light_hidden;
    made.context = this;
    made.sun = look->sun;
    made.sky = look->sky;
    return made;
}

}  // namespace tedavis::raytrace
