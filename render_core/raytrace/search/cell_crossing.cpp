#include "render_core/raytrace/search/cell_crossing.hpp"

#include <cmath>

#include "render_core/raytrace/search/bicubic_crossing.hpp"
#include "render_core/raytrace/search/stepwise_crossing.hpp"

namespace tedavis::raytrace {
namespace {

double gap_at(const CellPatch& patch, const RayPoint& point) { return point.z - patch.at(point.place.u, point.place.v).height; }

/// What follows looks for the first place with sign * gap <= 0.

/// Of heights between four posts, which the stretch lies over.
Crossing bilinear_crossing(const double corner[2][2], const RayPoint& from, const RayPoint& to, double sign) {
    const double g0 = from.z - bilinear_at(corner, from.place.u, from.place.v).height;
    const double g1 = to.z - bilinear_at(corner, to.place.u, to.place.v).height;
    const double twist = (corner[0][0] - corner[0][1]) + (corner[1][1] - corner[1][0]);
    const double a = -twist * (to.place.u - from.place.u) * (to.place.v - from.place.v);
    return first_root(sign * g0, sign * g1, sign * a);
}

Crossing linear_crossing(double g0, double g1) {
    if (g0 <= 0) return {true, false, 0};
    if (g1 > 0) return {};
    return {true, false, g0 / (g0 - g1)};
}

/// The two halves of a cell are planes; between them the stretch crosses the diagonal.
Crossing triangles_crossing(const CellPatch& patch, const CellRay& ray, double sign) {
    const double g0 = sign * gap_at(patch, ray.from), g1 = sign * gap_at(patch, ray.to);
    const double d0 = ray.from.place.u + ray.from.place.v - 1, d1 = ray.to.place.u + ray.to.place.v - 1;
    if ((d0 < 0) == (d1 < 0)) return linear_crossing(g0, g1);
    const double s = std::clamp(d0 / (d0 - d1), 0.0, 1.0);
    const RayPoint middle = ray.at(s);
    const double u = middle.place.u;
    const double at_middle = sign * (middle.z - ((1 - u) * patch.corner[1][0] + u * patch.corner[0][1]));
    Crossing found = linear_crossing(g0, at_middle);
    if (found.is_hit) {
        found.s *= s;
        return found;
    }
    found = linear_crossing(at_middle, g1);
    found.s = s + (1 - s) * found.s;
    return found;
}

/// Where the stretch next leaves a small cell of the approximation.
double leaves_at(double from, double to, std::uint32_t part, double parts) {
    if (from == to) return 1;
    const double border = (to > from ? part + 1.0 : part) / parts;
    return (border - from) / (to - from);
}

Crossing approximation_crossing(const CellPatch& patch, const CellRay& ray, double sign) {
    const double parts = patch.subdivisions;
    const auto part_of = [&](double t, bool is_back) {
        const double part = is_back ? std::ceil(t * parts) - 1 : std::floor(t * parts);
        return static_cast<std::uint32_t>(std::clamp(part, 0.0, parts - 1));
    };
    const bool is_left = ray.to.place.u < ray.from.place.u, is_up = ray.to.place.v < ray.from.place.v;
    std::uint32_t i = part_of(ray.from.place.u, is_left), j = part_of(ray.from.place.v, is_up);
    double s = 0;
    for (std::uint32_t step = 0; step < 2 * patch.subdivisions; ++step) {
        const double across = leaves_at(ray.from.place.u, ray.to.place.u, i, parts);
        const double down = leaves_at(ray.from.place.v, ray.to.place.v, j, parts);
        const double end = std::clamp(std::min(across, down), s, 1.0);
        const double corner[2][2] = {{patch.small_post(i, j), patch.small_post(i + 1, j)},
                                     {patch.small_post(i, j + 1), patch.small_post(i + 1, j + 1)}};
        RayPoint from = ray.at(s), to = ray.at(end);
        for (RayPoint* point : {&from, &to}) {
            point->place.u = std::clamp(point->place.u * parts - i, 0.0, 1.0);
            point->place.v = std::clamp(point->place.v * parts - j, 0.0, 1.0);
        }
        Crossing found = bilinear_crossing(corner, from, to, sign);
        if (found.is_hit) {
            found.s = s + found.s * (end - s);
            return found;
        }
        const std::uint32_t next_i = is_left ? i - 1 : i + 1, next_j = is_up ? j - 1 : j + 1;
        const bool goes_across = across <= down;
        if (end >= 1 || (goes_across ? next_i : next_j) >= patch.subdivisions) break;
        (goes_across ? i : j) = goes_across ? next_i : next_j;
        s = end;
    }
    return {};
}

Crossing crossing_between(const CellPatch& patch, const CellRay& ray, double sign) {
    switch (patch.kind) {
        case SurfaceKind::two_triangles: return triangles_crossing(patch, ray, sign);
        case SurfaceKind::bilinear: return bilinear_crossing(patch.corner, ray.from, ray.to, sign);
        case SurfaceKind::bicubic: return bicubic_crossing(patch.cubic, ray, sign);
        case SurfaceKind::approximate_bicubic: break;
    }
    return approximation_crossing(patch, ray, sign);
}

}  // namespace

Crossing first_root(double g0, double g1, double a) {
    Crossing found;
    if (g0 <= 0) {
        found.is_hit = true;
        return found;
    }
    const double b = (g1 - g0) - a;
    if (g1 > 0) {
        // Above at both ends: only a curve that comes down and turns between them can meet zero.
        const bool turns = a > 0 && b < 0 && -b < 2 * a;
        if (!turns || g0 - b * b / (4 * a) > 0) return found;
    }
    found.is_hit = true;
    const double root = std::sqrt(std::max(b * b - 4 * a * g0, 0.0));
    const double s = b <= 0 ? 2 * g0 / (-b + root) : -(b + root) / (2 * a);
    found.s = s > 0 ? std::min(s, 1.0) : (s <= 0 ? 0.0 : 1.0);  // what is no number: at the end
    return found;
}

Crossing first_crossing(const CellPatch& patch, const MicroStructure& micro, const CellRay& ray) {
    if (micro.kind != MicroKind::none) return stepwise_crossing(patch, micro, ray);
    const double g0 = gap_at(patch, ray.from), g1 = gap_at(patch, ray.to);
    const bool is_below = g0 < 0;
    Crossing found = g0 == 0 ? Crossing{true, false, 0} : crossing_between(patch, ray, is_below ? -1 : 1);
    // The ends decide, whatever rounding makes of the way between them.
    if (!found.is_hit && (is_below ? g1 >= 0 : g1 <= 0)) found = {true, false, 1};
    found.is_from_below = is_below;
    return found;
}

}  // namespace tedavis::raytrace
