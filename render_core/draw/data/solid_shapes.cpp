#include "render_core/draw/data/solid_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

constexpr int kMeridians = 10, kParallels = 6;  // of ellipsoids: rings between the poles are one less

}  // namespace

void add_frustum(SolidMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, double from_radius_m, double to_radius_m,
                 int sides, const glm::dvec3& across) {
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    const glm::dvec3 side = glm::cross(way, across);
    if (!(length > 0) || !(glm::length(side) > 0)) return;
    const int count = std::clamp(sides, 3, kMaxShapeSides);
    const glm::dvec3 y = side / glm::length(side), x = glm::cross(y, way / length);
    glm::dvec3 ring[kMaxShapeSides];
    for (int n = 0; n < count; ++n) {
        const double angle = 2 * base::kPi * n / count;
        ring[n] = x * std::cos(angle) + y * std::sin(angle);
    }
    std::uint16_t low[kMaxShapeSides], high[kMaxShapeSides];
    for (int n = 0; n < count; ++n) {
        low[n] = mesh.vertex(from + ring[n] * from_radius_m, ring[n]);
        high[n] = mesh.vertex(to + ring[n] * to_radius_m, ring[n]);
    }
    for (int n = 0; n < count; ++n) {
        const int next = (n + 1) % count;
        mesh.triangle(low[n], low[next], high[n]);
        if (to_radius_m > 0) mesh.triangle(low[next], high[next], high[n]);
    }
    for (const bool is_top : {false, true}) {
        const double radius = is_top ? to_radius_m : from_radius_m;
        if (!(radius > 0)) continue;
        const glm::dvec3 normal = is_top ? way / length : -way / length;
        std::uint16_t corners[kMaxShapeSides];
        for (int n = 0; n < count; ++n) corners[n] = mesh.vertex((is_top ? to : from) + ring[n] * radius, normal);
        for (int n = 1; n + 1 < count; ++n) mesh.triangle(corners[0], corners[is_top ? n : n + 1], corners[is_top ? n + 1 : n]);
    }
}

void add_box(SolidMesh& mesh, const glm::dvec3& middle, const glm::dvec3& half_x, const glm::dvec3& half_y,
             const glm::dvec3& half_z) {
    const glm::dvec3 axes[3] = {half_x, half_y, half_z};
    for (int n = 0; n < 3; ++n) {
        const glm::dvec3 &out = axes[n], &u = axes[(n + 1) % 3], &v = axes[(n + 2) % 3];
        mesh.quad(middle + out - u - v, middle + out + u - v, middle + out + u + v, middle + out - u + v);
        mesh.quad(middle - out - u - v, middle - out - u + v, middle - out + u + v, middle - out + u - v);
    }
}

void add_ellipsoid(SolidMesh& mesh, const glm::dvec3& middle, const LocalAxes& axes, double level_m, double upright_m) {
    const auto vertex = [&](double elevation, double turn) {
        const double c = std::cos(elevation), s = std::sin(elevation);
        const glm::dvec3 level = axes.east * std::cos(turn) + axes.north * std::sin(turn);
        const glm::dvec3 normal = glm::normalize(level * (c / level_m) + axes.up * (s / upright_m));
        return mesh.vertex(middle + level * (c * level_m) + axes.up * (s * upright_m), normal);
    };
    if (!(level_m > 0) || !(upright_m > 0)) return;
    const std::uint16_t bottom = vertex(-base::kPi / 2, 0), top = vertex(base::kPi / 2, 0);
    const auto first = static_cast<std::uint16_t>(mesh.vertex_count());
    for (int ring = 1; ring < kParallels; ++ring)
        for (int n = 0; n < kMeridians; ++n)
            static_cast<void>(vertex(base::kPi * (static_cast<double>(ring) / kParallels - 0.5), 2 * base::kPi * n / kMeridians));
    const auto at = [&](int ring, int n) { return static_cast<std::uint16_t>(first + (ring - 1) * kMeridians + n % kMeridians); };
    for (int n = 0; n < kMeridians; ++n) {
        mesh.triangle(bottom, at(1, n + 1), at(1, n));
        mesh.triangle(top, at(kParallels - 1, n), at(kParallels - 1, n + 1));
        for (int ring = 1; ring + 1 < kParallels; ++ring) {
            mesh.triangle(at(ring, n), at(ring, n + 1), at(ring + 1, n + 1));
            mesh.triangle(at(ring, n), at(ring + 1, n + 1), at(ring + 1, n));
        }
    }
}

}  // namespace tedavis::draw
