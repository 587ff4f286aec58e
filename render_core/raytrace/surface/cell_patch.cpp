#include "render_core/raytrace/surface/cell_patch.hpp"

#include <algorithm>

namespace tedavis::raytrace {
namespace {

double kept_between(double z, double a, double b) { return std::clamp(z, std::min(a, b), std::max(a, b)); }

double linear_between(double a, double b, double t) { return kept_between((1 - t) * a + t * b, a, b); }

/// Divided from (1, 0) to (0, 1).
SurfacePoint triangles_at(const double corner[2][2], double u, double v) {
    const bool is_first = u + v <= 1;
    const double at_1_0 = corner[0][1], at_0_1 = corner[1][0];
    SurfacePoint point;
    if (is_first) {
        point.slope_x = at_1_0 - corner[0][0];
        point.slope_y = at_0_1 - corner[0][0];
    } else {
        point.slope_x = corner[1][1] - at_0_1;
        point.slope_y = corner[1][1] - at_1_0;
    }
    const double third = corner[is_first ? 0 : 1][is_first ? 0 : 1];
    const double of_1_0 = is_first ? u : 1 - v, of_0_1 = is_first ? v : 1 - u;
    // Along each side of the cell these are exactly what its neighbour has.
    const double of_third = is_first ? 1 - u - v : (u >= v ? v - (1 - u) : u - (1 - v));
    point.height = of_1_0 * at_1_0 + of_0_1 * at_0_1 + of_third * third;
    point.height = std::clamp(point.height, std::min({at_1_0, at_0_1, third}), std::max({at_1_0, at_0_1, third}));
    return point;
}

SurfacePoint approximation_at(const CellPatch& patch, double u, double v) {
    const double parts = patch.subdivisions;
    const auto part_of = [&](double t) { return std::min(static_cast<std::uint32_t>(t * parts), patch.subdivisions - 1); };
    const std::uint32_t i = part_of(u), j = part_of(v);
    const double corner[2][2] = {{patch.small_post(i, j), patch.small_post(i + 1, j)},
                                 {patch.small_post(i, j + 1), patch.small_post(i + 1, j + 1)}};
    SurfacePoint point = bilinear_at(corner, std::min(u * parts - i, 1.0), std::min(v * parts - j, 1.0));
    point.slope_x *= parts;
    point.slope_y *= parts;
    return point;
}

}  // namespace

SurfacePoint bilinear_at(const double corner[2][2], double u, double v) {
    const double upper = linear_between(corner[0][0], corner[0][1], u), lower = linear_between(corner[1][0], corner[1][1], u);
    return {linear_between(upper, lower, v), (1 - v) * (corner[0][1] - corner[0][0]) + v * (corner[1][1] - corner[1][0]),
            (1 - u) * (corner[1][0] - corner[0][0]) + u * (corner[1][1] - corner[0][1])};
}

SurfacePoint CellPatch::at(double u, double v) const {
    switch (kind) {
        case SurfaceKind::two_triangles: return triangles_at(corner, u, v);
        case SurfaceKind::bilinear: return bilinear_at(corner, u, v);
        case SurfaceKind::bicubic: return cubic.at(u, v);
        case SurfaceKind::approximate_bicubic: break;
    }
    return approximation_at(*this, u, v);
}

double CellPatch::small_post(std::uint32_t column, std::uint32_t row) const {
    const double parts = subdivisions;
    return cubic.at(column / parts, row / parts).height;
}

HeightRange CellPatch::range() const {
    const bool by_control = is_cubic(kind);
    const double* const first = by_control ? &cubic.control[0][0] : &corner[0][0];
    const auto [lowest, highest] = std::minmax_element(first, first + (by_control ? 16 : 4));
    const double scale = by_control ? kControlScale : 1;
    return {*lowest / scale, *highest / scale};
}

template <class Height>
CellPatch cell_patch(const HeightGrid<Height>& grid, const SurfaceSettings& settings, std::uint32_t column, std::uint32_t row) {
    CellPatch patch;
    patch.kind = settings.kind;
    patch.subdivisions = std::clamp(settings.subdivisions, 1u, SurfaceSettings::kMaxSubdivisions);
    if (is_cubic(settings.kind)) {
        const PatchPosts posts = patch_posts(grid, column, row);
        patch.has_surface = posts.has_surface;
        if (posts.has_surface) patch.cubic = bicubic_patch(posts);
        return patch;
    }
    patch.has_surface = true;
    for (std::uint32_t j = 0; j < 2; ++j)
        for (std::uint32_t i = 0; i < 2; ++i) {
            const Height height = grid.at(column + i, row + j);
            patch.has_surface = patch.has_surface && height != HeightGrid<Height>::kVoid;
            patch.corner[j][i] = static_cast<double>(height);
        }
    return patch;
}

template CellPatch cell_patch(const HeightGrid<std::int16_t>&, const SurfaceSettings&, std::uint32_t, std::uint32_t);
template CellPatch cell_patch(const HeightGrid<float>&, const SurfaceSettings&, std::uint32_t, std::uint32_t);

}  // namespace tedavis::raytrace
